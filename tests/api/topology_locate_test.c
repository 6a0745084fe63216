/* hsp_topology_locate: points whose region is known, statuses, and for every set of topology_sets.h a box of points
 * against the balls themselves: a point is in no region exactly if it is in a ball, points joined by a line that misses
 * all balls are in one region, and a region holds as many of them as its volume says. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "topology_result.h"
#include "topology_sets.h"
#include "untouched.h"

static uint32_t region_of(const topology_result *t, double x, double y, double z) {
  double place[3];
  uint32_t region = 77;
  place[0] = x;
  place[1] = y;
  place[2] = z;
  CHECK_EQUAL(hsp_topology_locate(t->topology, place, &region), HSP_OK);
  return region;
}

/* Whether a point can move from one place to the other. */
static int same_region(const topology_result *t, double x, double y, double z, double to_x, double to_y, double to_z) {
  const uint32_t region = region_of(t, x, y, z);
  return region != HSP_NONE && region == region_of(t, to_x, to_y, to_z);
}

/* ---- known points ---- */

static int made(const ball_set *set, computed *c, topology_result *t) {
  memset(t, 0, sizeof *t);
  check_scene("%s", set->name);
  if (!CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, c), HSP_OK)) return 0;
  return CHECK_EQUAL(topology_result_make(c, t), HSP_OK);
}

static void release(computed *c, topology_result *t) {
  topology_result_release(t);
  computed_release(c);
}

/* Along the x axis, from the middle: the ball to 0.125, free to 0.25, the inner wall to 1.75, free to 2, the middle
 * wall to 14, free to 16, the outer wall to 112. Ends belong to the walls. */
static void nested(void) {
  static const double free_places[4] = {0.2, 1.875, 15, 113};
  static const double walls[12] = {0, 0.125, 0.25, 1, 1.75, 2, 8, 14, 16, 64, 100, 112};
  static ball_set set;
  computed c;
  topology_result t;
  int i, j, axis, side;
  topology_set_nested(&set);
  if (made(&set, &c, &t)) {
    uint32_t within[4]; /* the regions from the middle to the outside */
    within[0] = t.components[c.balls[78].component].region;
    within[1] = t.components[c.balls[52].component].region;
    within[2] = t.components[c.balls[26].component].region;
    within[3] = 0;
    for (axis = 0; axis < 3; ++axis) {
      for (side = -1; side <= 1; side += 2) {
        for (i = 0; i < 4; ++i) {
          double at[3] = {0, 0, 0}, other[3] = {0, 0, 0};
          at[axis] = side * free_places[i];
          CHECK_EQUAL(region_of(&t, at[0], at[1], at[2]), within[i]);
          for (j = 0; j < 4; ++j) {
            other[(axis + 1) % 3] = free_places[j];
            CHECK_EQUAL(same_region(&t, at[0], at[1], at[2], other[0], other[1], other[2]), i == j);
          }
          CHECK_EQUAL(same_region(&t, at[0], at[1], at[2], 0, 0, 0), 0);
        }
        for (i = 0; i < 12; ++i) {
          double at[3] = {0, 0, 0};
          at[axis] = side * walls[i];
          CHECK_EQUAL(region_of(&t, at[0], at[1], at[2]), HSP_NONE);
          CHECK_EQUAL(same_region(&t, at[0], at[1], at[2], at[0], at[1], at[2]), 0);
        }
      }
    }
    /* one lattice step beside a wall */
    CHECK_EQUAL(region_of(&t, 112 + c.info.step, 0, 0), 0);
    CHECK_EQUAL(region_of(&t, 16 - c.info.step, 0, 0), within[2]);
    CHECK_EQUAL(region_of(&t, 0, 14 + c.info.step, 0), within[2]);
    CHECK_EQUAL(region_of(&t, 0, 0, 0.125 + c.info.step), within[0]);
    CHECK_EQUAL(region_of(&t, 0, 0, -0.25 + c.info.step), within[0]);
    /* points are rounded to the lattice */
    CHECK_EQUAL(region_of(&t, 112 + 0.25 * c.info.step, 0, 0), HSP_NONE);
    CHECK_EQUAL(region_of(&t, 112 + 0.75 * c.info.step, 0, 0), 0);
  }
  release(&c, &t);
}

