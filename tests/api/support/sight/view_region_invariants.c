/* The regions that a view's loops enclose, at sample points, against the definition of a piece: the part of the front
 * hemisphere outside farther balls (G) or outside all balls (H). And the piece that is painted last at a point against
 * the ball that is seen there. The definitions are evaluated over all balls, from the caller's numbers. */
#include <math.h>
#include <stdlib.h>

#include "placed_balls.h"
#include "random_numbers.h"
#include "vectors.h"
#include "view_invariants.h"

/* The balls in view coordinates, from the caller's own numbers. */
typedef struct scene {
  const view_result *v;
  placed_balls balls;
  uint32_t *piece;     /* of each ball, or HSP_NONE */
  uint32_t *contained; /* whether each ball lies in another one; of equal balls all do */
} scene;

static void scene_make(const view_result *v, scene *s) {
  const computed *c = v->base;
  uint32_t i, j;
  s->v = v;
  placed_balls_make(c, v->info.origin, v->info.right, v->info.up, v->info.towards, &s->balls);
  s->piece = test_zeros(c->n, sizeof *s->piece);
  s->contained = test_zeros(c->n, sizeof *s->contained);
  for (i = 0; i < c->n; ++i) s->piece[i] = HSP_NONE;
  for (i = 0; i < v->info.pieces; ++i) s->piece[v->pieces[i].ball] = i;
  for (i = 0; i < c->n; ++i) {
    for (j = 0; j < c->n; ++j) {
      double apart[3];
      difference(s->balls.position[i], s->balls.position[j], apart);
      if (j != i && length(apart) + c->radius[i] <= c->radius[j] + s->balls.margin) s->contained[i] = 1;
    }
  }
}

static void scene_release(scene *s) {
  placed_balls_release(&s->balls);
  free(s->piece);
  free(s->contained);
}

/* How often the loops of a piece wind about a point: crossings of a ray to the right. */
static int winding(const view_result *v, uint32_t piece, const double p[2]) {
  uint32_t k;
  int turns = 0, root, lap;
  for (k = 0; k < v->pieces[piece].arcs; ++k) {
    const hsp_view_arc *arc = &v->arcs[v->pieces[piece].first_arc + k];
    const double turned_x = cos(arc->rotation), turned_y = sin(arc->rotation);
    const double a = arc->semi_axis[0] * turned_y, b = arc->semi_axis[1] * turned_x;
    const double level = p[1] - arc->centre[1], reach = hypot(a, b);
    const double low = fmin(arc->from, arc->to), high = fmax(arc->from, arc->to);
    double middle, half;
    if (!(fabs(level) < reach)) continue;
    middle = atan2(b, a);
    half = acos(level / reach);
    for (root = -1; root <= 1; root += 2) {
      const double t = middle + root * half;
      const double x = arc->centre[0] + arc->semi_axis[0] * cos(t) * turned_x - arc->semi_axis[1] * sin(t) * turned_y;
      if (x < p[0]) continue;
      for (lap = -3; lap <= 3; ++lap) {
        const double at = t + 2 * pi * lap;
        if (at < low || at >= high) continue;
        /* the arc goes upwards at the root before its top, which is root -1 */
        turns += (root < 0) == (arc->to > arc->from) ? 1 : -1;
      }
    }
  }
  return turns;
}

/* 1 if ball j is farther than ball i, 0 if not, -1 if that is not for sure. */
static int farther(const scene *s, uint32_t j, uint32_t i) {
  const double gap = s->balls.position[i][2] - s->balls.position[j][2];
  if (s->piece[i] != HSP_NONE && s->piece[j] != HSP_NONE) return s->piece[j] < s->piece[i];
  return fabs(gap) <= s->balls.margin ? -1 : gap > 0;
}

