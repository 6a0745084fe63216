/* What the header promises about the records of a view, one by one and together. */
#include <math.h>
#include <string.h>

#include "vectors.h"
#include "view_result.h"

static const double pi = 3.14159265358979323846;

/* Rounding of positions: parts of the set's extent and of the radius that matters. */
static double allowed(const view_result *v, double radius) {
  double extent = 0;
  int axis;
  uint32_t i;
  for (axis = 0; axis < 3; ++axis) extent = fmax(extent, fabs(v->info.origin[axis]));
  for (i = 0; i < 3 * v->base->n; ++i) extent = fmax(extent, fabs(v->base->xyz[i]));
  return 1e-10 * radius + 1e-13 * extent + 4 * v->base->rounding;
}

static int near(double a, double b, double tolerance) {
  return fabs(a - b) <= tolerance; /* false for NaN */
}

static const char *broken_frame(const view_result *v) {
  const hsp_view_info *info = &v->info;
  double across[3];
  int axis;
  if (info->kind != v->options.pieces) return "info.kind is not what was asked for";
  cross(info->right, info->up, across);
  for (axis = 0; axis < 3; ++axis) {
    if (!near(across[axis], info->towards[axis], 1e-15 * 8)) return "right, up and towards are not right-handed";
  }
  if (!near(dot(info->right, info->right), 1, 1e-15 * 8) || !near(dot(info->up, info->up), 1, 1e-15 * 8) ||
      !near(dot(info->towards, info->towards), 1, 1e-15 * 8)) {
    return "right, up and towards are not unit vectors";
  }
  if (!near(dot(info->right, info->up), 0, 1e-15 * 4)) return "right and up are not across each other";
  for (axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY;
    uint32_t i;
    for (i = 0; i < v->base->n; ++i) {
      low = fmin(low, v->base->xyz[3 * i + (uint32_t)axis]);
      high = fmax(high, v->base->xyz[3 * i + (uint32_t)axis]);
    }
    if (v->base->n > 0 && !near(info->origin[axis], (low + high) / 2, allowed(v, 0) + v->base->info.step)) {
      return "the origin is not the middle of the balls' centres";
    }
  }
  return NULL;
}

static const char *broken_box(const view_result *v) {
  const hsp_view_info *info = &v->info;
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  uint32_t i;
  int axis;
  if (info->pieces == 0) {
    return info->low[0] == 0 && info->low[1] == 0 && info->high[0] == 0 && info->high[1] == 0 ? NULL
                                                                                              : "box without pieces";
  }
  for (i = 0; i < info->pieces; ++i) {
    const hsp_view_piece *piece = &v->pieces[i];
    for (axis = 0; axis < 2; ++axis) {
      low[axis] = fmin(low[axis], piece->centre[axis] - piece->radius);
      high[axis] = fmax(high[axis], piece->centre[axis] + piece->radius);
    }
  }
  for (axis = 0; axis < 2; ++axis) {
    if (!near(low[axis], info->low[axis], allowed(v, 0)) || !near(high[axis], info->high[axis], allowed(v, 0))) {
      return "the box is not that of the pieces' silhouettes";
    }
  }
  if (!near(info->depth_low, v->pieces[0].depth, allowed(v, 0)) ||
      !near(info->depth_high, v->pieces[info->pieces - 1].depth, allowed(v, 0))) {
    return "depth_low and depth_high are not those of the first and the last piece";
  }
  return NULL;
}

/* -1, 0, 1 by the header's rule for equal depths: x, y, z, radius. */
static int rank_order(const computed *c, uint32_t i, uint32_t j) {
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const double a = c->xyz[3 * i + (uint32_t)axis], b = c->xyz[3 * j + (uint32_t)axis];
    if (a != b) return a < b ? -1 : 1;
  }
  return c->radius[i] < c->radius[j] ? -1 : c->radius[i] > c->radius[j];
}

/* Whether depths of this direction are integers times a common factor, so that sums of coordinates are exact enough to
 * tell equal depths. */
static int axis_or_diagonal(const double towards[3]) {
  double largest = 0;
  int axis;
  for (axis = 0; axis < 3; ++axis) largest = fmax(largest, fabs(towards[axis]));
  for (axis = 0; axis < 3; ++axis) {
    if (towards[axis] != 0 && fabs(towards[axis]) != largest) return 0;
  }
  return 1;
}

/* The depth in lattice steps; exact for axes and diagonals and the sets of the tests. */
static long double steps_deep(const view_result *v, uint32_t ball) {
  long double sum = 0;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const double t = v->options.towards[axis];
    const long double steps = floorl((long double)v->base->xyz[3 * ball + (uint32_t)axis] / v->base->info.step + 0.5L);
    sum += (t > 0 ? 1 : t < 0 ? -1 : 0) * steps;
  }
  return sum;
}

