/* The simple face where the scan of an outer shell starts holds the component's highest point. The check: an arc of a
 * great circle, from a point just left of one of the face's edges to the highest point, crosses the face's loop an even
 * number of times; or the loop goes through the highest point itself. */
#include <math.h>

#include "topology_invariants.h"
#include "vectors.h"

/* An edge on the unit sphere about its ball's centre: centre + cos(turn) start + sin(turn) quarter, 0 <= turn <= angle.
 */
typedef struct unit_edge {
  double centre[3], start[3], quarter[3], axis[3], angle, radius;
} unit_edge;

static void unit_edge_of(const topology_result *t, uint32_t ball, const hsp_topology_edge *edge, unit_edge *unit) {
  const double r = t->base->radius[ball];
  const double *from = t->vertices[edge->vertex[0]].xyz;
  int k;
  for (k = 0; k < 3; ++k) {
    unit->centre[k] = (edge->centre[k] - t->base->xyz[3 * ball + (uint32_t)k]) / r;
    unit->start[k] = (from[k] - edge->centre[k]) / r;
    unit->axis[k] = edge->axis[k];
  }
  cross(edge->axis, unit->start, unit->quarter);
  unit->angle = edge->angle;
  unit->radius = edge->radius / r;
}

static void point_of_edge(const unit_edge *edge, double turn, double point[3]) {
  int k;
  for (k = 0; k < 3; ++k) point[k] = edge->centre[k] + cos(turn) * edge->start[k] + sin(turn) * edge->quarter[k];
}

enum { UNSURE = -1 };

/* How often the arc of the great circle from `from` to `to`, less than half of it, crosses the edge. */
static int crossings(const unit_edge *edge, const double from[3], const double to[3]) {
  double normal[3], a, b, c, size, middle, spread;
  int count = 0, k;
  cross(from, to, normal);
  a = dot(normal, edge->start);
  b = dot(normal, edge->quarter);
  c = -dot(normal, edge->centre);
  size = sqrt(a * a + b * b);
  /* a cos(turn) + b sin(turn) = c */
  if (fabs(fabs(c) - size) < 1e-6) return UNSURE;
  if (fabs(c) > size) return 0;
  middle = atan2(b, a);
  spread = acos(c / size);
  for (k = 0; k < 2; ++k) {
    double turn = k == 0 ? middle - spread : middle + spread, point[3], w[3], after, before;
    while (turn < 0) turn += 2 * pi;
    while (turn >= 2 * pi) turn -= 2 * pi;
    point_of_edge(edge, turn, point);
    cross(from, point, w);
    after = dot(w, normal);
    cross(point, to, w);
    before = dot(w, normal);
    if (after < -1e-6 || before < -1e-6) continue;
    if (turn > edge->angle + 1e-6 && turn < 2 * pi - 1e-6) continue;
    if (after < 1e-6 || before < 1e-6 || turn < 1e-6 || turn > edge->angle - 1e-6) return UNSURE;
    ++count;
  }
  return count;
}

/* 1: the face contains the highest point of its sphere; 0: it does not; UNSURE: undecided, as seen from this edge. */
static int holds_top(const topology_result *t, uint32_t face, uint32_t from_q) {
  static const double top[3] = {0, 0, 1};
  const uint32_t ball = t->faces[face].ball;
  unit_edge edge;
  double inside[3], middle[3], size = 0;
  uint32_t q = from_q;
  int sum = 0, k;
  unit_edge_of(t, ball, t->edges + q / 4, &edge);
  if (edge.radius < 1e-2 || edge.angle < 1e-2) return UNSURE;
  point_of_edge(&edge, 0.47 * edge.angle, middle);
  for (k = 0; k < 3; ++k) {
    inside[k] = middle[k] + (q % 4 == 0 ? 1e-4 : -1e-4) * edge.axis[k];
    size += inside[k] * inside[k];
  }
  for (k = 0; k < 3; ++k) inside[k] /= sqrt(size);
  if (fabs(inside[2]) > 1 - 1e-6) return UNSURE;
  do {
    int crossed;
    unit_edge_of(t, ball, t->edges + q / 4, &edge);
    crossed = crossings(&edge, inside, top);
    if (crossed == UNSURE) return UNSURE;
    sum += crossed;
    q = hsp_topology_lnext(t->topology, q);
  } while (q != from_q);
  return sum % 2 == 0;
}

/* The loop itself goes through the highest point, or close by. */
static int touches_top(const topology_result *t, uint32_t face) {
  const uint32_t ball = t->faces[face].ball;
  uint32_t q = t->faces[face].q;
  do {
    unit_edge edge;
    double turn, point[3];
    static const double top[3] = {0, 0, 1};
    unit_edge_of(t, ball, t->edges + q / 4, &edge);
    turn = atan2(dot(edge.quarter, top), dot(edge.start, top)); /* the highest point of the circle */
    if (turn < -1e-3) turn += 2 * pi;
    turn = fmin(fmax(turn, 0), edge.angle);
    point_of_edge(&edge, turn, point);
    if (point[2] > 1 - 1e-8) return 1;
    q = hsp_topology_lnext(t->topology, q);
  } while (q != t->faces[face].q);
  return 0;
}

decided_count start_faces_decided;

const char *broken_topology_start_faces(const topology_result *t) {
  uint32_t i;
  for (i = 0; i < t->counts.components; ++i) {
    const uint32_t start = t->shells[t->components[i].outer_shell].start_face;
    const uint32_t ball = t->faces[start].ball;
    uint32_t q = t->faces[start].q;
    int holds = UNSURE;
    if (touches_top(t, start)) continue;
    if (!(position_error(t->base->xyz + 3 * ball) < 1e-9 * t->base->radius[ball])) {
      count_decided(&start_faces_decided, 0);
      continue;
    }
    do {
      holds = holds_top(t, start, q);
      if (holds == 0) return "start_face: does not hold the highest point";
      q = hsp_topology_lnext(t->topology, q);
    } while (holds == UNSURE && q != t->faces[start].q);
    count_decided(&start_faces_decided, holds != UNSURE);
  }
  return NULL;
}
