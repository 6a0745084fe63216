#include "topology_sets.h"

#include <math.h>

void topology_set_nested(ball_set *s) {
  ball_set_start(s, "three hollow shells in each other and a ball in the middle", 1e-7);
  ball_set_add_hollow(s, 0, 0, 0, 64);
  ball_set_add_hollow(s, 0, 0, 0, 8);
  ball_set_add_hollow(s, 0, 0, 0, 1);
  ball_set_add(s, 0, 0, 0, 0.125);
}

void topology_set_two_in_a_void(ball_set *s) {
  ball_set_start(s, "two balls in a void", 1e-8);
  ball_set_add(s, -1, 0, 0, 0.5);
  ball_set_add_hollow(s, 0, 0, 0, 8);
  ball_set_add(s, 1, 0, 0, 0.5);
}

void topology_set_linked_rings(ball_set *s) {
  ball_set_start(s, "two linked rings", 1e-8);
  ball_set_add_ring(s, 0, 1, 2.3);
  ball_set_add_ring(s, 5, 2, 2.3);
}

void topology_set_cage(ball_set *s) {
  int i, j, k;
  ball_set_start(s, "a cage with three openings", 1e-8);
  for (i = 0; i < 3; ++i) {
    for (j = 0; j < 3; ++j) {
      for (k = 0; k < 3; ++k) {
        if (i == 1 && j == 1) continue; /* the middle, bottom and top */
        if (i == 0 && j == 1 && k == 1) continue;
        ball_set_add(s, i, j, k, 0.75);
      }
    }
  }
}

void topology_set_ring_cavity(ball_set *s) {
  int i, j, k;
  ball_set_start(s, "a block with a ring-shaped cavity", 1e-8);
  for (i = 0; i < 5; ++i) {
    for (j = 0; j < 5; ++j) {
      for (k = 0; k < 3; ++k) {
        const int inside = i > 0 && i < 4 && j > 0 && j < 4 && k == 1;
        if (!inside || (i == 2 && j == 2)) ball_set_add(s, i, j, k, 0.75);
      }
    }
  }
}

void topology_set_scaffold(ball_set *s) {
  static const int counts[3] = {5, 5, 5};
  static const double spacing[3] = {1, 1, 1};
  ball_set_start(s, "a scaffold with many handles", 1e-8);
  ball_set_add_grid(s, counts, spacing, 0.6);
}

void topology_set_thirty_on_one(ball_set *s) {
  static const double golden_angle = 2.39996322972865332;
  int i;
  ball_set_start(s, "a ball with thirty small ones on it", 1e-8);
  ball_set_add(s, 0, 0, 0, 10);
  for (i = 0; i < 30; ++i) {
    const double z = (2 * i - 29) / 30.0, across = sqrt(1 - z * z);
    ball_set_add(s, floor(1e4 * across * cos(i * golden_angle)) / 1e3,
                 floor(1e4 * across * sin(i * golden_angle)) / 1e3, floor(1e4 * z) / 1e3, 0.8 + 0.01 * (i % 3));
  }
}

/* ---- special positions of poles, axes and the planes of cut arcs ---- */

static void stacked(ball_set *s) {
  int i;
  ball_set_start(s, "four balls above each other", 1e-8);
  for (i = 0; i < 4; ++i) ball_set_add(s, 0, 0, 2 * i, 1.5 - 0.125 * (i % 2));
}

static void polar_caps(ball_set *s) {
  ball_set_start(s, "a ball with small ones on both poles", 1e-8);
  ball_set_add(s, 0, 0, 0, 5);
  ball_set_add(s, 0, 0, 5, 1);
  ball_set_add(s, 0, 0, -5, 1.5);
}

/* The circles on the large ball lie in planes at distance 4 from its centre. The plane y = 0 goes through the axis of
 * the first and touches the second in (5, 0, 0); the third is its mirror image. */
static void tangent_meridian(ball_set *s) {
  ball_set_start(s, "a plane through one circle's axis touches two others", 1e-8);
  ball_set_add(s, 0, 0, 0, 5);
  ball_set_add(s, -4, 0, 0, 3);
  ball_set_add(s, 3.2, 2.4, 0, 3);
  ball_set_add(s, 3.2, -2.4, 0, 3);
}

/* As before, with one of the touching circles only: two loops and a tangent. */
static void one_tangent(ball_set *s) {
  ball_set_start(s, "a plane through one circle's axis touches another", 1e-8);
  ball_set_add(s, 0, 0, 0, 5);
  ball_set_add(s, -4, 0, 0, 3);
  ball_set_add(s, 3.2, 2.4, 0, 3);
}

/* Axes in few vertical planes, most shared by four small balls, and small balls on the poles. */
static void shared_meridians(ball_set *s) {
  int i;
  ball_set_start(s, "ten small balls in shared vertical planes", 1e-8);
  ball_set_add(s, 0, 0, 0, 6);
  for (i = 0; i < 8; ++i) ball_set_add(s, i & 1 ? 4 : -4, i & 2 ? 4 : -4, i & 4 ? 2 : -2, 1.5);
  ball_set_add(s, 0, 0, 6, 1.5);
  ball_set_add(s, 0, 0, -6, 1.5);
}

