/* The owners seen at points of the view plane, on faces and on both sides of edges, against the fronts of all balls. */
#include <math.h>
#include <stdlib.h>

#include "map_invariants.h"
#include "placed_balls.h"
#include "random_numbers.h"
#include "vectors.h"

decided_count map_points_decided, map_sides_decided;

static const char *broken_sight(const map_result *m, const placed_balls *balls, const double p[2]) {
  const uint32_t seen = seen_ball(balls, p);
  hsp_map_sight sight;
  count_decided(&map_points_decided, seen != UNSURE_BALL);
  if (seen == UNSURE_BALL) return NULL;
  if (hsp_map_pick(m->map, p[0], p[1], &sight) != HSP_OK) return "hsp_map_pick fails";
  if (sight.ball != seen) return "hsp_map_pick finds another ball than the highest";
  if (seen == HSP_NONE) {
    if (sight.depth != -INFINITY) return "the background has a depth";
  } else {
    /* At a steep place of a ball's front a small move of the ball changes the depth by more. */
    const double front = front_height(balls, seen, p);
    const double steep = balls->c->radius[seen] / fmax(1e-9, front - balls->position[seen][2]);
    if (!near(sight.depth, front, balls->margin + 4 * steep * m->info.perturbation))
      return "hsp_map_pick finds another depth";
  }
  if (sight.face >= m->info.faces) return "no face away from all edges";
  if (m->faces[sight.face].ball != seen) return "the face at a point shows another ball";
  return NULL;
}

/* The owners a little to the left and to the right of an edge, where no other edge is as close. */
static const char *broken_sides(const map_result *m, const placed_balls *balls, uint32_t e) {
  const hsp_map_edge *edge = &m->edges[e];
  const double t = edge->from + 0.4 * (edge->to - edge->from);
  const double forward[2] = {cos(t) * edge->second[0] - sin(t) * edge->first[0],
                             cos(t) * edge->second[1] - sin(t) * edge->first[1]};
  const double speed = hypot(forward[0], forward[1]), radius = balls->c->radius[edge->ball[0]];
  hsp_map_point point;
  int side;
  if (hsp_map_get_point(m->map, e, t, &point) != HSP_OK) return "no point in the middle of an edge";
  if (edge->ball[1] == HSP_NONE) {
    if (point.gap[0] != 0) return "a gap on the left of a silhouette";
    if (m->faces[edge->face[0]].ball != edge->ball[0]) return "a silhouette has another ball on its left";
    if (isinf(point.gap[1]) != (m->faces[edge->face[1]].ball == HSP_NONE)) return "the gap to the background";
  } else {
    if (point.gap[0] != 0 || point.gap[1] != 0) return "a gap beside a crease";
    if (m->faces[edge->face[0]].ball != edge->ball[0]) return "a crease has another ball on its left";
    if (m->faces[edge->face[1]].ball != edge->ball[1]) return "a crease has another ball on its right";
  }
  /* The curve turns away from its tangent by less than a hundredth of the step aside. */
  if (speed * (edge->to - edge->from) < 0.02 * radius) {
    map_sides_decided.all += 2;
    return NULL;
  }
  for (side = 0; side < 2; ++side) {
    const double aside = (side == 0 ? 1e-3 : -1e-3) * radius / speed;
    const double p[2] = {point.xyz[0] - aside * forward[1], point.xyz[1] + aside * forward[0]};
    const uint32_t seen = seen_ball(balls, p), expected = m->faces[edge->face[side]].ball;
    hsp_map_sight sight;
    /* another edge may be as close */
    const int is_decided =
        seen != UNSURE_BALL && hsp_map_pick(m->map, p[0], p[1], &sight) == HSP_OK && sight.face == edge->face[side];
    count_decided(&map_sides_decided, is_decided);
    if (!is_decided) continue;
    if (seen != expected) return "beside an edge another ball is seen than its face says";
    if (seen != HSP_NONE && edge->ball[1] == HSP_NONE && side == 1 &&
        !near(point.xyz[2] - point.gap[1], front_height(balls, seen, p), 0.1 * radius))
      return "the gap behind a silhouette";
  }
  return NULL;
}

const char *broken_map_regions(const map_result *m, uint32_t samples, uint64_t seed) {
  const computed *c = m->base;
  const char *broken = NULL;
  uint64_t state = seed;
  placed_balls balls;
  uint32_t i, k;
  placed_balls_make(c, m->info.origin, m->info.right, m->info.up, m->info.towards, &balls);
  balls.margin += 4 * m->info.perturbation;
  for (i = 0; i < c->n && broken == NULL; ++i) {
    if (c->radius[i] <= 1000 * balls.margin) continue;
    for (k = 0; k < samples && broken == NULL; ++k) {
      const double part = 1.2 * sqrt(random_fraction(&state)), angle = 2 * pi * random_fraction(&state);
      const double p[2] = {balls.position[i][0] + part * c->radius[i] * cos(angle),
                           balls.position[i][1] + part * c->radius[i] * sin(angle)};
      broken = broken_sight(m, &balls, p);
    }
  }
  for (k = 0; k < m->info.edges && broken == NULL; ++k) broken = broken_sides(m, &balls, k);
  placed_balls_release(&balls);
  return broken;
}