static const char *broken_order(const view_result *v) {
  const double *t = v->options.towards;
  const int usual = t[0] == 0 && t[1] == 0 && t[2] == 0; /* the default, 0 0 1 */
  uint32_t i;
  for (i = 0; i + 1 < v->info.pieces; ++i) {
    const uint32_t a = v->pieces[i].ball, b = v->pieces[i + 1].ball;
    long double depths[2] = {0, 0};
    int axis;
    for (axis = 0; axis < 3; ++axis) {
      depths[0] += (long double)v->info.towards[axis] * v->base->xyz[3 * a + (uint32_t)axis];
      depths[1] += (long double)v->info.towards[axis] * v->base->xyz[3 * b + (uint32_t)axis];
    }
    if (depths[0] > depths[1] + allowed(v, 0)) return "pieces are not ordered from the farthest to the nearest";
    if (v->pieces[i].depth > v->pieces[i + 1].depth + allowed(v, 0)) return "depths of pieces decrease";
    if (!usual && axis_or_diagonal(t)) {
      const long double first = steps_deep(v, a), second = steps_deep(v, b);
      if (first > second) return "pieces are not ordered exactly by depth";
      if (first == second && rank_order(v->base, a, b) > 0) return "pieces of equal depth in a wrong order";
    }
  }
  return NULL;
}

static const char *broken_pieces(const view_result *v) {
  const computed *c = v->base;
  uint32_t i, j, loop = 0, arc = 0;
  for (i = 0; i < v->info.pieces; ++i) {
    const hsp_view_piece *piece = &v->pieces[i];
    double from_origin[3];
    if (piece->ball >= c->n) return "piece of no ball";
    if (v->with_boundary && c->balls[piece->ball].faces == 0) return "piece of a ball without faces";
    for (j = 0; j < i; ++j) {
      if (v->pieces[j].ball == piece->ball) return "two pieces of one ball";
    }
    if (piece->reserved != 0) return "reserved field of a piece";
    if (piece->loops == 0 || piece->arcs < piece->loops) return "a piece without arcs";
    if (piece->first_loop != loop || piece->first_arc != arc) return "loops or arcs of pieces do not follow each other";
    loop += piece->loops;
    arc += piece->arcs;
    if (!near(piece->radius, c->radius[piece->ball], allowed(v, 0))) return "radius of a piece";
    if (!(piece->radius > 0)) return "a piece of a ball of radius 0";
    difference(&c->xyz[3 * piece->ball], v->info.origin, from_origin);
    if (!near(dot(from_origin, v->info.right), piece->centre[0], allowed(v, 0)) ||
        !near(dot(from_origin, v->info.up), piece->centre[1], allowed(v, 0)) ||
        !near(dot(from_origin, v->info.towards), piece->depth, allowed(v, 0))) {
      return "view coordinates of a piece's centre";
    }
  }
  return loop == v->info.loops && arc == v->info.arcs ? NULL : "loops or arcs of no piece";
}

static const char *broken_loops(const view_result *v) {
  uint32_t i, k, arc = 0;
  for (i = 0; i < v->info.loops; ++i) {
    const hsp_view_loop *loop = &v->loops[i];
    const hsp_view_piece *piece;
    if (loop->piece >= v->info.pieces) return "a loop of no piece";
    piece = &v->pieces[loop->piece];
    if (i < piece->first_loop || i >= piece->first_loop + piece->loops) return "a loop of another piece";
    if (loop->reserved != 0) return "reserved field of a loop";
    if (loop->arcs == 0 || loop->first_arc != arc) return "arcs of loops do not follow each other";
    for (k = 0; k < loop->arcs; ++k) {
      const hsp_view_arc *one = &v->arcs[arc + k], *next = &v->arcs[arc + (k + 1) % loop->arcs];
      if (one->piece != loop->piece) return "an arc of another piece";
      /* hsp_view_get_arcs, property 1 */
      if (memcmp(one->end, next->start, sizeof one->end) != 0) return "a loop is not closed bit for bit";
    }
    arc += loop->arcs;
  }
  return NULL;
}

static void ellipse_point(const hsp_view_arc *arc, double t, double point[2]) {
  const double u = arc->semi_axis[0] * cos(t), w = arc->semi_axis[1] * sin(t);
  point[0] = arc->centre[0] + u * cos(arc->rotation) - w * sin(arc->rotation);
  point[1] = arc->centre[1] + u * sin(arc->rotation) + w * cos(arc->rotation);
}

/* The circle in which the spheres of both balls meet, as it appears. Radii are compared as squares: where spheres
 * touch, the root has no digits. */
static const char *broken_ellipse(const view_result *v, const hsp_view_piece *piece, const hsp_view_arc *arc) {
  const computed *c = v->base;
  const double r = c->radius[piece->ball], other = c->radius[arc->across];
  double axis[3], d, along, squared, foot[2], deep, tolerance;
  difference(&c->xyz[3 * arc->across], &c->xyz[3 * piece->ball], axis);
  d = length(axis);
  if (!(d > 0)) return "an intersection with a concentric ball";
  along = (d * d + r * r - other * other) / (2 * d);
  squared = r * r - along * along;
  tolerance = allowed(v, r + other) * (1 + (r + other) / d);
  foot[0] = piece->centre[0] + along * dot(axis, v->info.right) / d;
  foot[1] = piece->centre[1] + along * dot(axis, v->info.up) / d;
  deep = dot(axis, v->info.towards) / d;
  if (!near(arc->centre[0], foot[0], tolerance) || !near(arc->centre[1], foot[1], tolerance)) return "centre of an arc";
  if (!near(arc->semi_axis[0] * arc->semi_axis[0], squared, tolerance * (r + other))) return "larger semi-axis";
  if (!near(arc->semi_axis[1], arc->semi_axis[0] * fabs(deep), 1e-10 * arc->semi_axis[0])) return "smaller semi-axis";
  if (fabs(deep) < 0.999) {
    const double across = dot(axis, v->info.right) * cos(arc->rotation) + dot(axis, v->info.up) * sin(arc->rotation);
    /* a circle without a size may be turned anyhow */
    if (!near(across * arc->semi_axis[0], 0, 1e-9 * d * r)) return "rotation of an arc";
  }
  return NULL;
}

