/* Positions, angles, areas and volumes against their definitions. Tolerances are for the roundings of the check itself,
 * which computes in double, not for the library: a few hundred roundings relative to the sizes that enter. */
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

/* The circle of an arc or a free circle, whose first fields are the same. */
static const char *broken_circle(const computed *c, const double centre[3], const double axis[3], double radius,
                                 const uint32_t ball[2]) {
  const double allowed = 4 * slack(c, centre);
  double u[3], w[3], off[3];
  uint32_t e;
  difference(c->xyz + 3 * ball[1], c->xyz + 3 * ball[0], u);
  if (!(fabs(length(axis) - 1) <= 1e-14)) return "circle: axis is not a unit vector";
  cross(axis, u, off);
  if (!(dot(axis, u) > 0 && length(off) <= 1e-14 * length(u) + 8 * (c->rounding + 1e-16 * c->extent))) {
    return "circle: axis does not point from c_a to c_b";
  }
  if (!(radius >= 0)) return "circle: negative radius";
  for (e = 0; e < 2; ++e) {
    double from_centre;
    difference(centre, c->xyz + 3 * ball[e], w);
    from_centre = sqrt(dot(w, w) + radius * radius);
    cross(axis, w, off);
    if (!(length(off) <= allowed && fabs(from_centre - c->radius[ball[e]]) <= allowed)) {
      return "circle: not on its two spheres";
    }
  }
  return NULL;
}

/* At `xyz` on both spheres, walking in direction `along` on the outside: to the left the sphere of ball b leaves ball
 * a, and to the right the sphere of a leaves b. There the faces of b and a must be. */
static const char *broken_sides(const computed *c, const double xyz[3], const double along[3], const uint32_t ball[2]) {
  uint32_t e;
  for (e = 0; e < 2; ++e) {
    double outward[3], left[3], from_other[3], leaving;
    difference(xyz, c->xyz + 3 * ball[e], outward);
    cross(outward, along, left);
    difference(xyz, c->xyz + 3 * ball[1 - e], from_other);
    leaving = e == 1 ? dot(left, from_other) : -dot(left, from_other);
    if (!(leaving >= -8 * slack(c, xyz) * length(along) * (length(outward) + length(from_other)))) {
      return "arc or circle: face[1] is not on its left, or face[0] not on its right";
    }
  }
  return NULL;
}

static const char *broken_circle_positions(const computed *c) {
  const char *broken = NULL;
  uint32_t i;
  int k;
  for (i = 0; i < c->counts.arcs && broken == NULL; ++i) {
    const hsp_arc *arc = c->arcs + i;
    const double turn = arc->angle / 2;
    double start[3], quarter[3], middle[3], along[3];
    broken = broken_circle(c, arc->centre, arc->axis, arc->radius, arc->ball);
    difference(c->vertices[arc->vertex[0]].xyz, arc->centre, start);
    cross(arc->axis, start, quarter);
    for (k = 0; k < 3; ++k) {
      middle[k] = arc->centre[k] + cos(turn) * start[k] + sin(turn) * quarter[k];
      along[k] = cos(turn) * quarter[k] - sin(turn) * start[k];
    }
    if (broken == NULL) broken = broken_sides(c, middle, along, arc->ball);
  }
  for (i = 0; i < c->counts.circles && broken == NULL; ++i) {
    const hsp_circle *circle = c->circles + i;
    double across_axis[3] = {0, 0, 0}, start[3], quarter[3], xyz[3];
    broken = broken_circle(c, circle->centre, circle->axis, circle->radius, circle->ball);
    across_axis[fabs(circle->axis[0]) < 0.75 ? 0 : 1] = circle->radius;
    across(circle->axis, across_axis, start);
    cross(circle->axis, start, quarter);
    for (k = 0; k < 3; ++k) xyz[k] = circle->centre[k] + start[k] * (circle->radius / (length(start) + 1e-300));
    if (broken == NULL) broken = broken_sides(c, xyz, quarter, circle->ball);
  }
  return broken;
}

/* The integral of x cross dx over an arc from `from` to `to`, counter-clockwise about its axis; x is seen from
 * `origin`. */
static void swept(const double origin[3], const double centre[3], const double axis[3], double radius, double angle,
                  const double from[3], const double to[3], double result[3]) {
  double m[3], chord[3];
  int k;
  difference(centre, origin, m);
  difference(to, from, chord);
  cross(m, chord, result);
  for (k = 0; k < 3; ++k) result[k] += radius * radius * angle * axis[k];
}

/* The volume by the divergence theorem. The vector area of every face comes from its loops by Stokes' theorem, and has
 * the wrong sign if the loops keep their face on the right. */
static const char *broken_loop_directions(const computed *c) {
  const double *origin = c->xyz;
  double volume = 0, terms = 0, error = 0;
  uint32_t i, s;
  for (i = 0; i < c->n; ++i) {
    volume += c->radius[i] * c->area[i] / 3;
    terms += c->radius[i] * c->area[i];
  }
  for (i = 0; i < c->counts.loops; ++i) {
    const hsp_loop *loop = c->loops + i;
    const uint32_t ball = c->faces[loop->face].ball;
    const double *own = c->xyz + 3 * ball;
    double arm[3], part[3];
    difference(own, origin, arm);
    if (loop->circle != HSP_NONE) {
      const hsp_circle *circle = c->circles + loop->circle;
      swept(own, circle->centre, circle->axis, circle->radius, 2 * pi, own, own, part);
      volume += (loop->side == 1 ? 1 : -1) * dot(arm, part) / 6;
      error += 1e-14 * length(arm) * length(part);
    }
    for (s = loop->first_arc; s < loop->first_arc + loop->arcs; ++s) {
      const hsp_arc *arc = c->arcs + c->loop_arcs[s].arc;
      const hsp_loop_arc *next = c->loop_arcs + (s + 1 < loop->first_arc + loop->arcs ? s + 1 : loop->first_arc);
      const double sign = c->loop_arcs[s].side == 1 ? 1 : -1; /* along the arc, or against it */
      const double *comes = c->vertices[c->loop_arcs[s].vertex].xyz, *leaves = c->vertices[next->vertex].xyz;
      swept(own, arc->centre, arc->axis, arc->radius, arc->angle, sign > 0 ? comes : leaves, sign > 0 ? leaves : comes,
            part);
      volume += sign * dot(arm, part) / 6;
      error += length(arm) * (slack(c, arc->centre) * c->radius[ball] + 1e-14 * length(part));
    }
  }
  return near(volume, c->totals.volume, 1e-12 * terms + 16 * error + 64 * c->rounding * c->totals.area)
             ? NULL
             : "the loops do not bound their faces: another volume by the vector areas that they give";
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
  if (broken == NULL) broken = broken_loop_directions(c);
  return broken;
}
