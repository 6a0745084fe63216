/* Positions, axes and angles of vertices and edges against their definitions, in doubles. */
#include <math.h>
#include <stdlib.h>

#include "topology_invariants.h"
#include "vectors.h"

/* The allowed error of a position, the move to the lattice included. */
static double slack(const computed *c, const double xyz[3]) {
  return 1e-9 * c->info.largest_radius + 4 * position_error(xyz) + 8 * c->rounding;
}

/* How far a position lies outside a sphere, negative inside. */
static double off_sphere(const computed *c, const double xyz[3], uint32_t ball) {
  double v[3];
  difference(xyz, c->xyz + 3 * ball, v);
  return length(v) - c->radius[ball];
}

static int exposed(const computed *c, const double xyz[3]) {
  const double allowed = slack(c, xyz);
  uint32_t j;
  for (j = 0; j < c->n; ++j) {
    if (!(off_sphere(c, xyz, j) >= -allowed)) return 0;
  }
  return 1;
}

static const char *broken_vertices(const topology_result *t) {
  const computed *c = t->base;
  uint32_t i, m;
  for (i = 0; i < t->counts.vertices; ++i) {
    const hsp_topology_vertex *v = t->vertices + i;
    const double allowed = slack(c, v->xyz);
    for (m = 0; m < 3 && v->ball[m] != HSP_NONE; ++m) {
      if (!(fabs(off_sphere(c, v->xyz, v->ball[m])) <= allowed)) return "vertex: not on its spheres";
    }
    if (!exposed(c, v->xyz)) return "vertex: inside a ball";
    if (v->kind == HSP_POINT_POLE) {
      double w[3];
      difference(v->xyz, c->xyz + 3 * v->ball[0], w);
      if (!(fabs(fabs(w[2]) - c->radius[v->ball[0]]) <= allowed && fabs(w[0]) <= allowed && fabs(w[1]) <= allowed)) {
        return "vertex: a pole that is neither the highest nor the lowest point of its sphere";
      }
    }
  }
  return NULL;
}

/* The point of the edge's circle at `angle` from its origin. */
static void point_of_edge(const topology_result *t, const hsp_topology_edge *edge, double angle, double xyz[3]) {
  double u[3], quarter[3];
  int axis;
  difference(t->vertices[edge->vertex[0]].xyz, edge->centre, u);
  cross(edge->axis, u, quarter);
  for (axis = 0; axis < 3; ++axis) xyz[axis] = edge->centre[axis] + cos(angle) * u[axis] + sin(angle) * quarter[axis];
}

/* Whether the edge's circle lies on a ball's sphere: its axis goes through the centre, at the right distance. */
static int on_sphere(const computed *c, const hsp_topology_edge *edge, uint32_t ball) {
  const double allowed = slack(c, edge->centre), r = c->radius[ball];
  double off[3], beside[3];
  difference(edge->centre, c->xyz + 3 * ball, off);
  cross(off, edge->axis, beside);
  return length(beside) <= allowed &&
         fabs(dot(off, off) + edge->radius * edge->radius - r * r) <= 2 * allowed * (r + allowed);
}

static const char *broken_edge(const topology_result *t, const hsp_topology_edge *edge) {
  const computed *c = t->base;
  const double allowed = slack(c, edge->centre);
  double position[3], off[3];
  uint32_t e;
  if (!(fabs(length(edge->axis) - 1) <= 1e-12)) return "edge: axis is not a unit vector";
  if (!(edge->radius >= 0 && edge->radius <= c->info.largest_radius * (1 + 1e-12))) return "edge: radius of no circle";
  if (!(edge->angle >= 0 && edge->angle <= 2 * pi)) return "edge: angle is not in [0, 2 pi]";
  for (e = 0; e < 2; ++e) {
    const double *end = t->vertices[edge->vertex[e]].xyz;
    difference(end, edge->centre, off);
    if (!(fabs(length(off) - edge->radius) <= allowed)) return "edge: an end is not at its radius from its centre";
    if (!(fabs(dot(off, edge->axis)) <= allowed)) return "edge: an end is not in the plane across its axis";
    if (!(fabs(off_sphere(c, end, edge->ball[0])) <= allowed && fabs(off_sphere(c, end, edge->ball[1])) <= allowed)) {
      return "edge: an end is not on its balls' spheres";
    }
    if (!on_sphere(c, edge, edge->ball[e])) return "edge: its circle is not on its balls' spheres";
  }
  point_of_edge(t, edge, edge->angle, position);
  difference(position, t->vertices[edge->vertex[1]].xyz, off);
  if (!(length(off) <= 4 * allowed))
    return "edge: turning by its angle about the axis does not lead to its destination";
  point_of_edge(t, edge, edge->angle / 2, position);
  if (!(fabs(off_sphere(c, position, edge->ball[0])) <= 4 * allowed))
    return "edge: its middle is not on its ball's sphere";
  if (!exposed(c, position)) return "edge: its middle is inside a ball";
  return NULL;
}