static const char *broken_arcs(const view_result *v) {
  uint32_t i;
  for (i = 0; i < v->info.arcs; ++i) {
    const hsp_view_arc *arc = &v->arcs[i];
    const hsp_view_piece *piece = &v->pieces[arc->piece];
    const double tolerance = 10 * allowed(v, piece->radius);
    double from[2], to[2];
    if (!(arc->semi_axis[0] >= arc->semi_axis[1] && arc->semi_axis[1] >= 0)) return "order of semi-axes";
    if (!(arc->semi_axis[0] <= piece->radius * (1 + 1e-12))) return "an arc larger than its ball";
    if (!(arc->rotation > -pi - 1e-15 && arc->rotation <= pi)) return "rotation out of range";
    if (!(fabs(arc->from) <= 2 * pi)) return "`from` out of range";
    if (!(fabs(arc->to - arc->from) <= 2 * pi)) return "an arc of more than 2 pi";
    ellipse_point(arc, arc->from, from);
    ellipse_point(arc, arc->to, to);
    /* hsp_view_get_arcs, property 2 */
    if (!near(from[0], arc->start[0], tolerance) || !near(from[1], arc->start[1], tolerance)) return "start of an arc";
    if (!near(to[0], arc->end[0], tolerance) || !near(to[1], arc->end[1], tolerance)) return "end of an arc";
    if (hypot(arc->start[0] - piece->centre[0], arc->start[1] - piece->centre[1]) > piece->radius + tolerance) {
      return "an arc leaves its ball's silhouette";
    }
    if (arc->across == HSP_NONE) {
      if (!near(arc->centre[0], piece->centre[0], tolerance) || !near(arc->centre[1], piece->centre[1], tolerance)) {
        return "a silhouette about another centre";
      }
      if (!near(arc->semi_axis[1], piece->radius, tolerance)) return "a silhouette that is not the ball's circle";
      if (!(arc->to >= arc->from)) return "a silhouette that runs clockwise";
    } else {
      const char *broken;
      if (arc->across >= v->base->n || arc->across == piece->ball) return "an arc across no other ball";
      broken = broken_ellipse(v, piece, arc);
      if (broken != NULL) return broken;
    }
  }
  return NULL;
}

/* Green's theorem, arc by arc. */
static double enclosed(const view_result *v, const hsp_view_loop *loop, const double about[2]) {
  double sum = 0;
  uint32_t k;
  for (k = 0; k < loop->arcs; ++k) {
    const hsp_view_arc *arc = &v->arcs[loop->first_arc + k];
    const double x = arc->centre[0] - about[0], y = arc->centre[1] - about[1];
    sum += x * (arc->end[1] - arc->start[1]) - y * (arc->end[0] - arc->start[0]);
    sum += arc->semi_axis[0] * arc->semi_axis[1] * (arc->to - arc->from);
  }
  return sum / 2;
}

static const char *broken_areas(const view_result *v) {
  uint32_t i, k;
  for (i = 0; i < v->info.pieces; ++i) {
    const hsp_view_piece *piece = &v->pieces[i];
    const double disc = pi * piece->radius * piece->radius;
    const double tolerance = 1e-8 * disc + 10 * allowed(v, piece->radius) * piece->radius;
    double area = 0;
    for (k = 0; k < piece->loops; ++k) area += enclosed(v, &v->loops[piece->first_loop + k], piece->centre);
    if (!(area >= -tolerance)) return "a piece with a negative area";
    if (!(area <= disc + tolerance)) return "a piece larger than its ball's disc";
  }
  return NULL;
}

const char *broken_view_records(const view_result *v) {
  const char *broken = broken_frame(v);
  if (broken == NULL && !(v->info.pieces <= v->info.loops && v->info.loops <= v->info.arcs)) {
    broken = "more pieces than loops, or more loops than arcs";
  }
  if (broken == NULL && v->needed.arcs < v->info.arcs) broken = "more arcs than hsp_view_get_needed says";
  if (broken == NULL) broken = broken_pieces(v);
  if (broken == NULL) broken = broken_loops(v);
  if (broken == NULL) broken = broken_order(v);
  if (broken == NULL) broken = broken_box(v);
  if (broken == NULL) broken = broken_arcs(v);
  if (broken == NULL) broken = broken_areas(v);
  return broken;
}
