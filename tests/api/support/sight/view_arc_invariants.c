/* The header's promises about the arcs of a view: each against its own numbers and against the spheres that meet in it,
 * and the areas that arcs enclose together. */
#include <math.h>
#include <stdlib.h>

#include "vectors.h"
#include "view_invariants.h"

static void ellipse_point(const hsp_view_arc *arc, double t, double point[2]) {
  const double u = arc->semi_axis[0] * cos(t), w = arc->semi_axis[1] * sin(t);
  point[0] = arc->centre[0] + u * cos(arc->rotation) - w * sin(arc->rotation);
  point[1] = arc->centre[1] + u * sin(arc->rotation) + w * cos(arc->rotation);
}

/* The circle in which the spheres of both balls meet, as it appears. Radii are compared as squares: where spheres
 * touch, the root has no digits. */
static const char *broken_ellipse(const view_result *v, const hsp_view_piece *piece, const hsp_view_arc *arc) {
  const computed *c = v->base;
  const double r = c->radius[piece->ball], other = c->radius[arc->other_ball];
  double axis[3], d, along, squared, foot[2], deep, tolerance;
  difference(&c->xyz[3 * arc->other_ball], &c->xyz[3 * piece->ball], axis);
  d = length(axis);
  if (!(d > 0)) return "an intersection with a concentric ball";
  along = (d * d + r * r - other * other) / (2 * d);
  squared = r * r - along * along;
  tolerance = view_rounding(v, r + other) * (1 + (r + other) / d);
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

/* Whether points along an arc, lifted to the front of its ball, lie on the sphere of the other ball. Near the
 * silhouette what rounding moves in the plane moves more in depth. */
static int on_both_fronts(const view_result *v, const hsp_view_piece *piece, const hsp_view_arc *arc) {
  static const double parts[3] = {0.1, 0.5, 0.8};
  const double r = piece->radius, error = view_rounding(v, 0);
  const double tolerance = 1e-6 * r + sqrt(2 * r * error) + error;
  double from_origin[3], other[3], at[3];
  int k;
  difference(&v->base->xyz[3 * arc->other_ball], v->info.origin, from_origin);
  other[0] = dot(from_origin, v->info.right);
  other[1] = dot(from_origin, v->info.up);
  other[2] = dot(from_origin, v->info.towards);
  for (k = 0; k < 3; ++k) {
    double square, off[3];
    ellipse_point(arc, arc->from + parts[k] * (arc->to - arc->from), at);
    square = r * r - (at[0] - piece->centre[0]) * (at[0] - piece->centre[0]) -
             (at[1] - piece->centre[1]) * (at[1] - piece->centre[1]);
    if (!(square >= -1e-9 * r * r - 4 * error * r)) return 0;
    at[2] = piece->depth + sqrt(fmax(square, 0));
    difference(at, other, off);
    if (!near(length(off), v->base->radius[arc->other_ball], tolerance)) return 0;
  }
  return 1;
}

static const char *broken_parameters(const view_result *v, const hsp_view_piece *piece, const hsp_view_arc *arc) {
  const double tolerance = 10 * view_rounding(v, piece->radius);
  double from[2], to[2];
  if (!(arc->semi_axis[0] >= arc->semi_axis[1] && arc->semi_axis[1] >= 0)) return "order of semi-axes";
  if (!(arc->semi_axis[0] <= piece->radius * (1 + 1e-12))) return "an arc larger than its ball";
  /* `pi` is a little less than pi, so that -pi is in the range as well */
  if (!(arc->rotation >= -pi && arc->rotation <= pi)) return "rotation out of range";
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
  return NULL;
}

static const char *broken_silhouette(const view_result *v, const hsp_view_piece *piece, const hsp_view_arc *arc) {
  const double tolerance = view_rounding(v, piece->radius);
  if (!near(arc->centre[0], piece->centre[0], tolerance) || !near(arc->centre[1], piece->centre[1], tolerance)) {
    return "a silhouette about another centre";
  }
  if (arc->semi_axis[0] != piece->radius || arc->semi_axis[1] != piece->radius) {
    return "a silhouette that is not the ball's circle";
  }
  return arc->to >= arc->from ? NULL : "a silhouette that runs clockwise";
}

/* piece_of: of each ball, or HSP_NONE. */
static const char *broken_arc(const view_result *v, const hsp_view_arc *arc, const uint32_t *piece_of) {
  const hsp_view_piece *piece = &v->pieces[arc->piece];
  const char *broken = broken_parameters(v, piece, arc);
  if (broken != NULL) return broken;
  if (arc->other_ball == HSP_NONE) return broken_silhouette(v, piece, arc);
  if (arc->other_ball >= v->base->n || arc->other_ball == piece->ball) return "an arc of no other ball";
  if (v->options.pieces == HSP_PIECES_OUTSIDE_FARTHER && piece_of[arc->other_ball] != HSP_NONE &&
      piece_of[arc->other_ball] > arc->piece) {
    return "a G-piece is cut by a nearer ball";
  }
  broken = broken_ellipse(v, piece, arc);
  if (broken == NULL && !on_both_fronts(v, piece, arc)) broken = "an arc that is not on the front of its ball";
  return broken;
}

static const char *broken_each(const view_result *v) {
  const char *broken = NULL;
  uint32_t i;
  uint32_t *piece_of = test_zeros(v->base->n, sizeof *piece_of);
  for (i = 0; i < v->base->n; ++i) piece_of[i] = HSP_NONE;
  for (i = 0; i < v->info.pieces; ++i) piece_of[v->pieces[i].ball] = i;
  for (i = 0; i < v->info.arcs && broken == NULL; ++i) broken = broken_arc(v, &v->arcs[i], piece_of);
  for (i = 0; i < v->info.loops && broken == NULL; ++i) {
    const hsp_view_arc *arc = &v->arcs[v->loops[i].first_arc];
    if (v->loops[i].arcs == 1 && fabs(arc->to - arc->from) != 2 * pi) broken = "a loop of one arc that is not whole";
  }
  free(piece_of);
  return broken;
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

static double area_of_piece(const view_result *v, uint32_t piece) {
  const hsp_view_piece *p = &v->pieces[piece];
  double area = 0;
  uint32_t k;
  for (k = 0; k < p->loops; ++k) area += enclosed(v, &v->loops[p->first_loop + k], p->centre);
  return area;
}

static const char *broken_areas(const view_result *v) {
  uint32_t i;
  for (i = 0; i < v->info.pieces; ++i) {
    const double r = v->pieces[i].radius, disc = pi * r * r, area = area_of_piece(v, i);
    const double tolerance = 1e-12 * disc + 10 * view_rounding(v, 0) * r;
    if (!(area >= -tolerance)) return "a piece with a negative area";
    if (!(area <= disc + tolerance)) return "a piece larger than its ball's disc";
  }
  return NULL;
}

const char *broken_view_arcs(const view_result *v) {
  const char *broken = broken_each(v);
  return broken == NULL ? broken_areas(v) : broken;
}

const char *view_difference_from_behind(const view_result *front, const view_result *back) {
  double area[2] = {0, 0};
  uint32_t i;
  for (i = 0; i < front->info.pieces; ++i) area[0] += area_of_piece(front, i);
  for (i = 0; i < back->info.pieces; ++i) area[1] += area_of_piece(back, i);
  return near(area[0], area[1], 1e-10 * (area[0] + area[1])) ? NULL : "front and back have different areas";
}