/* Whether the point of ball i's front hemisphere over p is cut away: 1, 0, or -1 if that is not for sure. */
static int cut_away(const scene *s, uint32_t i, const double p[2]) {
  const view_result *v = s->v;
  const computed *c = v->base;
  const double point[3] = {p[0], p[1], front_height(&s->balls, i, p)};
  const int all_cut = (v->options.flags & HSP_VIEW_ALL_BALLS) != 0 && !v->with_boundary;
  int perhaps = 0;
  uint32_t j;
  for (j = 0; j < c->n; ++j) {
    double apart[3], depth;
    int sure = 1;
    if (j == i) continue;
    difference(point, s->balls.position[j], apart);
    depth = c->radius[j] - length(apart);
    if (depth < -s->balls.margin) continue;
    if (depth < s->balls.margin) sure = 0;
    if (v->options.pieces == HSP_PIECES_OUTSIDE_FARTHER) {
      const int is_farther = farther(s, j, i);
      if (is_farther == 0) continue;
      if (is_farther < 0) sure = 0;
      /* hidden balls may be left out, and balls inside others do not matter */
      if (s->piece[j] == HSP_NONE && (!all_cut || s->contained[j])) sure = 0;
    }
    if (sure) return 1;
    perhaps = 1;
  }
  return perhaps ? -1 : 0;
}

/* Whether a point is beyond the silhouette of a piece's ball, and so outside its loops. */
static int outside_disc(const hsp_view_piece *piece, const double p[2]) {
  return hypot(p[0] - piece->centre[0], p[1] - piece->centre[1]) > piece->radius * (1 + 1e-9);
}

decided_count view_pieces_decided, view_sights_decided;

static const char *broken_at(const scene *s, uint32_t i, const double p[2]) {
  const view_result *v = s->v;
  const int cut = cut_away(s, i, p);
  const uint32_t visible = seen_ball(&s->balls, p);
  count_decided(&view_sights_decided, visible != UNSURE_BALL);
  if (s->piece[i] != HSP_NONE) count_decided(&view_pieces_decided, cut >= 0);
  if (s->piece[i] != HSP_NONE) {
    const int turns = winding(v, s->piece[i], p);
    if (turns != 0 && turns != 1) return "loops of a piece wind about a point neither once nor not at all";
    if (cut == 0 && turns != 1) return "a point of a piece is not inside its loops";
    if (cut == 1 && turns != 0) return "a point that is cut away is inside the loops of a piece";
  } else if (cut == 0 && (v->options.flags & HSP_VIEW_ALL_BALLS) != 0 && !s->contained[i] &&
             (v->options.pieces == HSP_PIECES_OUTSIDE_ALL || !v->with_boundary)) {
    /* with a boundary, balls without faces have no G-piece */
    return "a ball has no piece although something is left of it";
  }
  if (visible < UNSURE_BALL) {
    uint32_t k = v->info.pieces;
    while (k > 0 && (outside_disc(&v->pieces[k - 1], p) || winding(v, k - 1, p) == 0)) --k;
    if (k == 0) return "nothing is painted where a ball is seen";
    if (v->pieces[k - 1].ball != visible) return "what is painted last is not what is seen";
  }
  return NULL;
}

const char *broken_view_regions(const view_result *v, uint32_t samples, uint64_t seed) {
  const computed *c = v->base;
  const char *broken = NULL;
  uint64_t state = seed;
  scene s;
  uint32_t i, k;
  scene_make(v, &s);
  for (i = 0; i < c->n && broken == NULL; ++i) {
    if (c->radius[i] <= 1000 * s.balls.margin) continue;
    for (k = 0; k < samples && broken == NULL; ++k) {
      const double part = 0.999 * sqrt(random_fraction(&state)), angle = 2 * pi * random_fraction(&state);
      int tries;
      /* A defect covers an area. An effect of rounding on an arc is gone a little aside: hence three tries. */
      for (tries = 0; tries < 3; ++tries) {
        const double aside = 1e-5 * tries;
        const double p[2] = {s.balls.position[i][0] + (part - aside) * c->radius[i] * cos(angle + aside),
                             s.balls.position[i][1] + (part - aside) * c->radius[i] * sin(angle + aside)};
        broken = broken_at(&s, i, p);
        if (broken == NULL) break;
      }
    }
  }
  scene_release(&s);
  return broken;
}
