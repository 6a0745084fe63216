/* The header's promises about the records of a view: the frame, how pieces, loops and arcs are numbered and joined, and
 * their order. */
#include <math.h>
#include <string.h>

#include "vectors.h"
#include "view_invariants.h"

/* v of any size as a unit vector; 0 if it is 0. */
static int unit_vector(const double v[3], double unit[3]) {
  const double largest = fmax(fmax(fabs(v[0]), fabs(v[1])), fabs(v[2]));
  double size;
  int axis;
  if (!(largest > 0)) return 0;
  for (axis = 0; axis < 3; ++axis) unit[axis] = v[axis] / largest;
  size = length(unit);
  for (axis = 0; axis < 3; ++axis) unit[axis] /= size;
  return 1;
}

static int far_apart(const double u[3], const double v[3], double tolerance) {
  double off[3];
  difference(u, v, off);
  return !(length(off) <= tolerance);
}

/* `towards` as the options have it, rounded to integers of at most 2^28, and `up` the first of the options' and the
 * defaults that is not parallel to it. */
static const char *broken_direction(const view_result *v) {
  static const double default_towards[3] = {0, 0, 1};
  const double defaults[2][3] = {{0, 1, 0}, {0, 0, 1}};
  const double *ups[3];
  double towards[3], up[3], right[3];
  int which;
  if (!unit_vector(v->options.towards, towards)) unit_vector(default_towards, towards);
  if (far_apart(v->info.towards, towards, 1e-8)) return "towards is not that of the options";
  ups[0] = v->options.up;
  ups[1] = defaults[0];
  ups[2] = defaults[1];
  for (which = 0; which < 3; ++which) {
    double sine;
    if (!unit_vector(ups[which], up)) continue;
    cross(up, towards, right);
    sine = length(right);
    if (sine < 1e-12) continue;
    if (sine < 1e-5) return NULL; /* too close to parallel to decide */
    unit_vector(right, right);
    return far_apart(v->info.right, right, 4e-8 / sine) ? "up is not that of the options" : NULL;
  }
  return "no direction was left for up";
}

static const char *broken_frame(const view_result *v) {
  const hsp_view_info *info = &v->info;
  double across[3];
  int axis;
  if (info->kind != v->options.pieces) return "info.kind is not that of the options";
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
    if (v->base->n > 0 && !near(info->origin[axis], (low + high) / 2, view_rounding(v, 0) + v->base->info.step)) {
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
    if (!near(low[axis], info->low[axis], view_rounding(v, 0)) ||
        !near(high[axis], info->high[axis], view_rounding(v, 0))) {
      return "the box is not that of the pieces' silhouettes";
    }
  }
  if (!near(info->depth_low, v->pieces[0].depth, view_rounding(v, 0)) ||
      !near(info->depth_high, v->pieces[info->pieces - 1].depth, view_rounding(v, 0))) {
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
 * recognise equal depths. */
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
    if (depths[0] > depths[1] + view_rounding(v, 0)) return "pieces are not ordered from the farthest to the nearest";
    if (v->pieces[i].depth > v->pieces[i + 1].depth + view_rounding(v, 0)) return "depths of pieces decrease";
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
    if (!near(piece->radius, c->radius[piece->ball], view_rounding(v, 0))) return "radius of a piece";
    if (!(piece->radius > 0)) return "a piece of a ball of radius 0";
    if ((c->balls[piece->ball].flags & HSP_BALL_CONTAINED) != 0) return "a piece of a ball inside another one";
    difference(&c->xyz[3 * piece->ball], v->info.origin, from_origin);
    if (!near(dot(from_origin, v->info.right), piece->centre[0], view_rounding(v, 0)) ||
        !near(dot(from_origin, v->info.up), piece->centre[1], view_rounding(v, 0)) ||
        !near(dot(from_origin, v->info.towards), piece->depth, view_rounding(v, 0))) {
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

const char *broken_view_records(const view_result *v) {
  const char *broken = broken_frame(v);
  if (broken == NULL) broken = broken_direction(v);
  if (broken == NULL && !(v->info.pieces <= v->info.loops && v->info.loops <= v->info.arcs)) {
    broken = "more pieces than loops, or more loops than arcs";
  }
  if (broken == NULL && v->needed.arcs < v->info.arcs) broken = "more arcs than hsp_view_compute says were needed";
  if (broken == NULL && v->enlargements > MOST_ENLARGEMENTS) broken = "more than three enlargements";
  if (broken == NULL) broken = broken_pieces(v);
  if (broken == NULL) broken = broken_loops(v);
  if (broken == NULL) broken = broken_order(v);
  if (broken == NULL) broken = broken_box(v);
  return broken;
}
