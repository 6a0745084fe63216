/* The header's promises for every map of balls and sticks, for every set of topology_sets.h as it is and with smaller
 * balls that show their sticks: its records, no effect of the order of the balls, every limit and alignment. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "limit_sweep.h"
#include "map_record_invariants.h"
#include "sticks_result.h"
#include "topology_sets.h"
#include "vectors.h"

enum { DIRECTIONS = 4 };
static const double directions[DIRECTIONS][3] = {{0, 0, 1}, {0.3, 0.7, -0.2}, {0, -1, 1}, {3, -4, 12}};

static hsp_view_options options_for(uint32_t direction) {
  hsp_view_options options;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  memcpy(options.towards, directions[direction], sizeof options.towards);
  return options;
}

static void check_nothing_broken(const char *broken) {
  if (!CHECK(broken == NULL)) check_true(0, broken, __FILE__, __LINE__);
}

static void same_results(const void *handle, const void *source) {
  const sticks_result *s = source;
  hsp_sticks_info info;
  hsp_map_info map;
  CHECK_EQUAL(hsp_sticks_get_info(handle, &info), HSP_OK);
  CHECK_BYTES(&info, &s->info, sizeof info);
  CHECK_EQUAL(hsp_sticks_get_map_info(handle, &map), HSP_OK);
  CHECK_BYTES(&map, &s->map, sizeof map);
}
static void no_results(const void *handle) {
  hsp_sticks_info info;
  hsp_map_info map;
  CHECK_EQUAL(hsp_sticks_get_info(handle, &info), HSP_E_STATE);
  CHECK_EQUAL(hsp_sticks_get_map_info(handle, &map), HSP_E_STATE);
}

/* A call that uses scratch memory. */
static void check_map(void *handle, const void *source) {
  uint32_t invariant = 1, id = 1;
  (void)source;
  CHECK_EQUAL(hsp_sticks_check(handle, &invariant, &id), HSP_OK);
  CHECK(invariant == 0 && id == HSP_NONE);
}

static size_t macro(const limit_numbers *limits) {
  return HSP_STICKS_BYTES(limits->number[1], limits->number[2], limits->number[3], limits->number[4]);
}

static void sizes(void) {
  static const uint32_t values[] = {0, 1, 3, 8, 9, 65, 1000, 4097, 0x0FFFFFFF};
  static const size_bound bound = {macro, {16384, 192, 384, 20, 400}, 0};
  check_scene("sizes");
  sweep_sizes(&sticks_handle, &bound, values, sizeof values / sizeof values[0]);
}

static const char *broken_records(const sticks_result *s) {
  map_records records = {&s->map, s->vertices, s->edges, s->faces, s->area, s->base->n, s->count, 0, s->base->extent};
  uint32_t i;
  for (i = 0; i < s->base->n; ++i) records.largest = fmax(records.largest, s->base->radius[i]);
  return broken_map_records(&records);
}

/* Points of edges: on their curves, with the ends at the vertices, and nothing nearer on the right of a contour. */
static const char *broken_points(const sticks_result *s) {
  const double close = 1e-5 * s->base->extent;
  uint32_t e;
  int k;
  for (e = 0; e < s->map.edges; ++e) {
    const hsp_map_edge *edge = &s->edges[e];
    for (k = 0; k <= 4; ++k) {
      const double t = k == 4 ? edge->to : edge->from + 0.25 * k * (edge->to - edge->from);
      const double *v = s->vertices[edge->vertex[k / 4]].xyz;
      hsp_map_point point;
      int axis;
      if (hsp_sticks_get_point(s->sticks, e, t, &point) != HSP_OK) return "a point of an edge";
      for (axis = 0; axis < 2; ++axis) {
        const double on = edge->centre[axis] + cos(t) * edge->first[axis] + sin(t) * edge->second[axis];
        if (fabs(point.xyz[axis] - on) > close) return "a point beside its curve";
        if (k % 4 == 0 && fabs(point.xyz[axis] - v[axis]) > close) return "an end beside its vertex";
      }
      if (point.gap[0] != 0 || point.gap[1] < 0) return "a gap";
      if (edge->ball[1] != HSP_NONE && point.gap[1] != 0) return "a gap at a crease";
      if (edge->ball[1] == HSP_NONE && (s->faces[edge->face[1]].ball == HSP_NONE) != (isinf(point.gap[1]) != 0))
        return "a gap before the background";
    }
  }
  return NULL;
}

/* Poles: the middles of circles within their faces, no edge nearer than their radius. */
static const char *broken_poles(const sticks_result *s) {
  uint32_t f, e;
  int k;
  for (f = 1; f < s->map.faces; ++f) {
    hsp_map_pole pole;
    hsp_map_sight sight;
    if (hsp_sticks_get_pole(s->sticks, f, &pole) != HSP_OK) return "the pole of a face";
    if (!(pole.radius >= 0 && pole.bound >= pole.radius)) return "the radius of a pole";
    if (3.1415 * pole.radius * pole.radius > s->faces[f].area * (1 + 1e-6)) return "a circle larger than its face";
    if (pole.radius < 1e-3 * s->base->extent) continue;
    if (hsp_sticks_pick(s->sticks, pole.centre[0], pole.centre[1], &sight) != HSP_OK || sight.face != f)
      return "a pole in another face";
    for (e = 0; e < s->map.edges; ++e) {
      if (s->edges[e].face[0] != f && s->edges[e].face[1] != f) continue;
      for (k = 0; k <= 8; ++k) {
        const double t = s->edges[e].from + 0.125 * k * (s->edges[e].to - s->edges[e].from);
        const hsp_map_edge *edge = &s->edges[e];
        const double x = edge->centre[0] + cos(t) * edge->first[0] + sin(t) * edge->second[0] - pole.centre[0];
        const double y = edge->centre[1] + cos(t) * edge->first[1] + sin(t) * edge->second[1] - pole.centre[1];
        if (sqrt(x * x + y * y) < pole.radius - 1e-6 * s->base->extent) return "an edge within the circle of a pole";
      }
    }
  }
  return NULL;
}