/* The left face lies on the axis's side: on the lower ball of an arc or circle that is the side away from the other. */
static const char *broken_side(const computed *c, const hsp_topology_edge *edge) {
  double away[3];
  difference(c->xyz + 3 * edge->ball[0], c->xyz + 3 * edge->ball[1], away);
  if (!(dot(away, edge->axis) >= (1 - 1e-9) * length(away) - 8 * c->rounding)) {
    return "edge: axis does not point from its right ball to its left one";
  }
  return NULL;
}

/* An extra edge lies on a great circle in a plane that contains the z direction: orthogonal to x if the sphere is
 * whole, else through the axis of one of the sphere's circles. */
static const char *broken_extra(const topology_result *t, const hsp_topology_edge *edge) {
  const computed *c = t->base;
  const uint32_t ball = edge->ball[0];
  const double allowed = slack(c, edge->centre);
  double v[3];
  uint32_t j;
  difference(edge->centre, c->xyz + 3 * ball, v);
  if (!(length(v) <= allowed && fabs(edge->radius - c->radius[ball]) <= allowed)) {
    return "cut edge: not on a great circle of its ball";
  }
  if (!(fabs(edge->axis[2]) <= 1e-12)) return "cut edge: its plane does not contain z";
  if (c->faces[t->faces[edge->face[0]].face].loops == 0) {
    return fabs(edge->axis[0]) >= 1 - 1e-12 ? NULL : "cut edge: of a whole sphere, but not across x";
  }
  for (j = 0; j < c->n; ++j) {
    difference(c->xyz + 3 * j, c->xyz + 3 * ball, v);
    if (j == ball || !(length(v) <= c->radius[ball] + c->radius[j] + allowed)) continue;
    if (fabs(dot(v, edge->axis)) <= allowed) return NULL;
  }
  return "cut edge: its plane contains the axis of no circle on its ball";
}

/* Each free circle is cut at least in its two points in the plane through the balls' centres that contains z. */
static const char *broken_circle_points(const topology_result *t) {
  const computed *c = t->base;
  const char *broken = NULL;
  uint32_t i, e;
  uint32_t *ends = test_zeros(c->counts.circles, sizeof *ends);
  for (i = 0; i < t->counts.edges; ++i) {
    const hsp_topology_edge *edge = t->edges + i;
    const hsp_circle *circle;
    double normal[3], size;
    if (edge->kind != HSP_EDGE_CIRCLE) continue;
    circle = c->circles + edge->source;
    normal[0] = c->xyz[3 * circle->ball[1] + 1] - c->xyz[3 * circle->ball[0] + 1];
    normal[1] = c->xyz[3 * circle->ball[0]] - c->xyz[3 * circle->ball[1]];
    normal[2] = 0;
    size = length(normal);
    if (size <= 4 * c->rounding) normal[0] = size = 1;
    for (e = 0; e < 2; ++e) {
      double off[3];
      difference(t->vertices[edge->vertex[e]].xyz, circle->centre, off);
      if (fabs(dot(off, normal)) <= slack(c, circle->centre) * size) ++ends[edge->source];
    }
  }
  /* every point of a circle ends two of its pieces */
  for (i = 0; i < c->counts.circles && broken == NULL; ++i) {
    if (ends[i] < 4) broken = "circle: not cut in its two points in the plane through the centres that contains z";
  }
  free(ends);
  return broken;
}

static const char *broken_shell_points(const topology_result *t) {
  const computed *c = t->base;
  uint32_t i, f;
  for (i = 0; i < t->counts.shells; ++i) {
    const double *point = t->shells[i].point;
    int there = 0;
    if (!exposed(c, point)) return "shell: its point is inside a ball";
    for (f = 0; f < c->counts.faces && !there; ++f) {
      there = c->faces[f].shell == i && fabs(off_sphere(c, point, c->faces[f].ball)) <= slack(c, point);
    }
    if (!there) return "shell: its point is not on a sphere of its faces";
  }
  return NULL;
}

const char *broken_topology_positions(const topology_result *t) {
  const char *broken = broken_vertices(t);
  uint32_t i;
  for (i = 0; i < t->counts.edges && broken == NULL; ++i) {
    broken = broken_edge(t, t->edges + i);
    if (broken != NULL) break;
    broken = t->edges[i].kind == HSP_EDGE_CUT ? broken_extra(t, t->edges + i) : broken_side(t->base, t->edges + i);
  }
  if (broken == NULL) broken = broken_circle_points(t);
  if (broken == NULL) broken = broken_shell_points(t);
  return broken;
}
