/* The promises of the header's topology section for every set of topology_sets.h and several orders of its balls, what
 * must not depend on the order, the place and the names of the axes, and the sets whose topology is known. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "topology_invariants.h"
#include "topology_sets.h"

static int made(const ball_set *set, computed *c, topology_result *t) {
  memset(t, 0, sizeof *t);
  if (!CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, c), HSP_OK)) return 0;
  return CHECK_EQUAL(topology_result_make(c, t), HSP_OK);
}

static void release(computed *c, topology_result *t) {
  topology_result_release(t);
  computed_release(c);
}

static void check_sound(const topology_result *t) {
  const char *broken = broken_topology(t);
  check_true(broken == NULL, broken == NULL ? "topology" : broken, __FILE__, __LINE__);
}

/* hsp_topology_compute, property 1. */
static void any_order(const ball_set *set, const topology_result *reference) {
  static ball_set permuted;
  uint32_t order[BALL_SET_MOST], i;
  int round;
  for (round = 0; round < 4; ++round) {
    computed c;
    topology_result t;
    if (round == 0) {
      for (i = 0; i < set->n; ++i) order[i] = set->n - 1 - i;
    } else {
      ball_set_shuffle(set->n, (uint64_t)round + 40, order);
    }
    check_scene("%s, order %d", set->name, round);
    ball_set_permute(set, order, &permuted);
    if (made(&permuted, &c, &t)) {
      const char *what = topology_difference_after_permutation(reference, &t);
      check_sound(&t);
      check_true(what == NULL, what == NULL ? "order" : what, __FILE__, __LINE__);
    }
    release(&c, &t);
  }
}

/* The same number whatever the shells' order: what a motion must not change. */
static uint64_t shells_alike(const topology_result *t) {
  uint64_t sum = 0;
  uint32_t i;
  for (i = 0; i < t->counts.shells; ++i) {
    const hsp_shell *s = t->shells + i;
    uint64_t hash = (uint64_t)(s->euler + 100000) * 8 + s->kind * 2 + (s->region == 0);
    hash = (hash ^ t->components[s->component].balls) * UINT64_C(0x9E3779B97F4A7C15);
    hash = (hash ^ hash >> 30 ^ t->components[s->component].shells) * UINT64_C(0xBF58476D1CE4E5B9);
    hash = (hash ^ hash >> 27 ^ t->regions[s->region].shells) * UINT64_C(0x94D049BB133111EB);
    sum += hash ^ hash >> 31;
  }
  return sum;
}

static void any_place(const ball_set *set, const topology_result *reference) {
  static const double shifts[2][3] = {{-1000, 2000, 3000}, {12345, -54321, 4096}};
  static ball_set moved;
  uint32_t i, axis;
  int s;
  for (s = 0; s < 2; ++s) {
    computed c;
    topology_result t;
    check_scene("%s, moved by %g %g %g", set->name, shifts[s][0], shifts[s][1], shifts[s][2]);
    moved = *set;
    for (i = 0; i < set->n; ++i) {
      for (axis = 0; axis < 3; ++axis) moved.xyz[3 * i + axis] += shifts[s][axis];
    }
    if (made(&moved, &c, &t)) {
      check_sound(&t);
      CHECK_EQUAL(t.counts.vertices, reference->counts.vertices);
      CHECK_EQUAL(t.counts.edges, reference->counts.edges);
      CHECK_EQUAL(t.counts.simple_faces, reference->counts.simple_faces);
      CHECK_EQUAL(t.counts.cut_edges, reference->counts.cut_edges);
      CHECK(shells_alike(&t) == shells_alike(reference));
    }
    release(&c, &t);
  }
}

/* Cut arcs depend on which axis is called z, and ties may be broken otherwise, but shells, components and regions are
 * those of the closed balls. */
