/* Positions, angles, areas and volumes against their definitions. The tolerances are those of computing the check in
 * double, not of the library: a few hundred roundings relative to the sizes that enter. */
#include <math.h>

#include "boundary_invariants.h"
#include "vectors.h"

static double distance_to_centre(const computed *c, const double xyz[3], uint32_t ball) {
  double v[3];
  difference(xyz, c->xyz + 3 * ball, v);
  return length(v);
}

/* How far a position may be off a sphere: roundings of the largest radius and of the coordinates, and what the
 * lattice moved. */
static double slack(const computed *c, const double xyz[3]) {
  return position_error(xyz) + 1e-14 * c->info.largest_radius + 4 * c->rounding;
}

static int exposed(const computed *c, const double xyz[3], double allowed) {
  uint32_t j;
  for (j = 0; j < c->n; ++j) {
    if (!(distance_to_centre(c, xyz, j) >= c->radius[j] - allowed)) return 0;
  }
  return 1;
}

static const char *broken_vertex_positions(const computed *c) {
  uint32_t i, m;
  for (i = 0; i < c->counts.vertices; ++i) {
    const hsp_vertex *v = c->vertices + i;
    const double allowed = slack(c, v->xyz);
    for (m = 0; m < 3; ++m) {
      const double off = distance_to_centre(c, v->xyz, v->ball[m]) - c->radius[v->ball[m]];
      if (!(fabs(off) <= allowed)) return "vertex: not on its three spheres";
    }
    if (!exposed(c, v->xyz, allowed)) return "vertex: inside a ball";
  }
  return NULL;
}

static const char *broken_vertex_signs(const computed *c) {
  uint32_t i;
  for (i = 0; i < c->counts.vertices; ++i) {
    const hsp_vertex *v = c->vertices + i;
    double ab[3], ac[3], normal[3], w[3], side, allowed;
    difference(c->xyz + 3 * v->ball[1], c->xyz + 3 * v->ball[0], ab);
    difference(c->xyz + 3 * v->ball[2], c->xyz + 3 * v->ball[0], ac);
    difference(v->xyz, c->xyz + 3 * v->ball[0], w);
    cross(ab, ac, normal);
    side = dot(normal, w);
    /* a normal of nearly collinear centres is itself known only as well as the centres, and up to its rounding */
    allowed = length(normal) * slack(c, v->xyz) + 1e-15 * length(ab) * length(ac) * length(w) +
              8 * (c->rounding + position_error(v->xyz)) * (length(ab) + length(ac)) * length(w);
    if (v->sign > 0 ? side < -allowed : side > allowed) return "vertex: on the wrong side for its sign";
  }
  return NULL;
}

/* The part of w across the unit vector u. */
static void across(const double u[3], const double w[3], double part[3]) {
  const double along = dot(u, w);
  int axis;
  for (axis = 0; axis < 3; ++axis) part[axis] = w[axis] - along * u[axis];
}

static const char *broken_arc_angles(const computed *c) {
  uint32_t i;
  int axis;
  for (i = 0; i < c->counts.arcs; ++i) {
    const hsp_arc *arc = c->arcs + i;
    const double *from = c->vertices[arc->vertex[0]].xyz, *to = c->vertices[arc->vertex[1]].xyz;
    double u[3], w[3], start[3], end[3], quarter[3], turned[3], off[3], middle[3], distance, allowed;
    if (!(arc->angle >= 0 && arc->angle <= 2 * pi)) return "arc: angle is not in [0, 2 pi]";
    difference(c->xyz + 3 * arc->ball[1], c->xyz + 3 * arc->ball[0], u);
    distance = length(u);
    for (axis = 0; axis < 3; ++axis) u[axis] /= distance;
    difference(from, c->xyz + 3 * arc->ball[0], w);
    across(u, w, start);
    difference(to, c->xyz + 3 * arc->ball[0], w);
    across(u, w, end);
    cross(u, start, quarter);
    for (axis = 0; axis < 3; ++axis) turned[axis] = cos(arc->angle) * start[axis] + sin(arc->angle) * quarter[axis];
    difference(turned, end, off);
    allowed = 8 * slack(c, from) * (1 + c->radius[arc->ball[0]] / distance);
    if (!(length(off) <= allowed)) return "arc: turning by its angle about the axis does not lead to its end";
    /* the angle is right, not just up to a whole turn */
    for (axis = 0; axis < 3; ++axis) {
      middle[axis] = from[axis] - start[axis] + cos(arc->angle / 2) * start[axis] + sin(arc->angle / 2) * quarter[axis];
    }
    if (!exposed(c, middle, allowed)) return "arc: its middle is inside a ball";
  }
  return NULL;
}