/* Straight above the void's balls, between them, beside them, and in the wall. */
static void two_in_a_void(void) {
  static ball_set set;
  computed c;
  topology_result t;
  topology_set_two_in_a_void(&set);
  if (made(&set, &c, &t)) {
    CHECK_EQUAL(region_of(&t, 0, 0, 0), 1);
    CHECK_EQUAL(region_of(&t, 1, 0, 1), 1);
    CHECK_EQUAL(region_of(&t, 1, 0, -1), 1);
    CHECK_EQUAL(region_of(&t, 1, 0, 0.5), HSP_NONE);
    CHECK_EQUAL(region_of(&t, -1, 0, 0), HSP_NONE);
    CHECK_EQUAL(region_of(&t, 1.75, 0, 0), 1);
    CHECK_EQUAL(region_of(&t, 0, 0, 20), 0);
    CHECK_EQUAL(region_of(&t, 0, 0, -20), 0);
    CHECK_EQUAL(same_region(&t, 1, 0, 1, -1, 0, -1), 1);
    CHECK_EQUAL(same_region(&t, 1, 0, 1, 0, 0, 20), 0);
    CHECK_EQUAL(same_region(&t, 0, 0, -20, 0, 0, 20), 1);
  }
  release(&c, &t);
}

/* The cavity is a ring around the pillar in the block's middle; the cage's inside is open. */
static void ring_and_cage(void) {
  static ball_set set;
  computed c;
  topology_result t;
  topology_set_ring_cavity(&set);
  if (made(&set, &c, &t)) {
    CHECK_EQUAL(region_of(&t, 1, 1, 1), 1);
    CHECK_EQUAL(region_of(&t, 2, 2, 1), HSP_NONE);
    CHECK_EQUAL(same_region(&t, 1, 2, 1, 3, 2, 1), 1);
    CHECK_EQUAL(same_region(&t, 1, 2, 1, 3, 2, 5), 0);
  }
  release(&c, &t);
  topology_set_cage(&set);
  if (made(&set, &c, &t)) CHECK_EQUAL(same_region(&t, 1, 1, 1, 1, 1, 100), 1);
  release(&c, &t);
}

static void no_balls(void) {
  static ball_set set;
  computed c;
  topology_result t;
  ball_set_start(&set, "no balls", 1e-8);
  if (made(&set, &c, &t)) {
    CHECK_EQUAL(region_of(&t, 0, 0, 0), 0);
    CHECK_EQUAL(same_region(&t, 1, 2, 3, -4, -5, -6), 1);
  }
  release(&c, &t);
}

/* In no region exactly where hsp_query_point finds a ball: in four of them, in three, in none. */
static void in_several_balls(void) {
  static const double places[3][3] = {{1, 0, 0}, {-1.5, 0, 0}, {9, 9, 9}};
  static ball_set set;
  computed c;
  topology_result t;
  uint32_t which;
  topology_set_make(5, &set); /* three equal balls and a neighbour */
  if (made(&set, &c, &t)) {
    for (which = 0; which < 3; ++which) {
      uint32_t ids[8], inside = 0;
      CHECK_EQUAL(hsp_query_point(c.model, places[which], ids, 8, &inside), HSP_OK);
      CHECK_EQUAL(inside, which == 0 ? 4 : which == 1 ? 3 : 0);
      CHECK_EQUAL(region_of(&t, places[which][0], places[which][1], places[which][2]), inside > 0 ? HSP_NONE : 0);
    }
  }
  release(&c, &t);
}

static void statuses(void) {
  static ball_set set;
  computed c;
  topology_result t;
  topology_set_two_in_a_void(&set);
  if (made(&set, &c, &t)) {
    const double step = c.info.step;
    const double within = 1125899906842624.0 * step, beyond = 1125899906842626.0 * step;
    const double odd[6] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, beyond};
    uint32_t region;
    int i, axis;
    FILL(region);
    for (i = 0; i < 6; ++i) {
      const int32_t expected = i < 3 ? HSP_E_NOT_FINITE : HSP_E_RANGE;
      for (axis = 0; axis < 3; ++axis) {
        double place[3] = {1, 2, 3};
        place[axis] = odd[i];
        CHECK_EQUAL(hsp_topology_locate(t.topology, place, &region), expected);
        CHECK_UNTOUCHED(region);
        place[axis] = i % 2 == 0 ? within : -within;
        CHECK_EQUAL(hsp_topology_locate(t.topology, place, &region), HSP_OK);
        CHECK_EQUAL(region, 0);
        FILL(region);
      }
    }
  }
  release(&c, &t);
}

