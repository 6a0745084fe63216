/* The areas of simple faces from their loops alone, by the theorem of Gauss and Bonnet. A loop that does not bound one
 * disc on the left of its edges, or runs the wrong way, gives a wrong area. The areas of the simple faces of a maximal
 * face must sum to the area of the maximal face that the library measures. */
#include <math.h>
#include <stdlib.h>

#include "topology_invariants.h"
#include "vectors.h"

/* The unit tangent at the start (end = 0) or at the end (end = 1) of q. */
static void tangent(const topology_result *t, uint32_t q, int end, double along[3]) {
  const hsp_topology_edge *edge = t->edges + q / 4;
  const double *at = t->vertices[edge->vertex[q % 4 == 0 ? end : 1 - end]].xyz;
  const double sense = q % 4 == 0 ? 1 : -1;
  double u[3];
  int axis;
  for (axis = 0; axis < 3; ++axis) u[axis] = sense * (at[axis] - edge->centre[axis]) / edge->radius;
  along[0] = edge->axis[1] * u[2] - edge->axis[2] * u[1];
  along[1] = edge->axis[2] * u[0] - edge->axis[0] * u[2];
  along[2] = edge->axis[0] * u[1] - edge->axis[1] * u[0];
}

/* The angle by which the loop turns left, seen from outside, between q and next. */
static double turn(const topology_result *t, uint32_t q, uint32_t next, const double centre[3], double radius) {
  const double *at = t->vertices[t->origin[next]].xyz;
  double in[3], out[3], side[3], outward[3];
  int axis;
  tangent(t, q, 1, in);
  tangent(t, next, 0, out);
  side[0] = in[1] * out[2] - in[2] * out[1];
  side[1] = in[2] * out[0] - in[0] * out[2];
  side[2] = in[0] * out[1] - in[1] * out[0];
  for (axis = 0; axis < 3; ++axis) outward[axis] = (at[axis] - centre[axis]) / radius;
  return atan2(dot(side, outward), dot(in, out));
}

/* Whether positions on the circle of an edge are too coarse for directions: circles of nearly no size, and coordinates
 * of which few digits are left for the circle. */
static int is_too_small(const hsp_topology_edge *edge, double sphere_radius) {
  return edge->radius < 1e-4 * sphere_radius || position_error(edge->centre) > 1e-9 * edge->radius;
}

/* The area over radius squared. NaN, and so unchecked, where directions are too uncertain: on small circles, and at
 * cusps, where a turn to the left is no different from one to the right. */
static double face_angle(const topology_result *t, const hsp_simple_face *face) {
  const computed *c = t->base;
  const double *centre = c->xyz + 3 * face->ball;
  const double radius = c->radius[face->ball];
  double angle = 2 * pi;
  uint32_t q = face->q;
  do {
    const hsp_topology_edge *edge = t->edges + q / 4;
    const uint32_t next = hsp_topology_lnext(t->topology, q);
    const double sense = q % 4 == 0 ? 1 : -1;
    double height[3], turned;
    int axis;
    if (is_too_small(edge, radius) || is_too_small(t->edges + next / 4, radius)) return NAN;
    for (axis = 0; axis < 3; ++axis) height[axis] = edge->centre[axis] - centre[axis];
    turned = turn(t, q, next, centre, radius);
    if (fabs(turned) > pi - 1e-3) return NAN;
    angle -= edge->angle * sense * dot(height, edge->axis) / radius + turned;
    q = next;
  } while (q != face->q);
  return angle;
}

decided_count face_areas_decided;

const char *broken_topology_face_areas(const topology_result *t) {
  const computed *c = t->base;
  const char *broken = NULL;
  uint32_t i;
  double *sum = test_zeros(c->counts.faces, sizeof *sum);
  double *area = test_zeros(c->counts.faces, sizeof *area);
  if (hsp_boundary_measure_faces(c->boundary, area, NULL, c->counts.faces, NULL) != HSP_OK)
    broken = "areas of maximal faces";
  for (i = 0; i < t->counts.simple_faces && broken == NULL; ++i) {
    const hsp_simple_face *face = t->faces + i;
    const double angle = c->radius[face->ball] > 0 ? face_angle(t, face) : NAN;
    if (angle < -1e-8 || angle > 4 * pi + 1e-8) broken = "simple face: its loop bounds no disc on its left";
    sum[face->face] += angle;
  }
  for (i = 0; i < c->counts.faces && broken == NULL; ++i) {
    const double r = c->radius[c->faces[i].ball];
    count_decided(&face_areas_decided, !isnan(sum[i]));
    if (isnan(sum[i])) continue;
    if (!(fabs(sum[i] * r * r - area[i]) <= 1e-7 * r * r + 100 * c->rounding * r)) {
      broken = "the simple faces of a maximal face do not sum to its area";
    }
  }
  free(sum);
  free(area);
  return broken;
}