/* Outlines: every loop around a face that shows something is one of one ball's or half's. */
static const char *broken_outlines(const sticks_result *s) {
  uint32_t ball, needed, k, f, loops = 0, outlines = 0;
  uint32_t h[200];
  for (f = 1; f < s->map.faces; ++f) loops += s->faces[f].ball == HSP_NONE ? 0 : s->faces[f].loops;
  for (ball = 0; ball < s->base->n + 2 * s->count; ++ball) {
    const int32_t status = hsp_sticks_get_outline(s->sticks, ball, h, 200, &needed);
    if (status != HSP_OK) return "an outline";
    if ((needed > 0) != (s->area[ball] > 0)) return "an outline of what is not seen";
    outlines += needed;
    for (k = 0; k < needed; ++k) {
      uint32_t steps = 0, along = h[k];
      do {
        const hsp_map_edge *edge = &s->edges[along / 2];
        if (s->faces[edge->face[along % 2]].ball != ball) return "an outline with another one on its left";
        along = edge->next[along % 2];
      } while (along != h[k] && ++steps < 2 * s->map.edges);
      if (along != h[k]) return "an outline that does not close";
    }
  }
  return outlines == loops ? NULL : "loops that are no outline, or of two";
}

static const char *difference_after_permutation(const sticks_result *s, const sticks_result *w) {
  if (s->info.paths != w->info.paths || s->info.balls != w->info.balls) return "paths depend on the order of the balls";
  if (s->map.vertices != w->map.vertices || s->map.edges != w->map.edges || s->map.faces != w->map.faces ||
      s->map.components != w->map.components)
    return "the map depends on the order of the balls";
  if (s->map.perturbation != w->map.perturbation) return "how far balls are moved depends on their order";
  return near(s->map.area, w->map.area, 1e-9 * s->map.area) ? NULL : "the area depends on the order of the balls";
}

typedef struct tally {
  uint32_t maps, moved, sticks, halves, sweeps;
} tally;

static void one_map(const computed *c, const computed *other, const uint32_t *place, uint32_t direction, tally *of) {
  const hsp_view_options options = options_for(direction);
  sticks_result s, w;
  uint32_t k;
  memset(&w, 0, sizeof w);
  if (CHECK_EQUAL(sticks_result_make(c, &options, &s), HSP_OK) &&
      CHECK_EQUAL(sticks_result_make_like(other, &s, place, &w), HSP_OK)) {
    const known_handle known = {&sticks_handle, &s, &s.needed, same_results, no_results, NULL};
    ++of->maps;
    of->moved += s.map.perturbation > 0;
    of->sticks += s.count;
    for (k = 0; k < 2 * s.count; ++k) of->halves += s.area[c->n + k] > 0;
    CHECK(s.enlargements <= 12);
    check_nothing_broken(broken_records(&s));
    check_nothing_broken(broken_points(&s));
    check_nothing_broken(broken_poles(&s));
    check_nothing_broken(broken_outlines(&s));
    check_map(s.sticks, NULL);
    check_nothing_broken(difference_after_permutation(&s, &w));
    if (s.count > 0 && c->n <= 8) {
      ++of->sweeps;
      sweep_limits(&known, "sticks");
      if (c->n < 6) sweep_alignments(&known, check_map);
    }
  }
  sticks_result_release(&s);
  sticks_result_release(&w);
}

static void every_set(void) {
  static ball_set set, shuffled;
  static uint32_t order[BALL_SET_MOST], place[BALL_SET_MOST];
  tally of = {0, 0, 0, 0, 0};
  uint32_t which, i;
  int small;
  for (which = 0; which < topology_set_count(); ++which) {
    for (small = 0; small < 2; ++small) {
      computed c, other;
      topology_set_make(which, &set);
      if (set.n > 150) continue;
      for (i = 0; small && i < set.n; ++i) set.radius[i] *= 0.25;
      ball_set_shuffle(set.n, which + 1, order);
      ball_set_permute(&set, order, &shuffled);
      for (i = 0; i < set.n; ++i) place[order[i]] = i;
      check_scene("%s, smaller balls: %d", set.name, small);
      if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK) &&
          CHECK_EQUAL(computed_make(set.n, shuffled.xyz, shuffled.radius, NULL, &other), HSP_OK)) {
        one_map(&c, &other, place, which % DIRECTIONS, &of);
        computed_release(&other);
      }
      computed_release(&c);
    }
  }
  check_scene("%s", "");
  CHECK(of.maps > 50 && of.moved > 0 && of.sticks > 200 && of.halves > 200 && of.sweeps > 5);
}

int main(void) {
  sizes();
  every_set();
  return check_report();
}