static void any_axes(const ball_set *set, const topology_result *reference) {
  static const int axes[5][3] = {{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  static ball_set turned;
  uint32_t i, axis;
  int a;
  for (a = 0; a < 5; ++a) {
    computed c;
    topology_result t;
    check_scene("%s, axes %d %d %d", set->name, axes[a][0], axes[a][1], axes[a][2]);
    turned = *set;
    for (i = 0; i < set->n; ++i) {
      for (axis = 0; axis < 3; ++axis) {
        turned.xyz[3 * i + axis] = (a % 2 == 0 ? 1 : -1) * set->xyz[3 * i + (uint32_t)axes[a][axis]];
      }
    }
    if (made(&turned, &c, &t)) {
      check_sound(&t);
      CHECK_EQUAL(t.counts.regions, reference->counts.regions);
      CHECK(shells_alike(&t) == shells_alike(reference));
    }
    release(&c, &t);
  }
}

/* hsp_topology_limits_init tells the boundary's own numbers where there is nothing to estimate, and its limits lead to
 * the same topology. */
static void limits_for(const topology_result *t) {
  const computed *c = t->base;
  hsp_topology_limits limits;
  hsp_topology *topology = NULL;
  hsp_topology_counts counts;
  uint32_t i, many_loops = 0;
  size_t bytes = 0;
  void *memory;
  for (i = 0; i < c->counts.faces; ++i) many_loops += c->faces[i].loops > 1 ? c->faces[i].loops - 1 : 0;
  if (!CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, c->boundary), HSP_OK)) return;
  CHECK_EQUAL(limits.struct_size, sizeof limits);
  CHECK_EQUAL(limits.shells, c->counts.shells);
  CHECK_EQUAL(limits.balls, c->n);
  CHECK_EQUAL(limits.neighbours, c->needed.neighbours);
  CHECK(limits.edges >= c->counts.arcs + 2 * c->counts.circles);
  if (many_loops == 0) {
    CHECK(limits.edges >= t->needed.edges);
    CHECK(limits.cut_arcs >= t->needed.cut_arcs);
  }
  CHECK_EQUAL(hsp_topology_bytes(&limits, &bytes), HSP_OK);
  memory = malloc(bytes);
  if (memory == NULL) exit(2);
  CHECK_EQUAL(hsp_topology_init(memory, bytes, &limits, &topology), HSP_OK);
  if (limits.edges >= t->needed.edges && limits.cut_arcs >= t->needed.cut_arcs) {
    CHECK_EQUAL(hsp_topology_compute(topology, c->boundary, NULL), HSP_OK);
    CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
    CHECK_BYTES(&counts, &t->counts, sizeof counts);
  } else {
    CHECK_EQUAL(hsp_topology_compute(topology, c->boundary, NULL), HSP_E_CAPACITY);
  }
  free(memory);
}

static void every_set(void) {
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    static ball_set set;
    computed c;
    topology_result t;
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    if (made(&set, &c, &t)) {
      check_sound(&t);
      limits_for(&t);
      any_order(&set, &t);
      any_place(&set, &t);
      any_axes(&set, &t);
    }
    release(&c, &t);
  }
}

/* ---- known topologies ---- */

typedef struct known {
  void (*make)(ball_set *);
  uint32_t components, regions, shells;
  uint32_t genus_outside, genus_inside; /* sums over shells */
} known;

static void whole_spheres(ball_set *set) {
  ball_set_start(set, "three balls apart and one inside", 1e-8);
  ball_set_add(set, 0, 0, 0, 1);
  ball_set_add(set, 0, 0, 5, 2);
  ball_set_add(set, 9, 0, 0, 3);
  ball_set_add(set, 9, 1, 0, 1);
}

static void known_sets(void) {
  static const known sets[] = {{whole_spheres, 3, 1, 3, 0, 0},
                               {topology_set_nested, 4, 4, 7, 0, 0},
                               {topology_set_two_in_a_void, 3, 2, 4, 0, 0},
                               {topology_set_linked_rings, 2, 1, 2, 2, 0},
                               {topology_set_cage, 1, 1, 1, 2, 0},
                               {topology_set_ring_cavity, 1, 2, 2, 0, 1},
                               {topology_set_scaffold, 1, 1, 1, 176, 0},
                               {topology_set_thirty_on_one, 1, 1, 1, 0, 0}};
  size_t k;
  for (k = 0; k < sizeof sets / sizeof sets[0]; ++k) {
    static ball_set set;
    computed c;
    topology_result t;
    uint32_t i, outside = 0, inside = 0;
    sets[k].make(&set);
    check_scene("%s", set.name);
    if (made(&set, &c, &t)) {
      CHECK_EQUAL(t.counts.components, sets[k].components);
      CHECK_EQUAL(t.counts.regions, sets[k].regions);
      CHECK_EQUAL(t.counts.shells, sets[k].shells);
      for (i = 0; i < t.counts.shells; ++i) {
        if (t.shells[i].kind == HSP_SHELL_OUTER) outside += t.shells[i].genus;
        if (t.shells[i].kind == HSP_SHELL_VOID) inside += t.shells[i].genus;
      }
      CHECK_EQUAL(outside, sets[k].genus_outside);
      CHECK_EQUAL(inside, sets[k].genus_inside);
    }
    release(&c, &t);
  }
}