/* Vertices in the plane y = 0, which contains the axis of another loop. */
static void vertices_in_a_meridian(ball_set *s) {
  ball_set_start(s, "a plane through one circle's axis goes through vertices", 1e-8);
  ball_set_add(s, 0, 0, 0, 6);
  ball_set_add(s, -6, 0, 0, 2);
  ball_set_add(s, 5, 2, 0, 3);
  ball_set_add(s, 5, -2, 0, 3);
}

/* Four spheres besides the first go through its highest point (0, 0, 5). */
static void vertex_at_a_pole(ball_set *s) {
  ball_set_start(s, "vertices at a ball's highest point", 1e-8);
  ball_set_add(s, 0, 0, 0, 5);
  ball_set_add(s, 3, 0, 1, 5);
  ball_set_add(s, 0, 3, 1, 5);
  ball_set_add(s, -4, 0, 2, 5);
  ball_set_add(s, 0, -4, 2, 5);
  ball_set_add(s, 0, 0, -5, 1);
}

/* The lowest of the small balls ends in the highest point of the large one; beside it a free circle. */
static void touching_at_a_pole(ball_set *s) {
  ball_set_start(s, "balls that touch at poles", 1e-8);
  ball_set_add(s, 0, 0, 0, 3);
  ball_set_add(s, 0, 0, 4, 1);
  ball_set_add(s, 0, 0, -5, 2);
  ball_set_add(s, 3, 0, 0, 1);
  ball_set_add(s, 0, 0, 1, 2);
}

/* A large ball whose whole belt is covered: its face falls into two polar caps, one with holes. */
static void belt_and_holes(ball_set *s) {
  static const int places[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                    {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  int i;
  ball_set_start(s, "a covered belt, and holes above it", 1e-8);
  ball_set_add(s, 0, 0, 0, 5);
  for (i = 0; i < 12; ++i) ball_set_add(s, places[i][0], places[i][1], 0, 1.75);
  ball_set_add(s, 0, 0, 5, 0.5);
  ball_set_add(s, 2, 0, 4.5, 0.75);
  ball_set_add(s, -1, 1.75, 4.5, 0.75);
  ball_set_add(s, -1, -1.75, 4.5, 0.75);
}

/* The circle of the first and the fourth ball is free but for one point, where a tie gives it two vertices; the plane
 * of a cut arc cuts it in that very point and opposite. */
static void cut_where_vertices_coincide(ball_set *s) {
  ball_set_start(s, "an arc between coinciding vertices, cut there", 1e-8);
  ball_set_add(s, 1, 0, 2, 1);
  ball_set_add(s, -1, 0, 2, 1);
  ball_set_add(s, 1, 1, 1, 1);
  ball_set_add(s, 1, -1, 1, 1);
  ball_set_add(s, 1, -1, -1, 1);
}

/* The void left by the perturbation has no size. */
static void void_of_a_tie(ball_set *s) {
  ball_set_start(s, "a void that only a tie leaves open", 1e-8);
  ball_set_add(s, 0, 4, 4, 3);
  ball_set_add(s, 4, 4, 0, 3);
  ball_set_add(s, 4, 4, 4, 3);
  ball_set_add(s, -1, -1, 2.001, 5);
}

static void (*const catalogue[])(ball_set *) = {topology_set_nested,
                                                topology_set_two_in_a_void,
                                                topology_set_linked_rings,
                                                topology_set_cage,
                                                topology_set_ring_cavity,
                                                topology_set_scaffold,
                                                topology_set_thirty_on_one,
                                                stacked,
                                                polar_caps,
                                                tangent_meridian,
                                                one_tangent,
                                                shared_meridians,
                                                vertices_in_a_meridian,
                                                vertex_at_a_pole,
                                                touching_at_a_pole,
                                                belt_and_holes,
                                                cut_where_vertices_coincide,
                                                void_of_a_tie};

uint32_t topology_set_count(void) {
  return ball_set_count() + (uint32_t)(sizeof catalogue / sizeof catalogue[0]);
}

void topology_set_make(uint32_t which, ball_set *set) {
  if (which < ball_set_count()) {
    ball_set_make(which, set);
  } else {
    catalogue[which - ball_set_count()](set);
  }
}

void sets_with_probes(const double *probes, uint32_t count, void (*check)(const ball_set *set, double probe)) {
  static ball_set set;
  uint32_t which, k;
  for (k = 0; k < count; ++k) {
    for (which = 0; which < ball_set_count(); ++which) {
      ball_set_make(which, &set);
      check(&set, probes[k]);
    }
    for (which = 0; which < topology_set_count(); ++which) {
      topology_set_make(which, &set);
      check(&set, probes[k]);
    }
  }
}
