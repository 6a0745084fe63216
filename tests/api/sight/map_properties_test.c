/* The header's promises for every map, for every set of topology_sets.h from several directions: its invariants, what
 * is seen, no effect of the order of the balls, every limit. And maps that are known. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "limit_sweep.h"
#include "map_invariants.h"
#include "topology_sets.h"
#include "vectors.h"

enum { DIRECTIONS = 6 };
static const double directions[DIRECTIONS][3] = {{0, 0, 1}, {1, 0, 0},   {0, -1, 1},
                                                 {1, 1, 1}, {3, -4, 12}, {0.3, 0.7, -0.2}};

static hsp_view_options options_for(int direction) {
  hsp_view_options options;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  memcpy(options.towards, directions[direction], sizeof options.towards);
  return options;
}

static void check_nothing_broken(const char *broken) {
  if (!CHECK(broken == NULL)) check_true(0, broken, __FILE__, __LINE__);
}

static void same_results(const void *handle, const void *source) {
  const map_result *m = source;
  hsp_map_info info;
  CHECK_EQUAL(hsp_map_get_info(handle, &info), HSP_OK);
  CHECK_BYTES(&info, &m->info, sizeof info);
}
static void no_results(const void *handle) {
  hsp_map_info info;
  CHECK_EQUAL(hsp_map_get_info(handle, &info), HSP_E_STATE);
  CHECK_EQUAL(hsp_map_next(handle, 0), HSP_NONE);
}

static size_t macro(const limit_numbers *limits) {
  return HSP_MAP_BYTES(limits->number[1], limits->number[2], limits->number[3]);
}

static void sizes(void) {
  static const uint32_t values[] = {0, 1, 3, 8, 9, 17, 65, 1000, 1024, 1025, 4097, 0x0FFFFFFF};
  static const size_bound bound = {macro, {32768, 288, 208, 352}, 0};
  check_scene("sizes");
  sweep_sizes(&map_handle, &bound, values, sizeof values / sizeof values[0]);
}

static void every_set(void) {
  static ball_set set, shuffled;
  static uint32_t order[BALL_SET_MOST];
  uint32_t which, maps = 0, moved = 0;
  int direction;
  for (which = 0; which < topology_set_count(); ++which) {
    computed c, other;
    topology_set_make(which, &set);
    ball_set_shuffle(set.n, which + 1, order);
    ball_set_permute(&set, order, &shuffled);
    check_scene("%s", set.name);
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(computed_make(set.n, shuffled.xyz, shuffled.radius, NULL, &other), HSP_OK);
    for (direction = (int)(which % 2); direction < DIRECTIONS; direction += 2) {
      const hsp_view_options options = options_for(direction);
      map_result m, w;
      check_scene("%s, direction %d", set.name, direction);
      memset(&w, 0, sizeof w);
      if (CHECK_EQUAL(map_result_make(&c, &options, &m), HSP_OK) &&
          CHECK_EQUAL(map_result_make(&other, &options, &w), HSP_OK)) {
        const known_handle known = {&map_handle, &m, &m.needed, same_results, no_results, NULL};
        ++maps;
        moved += m.info.perturbation > 0;
        CHECK(m.enlargements <= 12);
        check_nothing_broken(broken_map(&m));
        check_nothing_broken(broken_map_regions(&m, set.n < 40 ? 24 : 6, which));
        /* hsp_map_compute, property 1 */
        check_nothing_broken(map_difference_after_permutation(&m, &w));
        if (set.n <= 8 && direction < 2) sweep_limits(&known, set.name);
        if (set.n > 3 && set.n < 6) sweep_alignments(&known, NULL);
      }
      map_result_release(&m);
      map_result_release(&w);
    }
    computed_release(&c);
    computed_release(&other);
  }
  check_scene("%s", "");
  CHECK(maps > 100);
  CHECK(3 * moved < 2 * maps && moved > 0);
}

/* ---- maps that are known ---- */

static void known(const ball_set *set, int direction, uint32_t vertices, uint32_t edges, uint32_t faces, map_result *m,
                  computed *c) {
  const hsp_view_options options = options_for(direction);
  check_scene("%s, direction %d", set->name, direction);
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, c), HSP_OK);
  CHECK_EQUAL(map_result_make(c, &options, m), HSP_OK);
  CHECK_EQUAL(m->info.vertices, vertices);
  CHECK_EQUAL(m->info.edges, edges);
  CHECK_EQUAL(m->info.faces, faces);
  check_nothing_broken(broken_map(m));
}

static void release(map_result *m, computed *c) {
  map_result_release(m);
  computed_release(c);
}