/* ---- a box of points ---- */

enum { SIDE = 19, PLACES = SIDE * SIDE * SIDE };

/* The facts about a point that follow from the balls alone. */
enum { UNSURE, IN_A_BALL, FREE };

static int known_place(const computed *c, const double at[3]) {
  int sure = FREE;
  uint32_t j;
  for (j = 0; j < c->n; ++j) {
    const double dx = at[0] - c->xyz[3 * j], dy = at[1] - c->xyz[3 * j + 1], dz = at[2] - c->xyz[3 * j + 2];
    const double off = sqrt(dx * dx + dy * dy + dz * dz) - c->radius[j];
    const double doubt = 4 * c->info.step + 1e-12 * (fabs(at[0]) + fabs(at[1]) + fabs(at[2]));
    if (off < -doubt) return IN_A_BALL;
    if (off <= doubt) sure = UNSURE;
  }
  return sure;
}

/* Whether the line from a to b, parallel to an axis, misses all balls for sure. */
static int misses_all(const computed *c, const double a[3], const double b[3], int axis) {
  uint32_t j;
  for (j = 0; j < c->n; ++j) {
    double square = 0, reach;
    int other;
    for (other = 0; other < 3; ++other) {
      const double centre = c->xyz[3 * j + (uint32_t)other];
      double gap = a[other] - centre;
      if (other == axis) gap = centre < a[other] ? a[other] - centre : centre > b[other] ? centre - b[other] : 0;
      square += gap * gap;
    }
    reach = c->radius[j] + 8 * c->info.step;
    if (square <= reach * reach * (1 + 1e-12)) return 0;
  }
  return 1;
}

static uint32_t place_number(int i, int j, int k) {
  return (uint32_t)((i * SIDE + j) * SIDE + k);
}

static void box_of_places(const topology_result *t) {
  static uint32_t region[PLACES];
  const computed *c = t->base;
  double low[3], spacing[3], coordinates[3][SIDE], largest = 0;
  uint32_t p, *held = calloc(t->counts.regions, sizeof *held);
  int i, j, k, axis;
  if (held == NULL) exit(2);
  for (axis = 0; axis < 3; ++axis) {
    double high = -HUGE_VAL;
    low[axis] = HUGE_VAL;
    for (p = 0; p < c->n; ++p) {
      low[axis] = fmin(low[axis], c->xyz[3 * p + (uint32_t)axis] - c->radius[p]);
      high = fmax(high, c->xyz[3 * p + (uint32_t)axis] + c->radius[p]);
    }
    /* the outermost layer lies outside; steps that are no simple fraction of anything */
    spacing[axis] = (high - low[axis] + 1e-3) / ((double)SIDE - 2.1);
    low[axis] -= 0.53 * spacing[axis];
    largest = fmax(largest, spacing[axis]);
    for (i = 0; i < SIDE; ++i) {
      coordinates[axis][i] = floor((low[axis] + i * spacing[axis]) / c->info.step) * c->info.step;
    }
  }
  for (i = 0; i < SIDE; ++i) {
    for (j = 0; j < SIDE; ++j) {
      for (k = 0; k < SIDE; ++k) {
        const double at[3] = {coordinates[0][i], coordinates[1][j], coordinates[2][k]};
        const int outermost = i == 0 || j == 0 || k == 0 || i == SIDE - 1 || j == SIDE - 1 || k == SIDE - 1;
        const int known = known_place(c, at);
        const int step[3] = {i, j, k};
        uint32_t here = 77;
        CHECK_EQUAL(hsp_topology_locate(t->topology, at, &here), HSP_OK);
        region[place_number(i, j, k)] = here;
        if (known != UNSURE) CHECK_EQUAL(here == HSP_NONE, known == IN_A_BALL);
        if (outermost) CHECK_EQUAL(here, 0);
        if (here == HSP_NONE) continue;
        if (!CHECK(here < t->counts.regions)) continue;
        ++held[here];
        for (axis = 0; axis < 3; ++axis) {
          double before[3] = {coordinates[0][i], coordinates[1][j], coordinates[2][k]};
          if (step[axis] == 0) continue;
          before[axis] = coordinates[axis][step[axis] - 1];
          if (misses_all(c, before, at, axis)) {
            CHECK_EQUAL(region[place_number(i - (axis == 0), j - (axis == 1), k - (axis == 2))], here);
          }
        }
      }
    }
  }
  /* each point stands for a box around it; the boxes that the region's surface cuts lie within a spacing's diagonal of
   * it, and few fit around a small region */
  for (p = 1; p < t->counts.regions; ++p) {
    const double volume = held[p] * spacing[0] * spacing[1] * spacing[2];
    CHECK_NEAR(volume, t->regions[p].volume, 2 * t->regions[p].area * largest + 8 * largest * largest * largest);
  }
  free(held);
}