/* Balls 0, 26, 52 and 78 are of the outer, middle and inner wall and the ball in the middle. */
static void nesting(void) {
  static ball_set set;
  computed c;
  topology_result t;
  uint32_t i;
  topology_set_nested(&set);
  check_scene("%s", set.name);
  if (made(&set, &c, &t)) {
    uint32_t component[4], within[4];
    for (i = 0; i < 4; ++i) {
      component[i] = c.balls[26 * i].component;
      within[i] = t.components[component[i]].region;
      CHECK_EQUAL(t.components[component[i]].shells, i < 3 ? 2 : 1);
      CHECK_EQUAL(t.components[component[i]].balls, i < 3 ? 26 : 1);
    }
    CHECK_EQUAL(within[0], 0);
    for (i = 1; i < 4; ++i) {
      const hsp_region *region = t.regions + within[i];
      if (!CHECK(within[i] != 0 && within[i] < t.counts.regions)) continue;
      CHECK_EQUAL(t.shells[region->enclosing_shell].component, component[i - 1]);
      CHECK_EQUAL(region->components, 1);
      CHECK_EQUAL(region->shells, 2);
      /* the walls are the same but for their size */
      CHECK_NEAR(t.shells[region->enclosing_shell].volume * (i == 1   ? 1.0 / 512
                                                             : i == 2 ? 1
                                                                      : 512),
                 t.shells[t.regions[within[2]].enclosing_shell].volume,
                 1e-9 * t.shells[t.regions[within[2]].enclosing_shell].volume);
    }
    CHECK_EQUAL(t.counts.start_face, t.shells[t.components[component[0]].outer_shell].start_face);
  }
  release(&c, &t);
}

/* One ball: two vertices in its poles, two edges of half a circle, two simple faces. */
static void one_ball(void) {
  static ball_set set;
  computed c;
  topology_result t;
  uint32_t i;
  ball_set_start(&set, "one ball", 1e-8);
  ball_set_add(&set, 1.25, -2.5, 3.75, 1.5);
  check_scene("%s", set.name);
  if (made(&set, &c, &t)) {
    CHECK_EQUAL(t.counts.vertices, 2);
    CHECK_EQUAL(t.counts.edges, 2);
    CHECK_EQUAL(t.counts.cut_edges, 2);
    CHECK_EQUAL(t.counts.simple_faces, 2);
    for (i = 0; i < 2; ++i) {
      CHECK_EQUAL(t.vertices[i].kind, HSP_POINT_POLE);
      CHECK_NEAR(t.edges[i].angle, 3.14159265358979324, 1e-15);
    }
    CHECK_NEAR(t.vertices[0].xyz[2] + t.vertices[1].xyz[2], 7.5, 0);
    CHECK_NEAR(t.shells[0].area, 28.274333882308138, 1e-13);
    CHECK_NEAR(t.shells[0].volume, 14.137166941154069, 1e-13);
    CHECK_EQUAL(t.components[0].top_ball, 0);
    CHECK_EQUAL(t.counts.start_face, t.shells[0].start_face);
  }
  release(&c, &t);
}

/* No balls: nothing but the outer region. */
static void no_balls(void) {
  static ball_set set;
  computed c;
  topology_result t;
  ball_set_start(&set, "no balls", 1e-8);
  check_scene("%s", set.name);
  if (made(&set, &c, &t)) {
    CHECK_EQUAL(t.counts.vertices, 0);
    CHECK_EQUAL(t.counts.edges, 0);
    CHECK_EQUAL(t.counts.simple_faces, 0);
    CHECK_EQUAL(t.counts.shells, 0);
    CHECK_EQUAL(t.counts.components, 0);
    CHECK_EQUAL(t.counts.regions, 1);
    CHECK_EQUAL(t.counts.start_face, HSP_NONE);
    CHECK_EQUAL(t.regions[0].enclosing_shell, HSP_NONE);
    CHECK_EQUAL(t.regions[0].shells, 0);
    CHECK_NEAR(t.regions[0].area, 0, 0);
  }
  release(&c, &t);
}

int main(void) {
  no_balls();
  one_ball();
  known_sets();
  nesting();
  every_set();
  check_scene("%s", "all sets");
  CHECK(mostly_decided(&face_areas_decided, 0.9));
  CHECK(mostly_decided(&start_faces_decided, 0.7));
  return check_report();
}