static const char *broken_circle_positions(const computed *c) {
  uint32_t i, e;
  for (i = 0; i < c->counts.circles; ++i) {
    const hsp_circle *circle = c->circles + i;
    const double allowed = 4 * slack(c, circle->centre);
    double u[3], w[3], off[3];
    difference(c->xyz + 3 * circle->ball[1], c->xyz + 3 * circle->ball[0], u);
    if (!(fabs(length(circle->axis) - 1) <= 1e-14)) return "circle: axis is not a unit vector";
    cross(circle->axis, u, off);
    if (!(dot(circle->axis, u) > 0 && length(off) <= 1e-14 * length(u) + 8 * (c->rounding + 1e-16 * c->extent))) {
      return "circle: axis does not point from c_a to c_b";
    }
    if (!(circle->radius >= 0)) return "circle: negative radius";
    for (e = 0; e < 2; ++e) {
      const double r = c->radius[circle->ball[e]];
      double from_centre;
      difference(circle->centre, c->xyz + 3 * circle->ball[e], w);
      from_centre = sqrt(dot(w, w) + circle->radius * circle->radius);
      cross(circle->axis, w, off);
      if (!(length(off) <= allowed && fabs(from_centre - r) <= allowed)) return "circle: not on its two spheres";
    }
  }
  return NULL;
}

static const char *broken_areas(const computed *c) {
  double area = 0, volume = 0, volumes = 0, most_volume = 0, largest = 0, reach = 0;
  uint32_t i;
  for (i = 0; i < c->n; ++i) {
    const double r = c->radius[i] + c->rounding, sphere = 4 * pi * r * r, ball = sphere * r / 3;
    const double rounding = 1e-12 * r * r * (1 + c->balls[i].faces);
    if (c->balls[i].faces == 0 && c->area[i] != 0) return "area: a buried ball has one";
    if (c->balls[i].faces == 0 && c->volume[i] != 0) return "volume: a buried ball has a term";
    if (!(c->area[i] >= -rounding && c->area[i] <= sphere + rounding)) return "area: not between 0 and the sphere's";
    area += c->area[i];
    volume += c->volume[i];
    volumes += fabs(c->volume[i]);
    most_volume += ball;
    if (ball > largest) largest = ball;
    reach += sphere * c->rounding;
  }
  if (!(fabs(area - c->totals.area) <= 1e-13 * (area + 1e-300))) return "areas do not sum to the total";
  if (!(fabs(volume - c->totals.volume) <= 1e-13 * (volumes + 1e-300))) return "volumes do not sum to the total";
  if (!(c->totals.volume <= most_volume + 1e-12 * volumes)) return "volume: larger than all balls together";
  if (!(c->totals.volume >= largest - 4 * reach - 1e-12 * volumes)) return "volume: less than the largest ball";
  /* A body of volume V has at least the surface of the ball of that volume. */
  if (!(area >= cbrt(36 * pi * c->totals.volume * c->totals.volume) * (1 - 1e-9) - 1e-300)) {
    return "area: smaller than that of one ball of this volume";
  }
  return NULL;
}

const char *broken_boundary_measures(const computed *c) {
  const char *broken = broken_vertex_positions(c);
  if (broken == NULL) broken = broken_vertex_signs(c);
  if (broken == NULL) broken = broken_arc_angles(c);
  if (broken == NULL) broken = broken_circle_positions(c);
  if (broken == NULL) broken = broken_areas(c);
  return broken;
}