/* Just outside the middle of every edge lies the region on the other side of its shell. */
static uint32_t beside_edges(const topology_result *t) {
  const computed *c = t->base;
  uint32_t e, j, looked_at = 0;
  int axis;
  for (e = 0; e < t->counts.edges; ++e) {
    const hsp_topology_edge *edge = t->edges + e;
    const double *from = t->vertices[edge->vertex[0]].xyz;
    const uint32_t shell = t->faces[edge->face[0]].shell;
    const double away = 1e-3 * c->radius[edge->ball[0]];
    double u[3], quarter[3], middle[3], outward[3], at[3], size = 0;
    int alone = 1;
    for (axis = 0; axis < 3; ++axis) u[axis] = from[axis] - edge->centre[axis];
    quarter[0] = edge->axis[1] * u[2] - edge->axis[2] * u[1];
    quarter[1] = edge->axis[2] * u[0] - edge->axis[0] * u[2];
    quarter[2] = edge->axis[0] * u[1] - edge->axis[1] * u[0];
    for (axis = 0; axis < 3; ++axis) {
      middle[axis] = edge->centre[axis] + cos(edge->angle / 2) * u[axis] + sin(edge->angle / 2) * quarter[axis];
      /* away from both balls */
      outward[axis] = (middle[axis] - c->xyz[3 * edge->ball[0] + (uint32_t)axis]) / c->radius[edge->ball[0]] +
                      (middle[axis] - c->xyz[3 * edge->ball[1] + (uint32_t)axis]) / c->radius[edge->ball[1]];
      size += outward[axis] * outward[axis];
    }
    if (!(size > 1e-2)) continue;
    for (axis = 0; axis < 3; ++axis) at[axis] = middle[axis] + away * outward[axis] / sqrt(size);
    for (j = 0; j < c->n && alone; ++j) {
      const double dx = at[0] - c->xyz[3 * j], dy = at[1] - c->xyz[3 * j + 1], dz = at[2] - c->xyz[3 * j + 2];
      const double off = sqrt(dx * dx + dy * dy + dz * dz) - c->radius[j];
      /* other balls must be too far to come between */
      alone = off > (j == edge->ball[0] || j == edge->ball[1] ? 1e-5 * away : 2 * away);
    }
    if (!alone) continue;
    ++looked_at;
    CHECK_EQUAL(region_of(t, at[0], at[1], at[2]), t->shells[shell].region);
  }
  return looked_at;
}

int main(void) {
  uint32_t which, edges = 0, looked_at = 0;
  no_balls();
  nested();
  two_in_a_void();
  ring_and_cage();
  in_several_balls();
  statuses();
  for (which = 0; which < topology_set_count(); ++which) {
    static ball_set set;
    computed c;
    topology_result t;
    topology_set_make(which, &set);
    if (made(&set, &c, &t) && set.n > 0) {
      box_of_places(&t);
      looked_at += beside_edges(&t);
      edges += t.counts.edges;
    }
    release(&c, &t);
  }
  check_scene("%s", "all sets");
  CHECK(2 * looked_at > edges); /* most edges lie free enough to be looked at */
  return check_report();
}