static void no_more_than_a_ball(void) {
  ball_set s;
  computed c;
  map_result m;
  int direction;
  for (direction = 0; direction < DIRECTIONS; ++direction) {
    ball_set_start(&s, "no balls", 1e-8);
    known(&s, direction, 0, 0, 1, &m, &c);
    release(&m, &c);
    ball_set_start(&s, "a ball of radius 0", 1e-8);
    ball_set_add(&s, 1, 2, 3, 0);
    known(&s, direction, 0, 0, 1, &m, &c);
    CHECK_EQUAL(m.info.balls, 0);
    release(&m, &c);
    ball_set_start(&s, "equal balls and one inside", 1e-8);
    ball_set_add(&s, 1, 2, 3, 1.25);
    ball_set_add(&s, 1, 2, 3, 1.25);
    ball_set_add(&s, 1, 2.1, 3, 0.5);
    known(&s, direction, 1, 1, 2, &m, &c);
    CHECK_EQUAL(m.info.balls, 1);
    CHECK_EQUAL(m.info.components, 1);
    CHECK_EQUAL(m.vertices[0].kind, HSP_MAP_PLAIN);
    CHECK_EQUAL(hsp_map_next(m.map, 0), 0);
    CHECK_NEAR(m.info.area, pi * 1.25 * 1.25, 1e-13);
    release(&m, &c);
  }
}

/* Two balls of radius 5 whose spheres meet in a circle of radius sqrt(15). The crease ends in two tangencies, and the
 * silhouette of the farther ball goes behind the nearer one in two Ts. */
static void two_balls(void) {
  ball_set s;
  computed c;
  map_result m;
  hsp_map_sight sight;
  uint32_t e, creases = 0, nearer;
  ball_set_start(&s, "two balls of radius 5", 1e-8);
  ball_set_add(&s, 0, 0, 0, 5);
  ball_set_add(&s, 6, 0, 2, 5);
  known(&s, 0, 4, 5, 3, &m, &c);
  CHECK_EQUAL(m.info.components, 1);
  CHECK_EQUAL(m.info.balls, 2);
  for (e = 0; e < m.info.edges; ++e) {
    const hsp_map_edge *edge = &m.edges[e];
    if (edge->ball[1] == HSP_NONE) continue;
    ++creases;
    CHECK_EQUAL(edge->ball[0], 1);
    CHECK_EQUAL(edge->ball[1], 0);
    CHECK_NEAR(hypot(edge->second[0], edge->second[1]), sqrt(25 - 10), 1e-12);
  }
  CHECK_EQUAL(creases, 1);
  CHECK_EQUAL(hsp_map_pick(m.map, -3 - 1, 0, &sight), HSP_OK);
  CHECK_EQUAL(sight.ball, 0);
  CHECK_NEAR(sight.depth, -1 + sqrt(24), 1e-12);
  CHECK_EQUAL(hsp_map_pick(m.map, 3 + 1, 0, &sight), HSP_OK);
  CHECK_EQUAL(sight.ball, 1);
  CHECK_EQUAL(hsp_map_pick(m.map, 1e300, -1e300, &sight), HSP_OK);
  CHECK_EQUAL(sight.ball, HSP_NONE);
  CHECK_EQUAL(sight.face, 0);
  release(&m, &c);

  ball_set_start(&s, "a small ball before a large one", 1e-8);
  ball_set_add(&s, 0, 0, 0, 5);
  ball_set_add(&s, 1, 0, 20, 1);
  known(&s, 0, 2, 2, 3, &m, &c);
  CHECK_EQUAL(m.info.components, 2);
  nearer = m.faces[1].ball == 1 ? 1 : 2;
  CHECK_EQUAL(m.faces[nearer].loops, 1);
  CHECK_EQUAL(m.faces[3 - nearer].loops, 2);
  CHECK_NEAR(m.area[0], 24 * pi, 1e-12);
  CHECK_NEAR(m.area[1], pi, 1e-13);
  CHECK_NEAR(m.info.area, 25 * pi, 1e-12);
  release(&m, &c);
}

/* A ball behind two others: two Ts on each silhouette that hides it, and one face above, below and in the gap. */
static void hidden_partly(void) {
  ball_set s;
  computed c;
  map_result m;
  uint32_t v, ts = 0, count, h[4];
  ball_set_start(&s, "a ball behind two others with a gap", 1e-8);
  ball_set_add(&s, 0, 0, 0, 5);
  ball_set_add(&s, 4.25, 0, 20, 4);
  ball_set_add(&s, -4.25, 0, 20, 4);
  known(&s, 0, 4, 6, 4, &m, &c);
  for (v = 0; v < m.info.vertices; ++v) {
    ts += m.vertices[v].kind == HSP_MAP_T;
    CHECK_EQUAL(m.vertices[v].ball[0], 0);
    CHECK_EQUAL(m.vertices[v].ball[1], HSP_NONE);
    CHECK(m.vertices[v].ball[2] == 1 || m.vertices[v].ball[2] == 2);
  }
  CHECK_EQUAL(ts, 4);
  CHECK_EQUAL(hsp_map_get_outline(m.map, 0, h, 4, &count), HSP_OK);
  CHECK_EQUAL(count, 1);
  release(&m, &c);
}

int main(void) {
  sizes();
  every_set();
  no_more_than_a_ball();
  two_balls();
  hidden_partly();
  check_scene("%s", "all sets");
  CHECK(mostly_decided(&map_points_decided, 0.9));
  CHECK(mostly_decided(&map_sides_decided, 0.6));
  return check_report();
}
