/* Pores of balls for which maxima, gates and tunnels are known in closed form: a cubic cage, a bottle of rings, two
 * cages side by side, rings, and balls in one point. */
#include <hardsphere.h>
#include <hardsphere_workspace.h>
#include <math.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"

static hsp_workspace work;
static hsp_pores_counts counts;
static ball_set balls;

static void compute(void) {
  CHECK_EQUAL(hsp_workspace_set(&work, balls.n, balls.xyz, balls.radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_counts(work.pores, &counts), HSP_OK);
}

/* A cubic lattice of x by 3 by 3 places without those at odd x in the middle. */
static void set_cages(uint32_t length, double radius) {
  uint32_t x, y, z;
  balls.n = 0;
  for (x = 0; x < length; ++x) {
    for (y = 0; y < 3; ++y) {
      for (z = 0; z < 3; ++z) {
        if (x % 2 == 1 && y == 1 && z == 1) continue;
        ball_set_add(&balls, 10.0 * x, 10.0 * y, 10.0 * z, radius);
      }
    }
  }
}

/* Its middle is 10 away from six balls. Each of the eight cubes around it, a corner of which is missing, has a maximum
 * in its middle, half a diagonal from seven balls. From there gates lead to the middle of the cage, through the
 * triangle of the three balls next to the missing corner, and outward through three squares. */
static void one_cage(void) {
  hsp_pore_maximum top;
  hsp_pore_gate gate;
  hsp_pore_passage passage;
  hsp_pore_pocket pocket;
  uint32_t listed[BALL_SET_MOST], needed = 0, found = 0, k;
  static const double middle[3] = {10, 10, 10};
  set_cages(3, 6);
  compute();
  CHECK(counts.maxima == 9 && counts.gates == 8 + 24 && counts.cavities == 0);
  for (k = 1; k < 9; ++k) {
    CHECK_EQUAL(hsp_pores_get_maxima(work.pores, k, 1, &top), HSP_OK);
    CHECK(fabs(top.radius - (5 * sqrt(3) - 6)) < 1e-9 && fabs(top.death - (10 * sqrt(2.0 / 3) - 6)) < 1e-9);
    CHECK(top.parent == 0 && top.gate < 8);
    CHECK_EQUAL(hsp_pores_get_maximum_balls(work.pores, k, listed, BALL_SET_MOST, &needed), HSP_OK);
    CHECK_EQUAL(needed, 7);
  }
  CHECK_EQUAL(hsp_pores_get_maxima(work.pores, 0, 1, &top), HSP_OK);
  CHECK_NEAR(top.radius, 4, 1e-12);
  for (k = 0; k < 3; ++k) CHECK_NEAR(top.xyz[k], middle[k], 1e-12);
  CHECK_EQUAL(top.parent, HSP_PORE_OUTSIDE);
  CHECK_EQUAL(hsp_pores_get_maximum_balls(work.pores, 0, listed, BALL_SET_MOST, &needed), HSP_OK);
  CHECK_EQUAL(needed, 6);
  for (k = 0; k < needed; ++k) {
    const double *c = balls.xyz + 3 * (size_t)listed[k];
    CHECK(fabs(c[0] - 10) + fabs(c[1] - 10) + fabs(c[2] - 10) == 10);
    CHECK(k == 0 || listed[k - 1] < listed[k]);
  }
  CHECK_EQUAL(hsp_pores_get_gates(work.pores, top.gate, 1, &gate), HSP_OK);
  CHECK(top.death == gate.radius && gate.merges == 1);
  CHECK(fabs(gate.radius - (10 / sqrt(2) - 6)) < 1e-9);
  CHECK(gate.end[0] == HSP_PORE_OUTSIDE ? gate.end[1] < 9 : gate.end[0] < 9 && gate.end[1] == HSP_PORE_OUTSIDE);
  CHECK_EQUAL(hsp_pores_widest(work.pores, middle, NULL, &passage), HSP_OK);
  CHECK(passage.passes == 1 && passage.radius == gate.radius && passage.gate == top.gate && passage.at[0] == 0);
  CHECK_EQUAL(hsp_pores_find_pockets(work.pores, 1, 1.1, &found), HSP_OK);
  CHECK_EQUAL(found, 1);
  CHECK_EQUAL(hsp_pores_get_pockets(work.pores, 0, 1, &pocket), HSP_OK);
  CHECK(pocket.radius == top.radius && pocket.maxima == 9 && pocket.mouth == gate.radius && pocket.gate == top.gate);
  CHECK(pocket.mouths == 24 && pocket.reserved == 0);
  CHECK_EQUAL(hsp_pores_get_pocket_balls(work.pores, 0, listed, BALL_SET_MOST, &needed), HSP_OK);
  CHECK_EQUAL(needed, pocket.balls);
  CHECK_EQUAL(hsp_pores_get_pocket_maxima(work.pores, 0, listed, BALL_SET_MOST, &needed), HSP_OK);
  for (k = 0; k < 9; ++k) CHECK_EQUAL(listed[k], k);
  CHECK_EQUAL(needed, 9);
  CHECK_EQUAL(hsp_pores_get_pocket_mouths(work.pores, 0, listed, BALL_SET_MOST, &needed), HSP_OK);
  CHECK_EQUAL(needed, 24);
  for (k = 0; k < needed; ++k) CHECK_EQUAL(listed[k], 8 + k);
  CHECK_EQUAL(hsp_pores_get_gate_balls(work.pores, 8, listed, BALL_SET_MOST, &needed), HSP_OK);
  CHECK_EQUAL(needed, 4); /* of a square */
  CHECK_EQUAL(hsp_pores_get_gate_balls(work.pores, 0, listed, BALL_SET_MOST, &needed), HSP_OK);
  CHECK_EQUAL(needed, 3);
  CHECK_EQUAL(hsp_pores_find_pockets(work.pores, 1, 1.05, &found), HSP_OK);
  CHECK_EQUAL(found, 0); /* the wide one gets in, too */
  CHECK_EQUAL(hsp_pores_find_pockets(work.pores, 2, 2, &found), HSP_OK);
  CHECK_EQUAL(found, 1);
  CHECK_EQUAL(hsp_pores_get_pockets(work.pores, 0, 1, &pocket), HSP_OK);
  CHECK(pocket.mouths == 0 && pocket.gate == HSP_NONE && pocket.mouth == 0); /* a cavity */
}

/* Rings of eight balls around an axis, from a narrow end through a wide belly to the neck and out, closed by a ball
 * below: what gets in passes the neck. */
static void bottle(void) {
  static const double ring[6][2] = {{0, 3}, {1.5, 4}, {3, 4.2}, {4.5, 4}, {6, 3}, {7.5, 2.5}};
  static const double inside[3] = {0.1, 0, 3};
  hsp_tunnel tunnel;
  hsp_tunnel_point points[400];
  const double radius = 1.75;
  uint32_t r, k, needed = 0, at = HSP_NONE;
  balls.n = 0;
  ball_set_add(&balls, 0, 0, -2, 3);
  for (r = 0; r < 6; ++r) {
    for (k = 0; k < 8; ++k) {
      const double angle = 0.7853981633974483 * k + 0.39269908169872414 * (r % 2);
      ball_set_add(&balls, ring[r][1] * cos(angle), ring[r][1] * sin(angle), ring[r][0], radius);
    }
  }
  compute();
  CHECK(counts.maxima >= 1);
  CHECK_EQUAL(hsp_workspace_tunnel(&work, NULL, inside, NULL, NULL, 0, &tunnel), HSP_OK);
  CHECK(tunnel.there == 1 && tunnel.outside == 1);
  /* The eight of the neck are in one plane, as far as their rounding to the lattice goes. */
  CHECK(fabs(tunnel.radius - 0.75) < 1e-7);
  CHECK_EQUAL(hsp_pores_get_tunnel_points(work.pores, points, 400, &needed), HSP_OK);
  CHECK_EQUAL(needed, tunnel.points);
  for (k = 0; k < needed; ++k) {
    CHECK(points[k].radius >= tunnel.radius - 1e-9);
    CHECK(fabs(points[k].xyz[0]) < 0.2 || points[k].xyz[2] > 7.5); /* along the axis */
    if (points[k].gate == tunnel.gate) at = k;
  }
  CHECK(at != HSP_NONE && fabs(points[at].xyz[2] - 7.5) < 1e-6 && points[at].radius == tunnel.radius);
  CHECK(tunnel.length > 4.4);
}

/* Two cages with a square between them, of balls that have grown a little: the one opens to the other before both open
 * to the outside, at the square of smaller balls. */
static void two_cages(void) {
  uint32_t k, gate = HSP_NONE, member = HSP_NONE;
  hsp_pore_gate between;
  hsp_pore_passage passage;
  static const double left[3] = {10, 10, 10}, right[3] = {30, 10, 10};
  set_cages(5, 6);
  for (k = 0; k < balls.n; ++k) {
    if (balls.xyz[3 * k] == 20) balls.radius[k] = balls.xyz[3 * k + 1] == 10 && balls.xyz[3 * k + 2] == 10 ? 5.5 : 5.8;
  }
  compute();
  CHECK_EQUAL(counts.maxima, 2 + 16);
  CHECK_EQUAL(hsp_pores_gate_between(work.pores, 0, 1, &gate), HSP_OK);
  CHECK(gate < counts.gates);
  CHECK_EQUAL(hsp_pores_get_gates(work.pores, gate, 1, &between), HSP_OK);
  CHECK(fabs(between.xyz[0] - 20) < 1e-7 && between.merges == 1);
  CHECK_EQUAL(hsp_pores_class_at(work.pores, 1, between.radius, &member), HSP_OK);
  CHECK_EQUAL(member, 1);
  CHECK_EQUAL(hsp_pores_class_at(work.pores, 1, nextafter(between.radius, 0), &member), HSP_OK);
  CHECK_EQUAL(member, 0);
  /* At the very radius of each gate and maximum, too: a probe as wide as that does not pass, one by a bit less does. */
  for (k = 0; k < counts.maxima; ++k) {
    hsp_pore_maximum top;
    CHECK_EQUAL(hsp_pores_get_maxima(work.pores, k, 1, &top), HSP_OK);
    CHECK_EQUAL(hsp_pores_class_at(work.pores, k, top.radius, &member), HSP_OK);
    CHECK_EQUAL(member, HSP_NONE);
    CHECK_EQUAL(hsp_pores_class_at(work.pores, k, nextafter(top.radius, 0), &member), HSP_OK);
    CHECK_EQUAL(member, k);
    if (top.gate == HSP_NONE) continue;
    CHECK_EQUAL(hsp_pores_class_at(work.pores, k, top.death, &member), HSP_OK);
    CHECK_EQUAL(member, k);
    CHECK_EQUAL(hsp_pores_class_at(work.pores, k, nextafter(top.death, 0), &member), HSP_OK);
    CHECK(member != k && member != HSP_NONE);
  }
  CHECK_EQUAL(hsp_pores_widest(work.pores, left, right, &passage), HSP_OK);
  CHECK(passage.radius == between.radius && passage.gate == gate);
  CHECK(passage.at[0] != passage.at[1] && passage.at[0] + passage.at[1] == 1);
}

/* Balls on a circle of 6 with so many decimals: some tie in its middle, all others do nearly. */
static void rings(void) {
  hsp_pore_gate gate;
  uint32_t n, k, decimals;
  for (n = 16; n <= 200; n += n < 60 ? 4 : 70) {
    double grain = 1e-3;
    for (decimals = 3; decimals <= 8; ++decimals, grain /= 10) {
      balls.n = 0;
      for (k = 0; k < n; ++k) {
        const double angle = 2 * acos(-1.0) * k / n;
        ball_set_add(&balls, grain * floor(6 * cos(angle) / grain + 0.5), grain * floor(6 * sin(angle) / grain + 0.5),
                     0, 1.7);
      }
      compute();
      CHECK(counts.maxima == 0 && counts.gates == 1 && counts.merges == 0 && counts.outer_balls == n);
      CHECK_EQUAL(hsp_pores_get_gates(work.pores, 0, 1, &gate), HSP_OK);
      CHECK(fabs(gate.radius - 4.3) < 1e-3 && fabs(gate.xyz[0]) < 1e-3 && fabs(gate.xyz[1]) < 1e-3);
      CHECK(gate.xyz[2] == 0 && gate.end[0] == HSP_PORE_OUTSIDE && gate.end[1] == HSP_PORE_OUTSIDE);
    }
  }
}

/* One of many that are equal, or the largest, is outside all others. */
static void balls_in_one_point(void) {
  enum { MOST = 20000 };
  static double xyz[3 * MOST], radius[MOST];
  uint32_t k, turn;
  for (turn = 0; turn < 2; ++turn) {
    for (k = 0; k < MOST; ++k) {
      xyz[3 * k] = 0.5;
      xyz[3 * k + 1] = -2;
      xyz[3 * k + 2] = 7;
      radius[k] = turn == 0 ? 1.5 : 1 + 0.5 * ((k * 7919u) % MOST) / MOST;
    }
    CHECK_EQUAL(hsp_workspace_set(&work, MOST, xyz, radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
    CHECK_EQUAL(hsp_pores_get_counts(work.pores, &counts), HSP_OK);
    CHECK(counts.maxima == 0 && counts.gates == 0 && counts.cavities == 0 && counts.outer_balls == 1);
  }
}

int main(void) {
  memset(&work, 0, sizeof work);
  one_cage();
  bottle();
  two_cages();
  rings();
  balls_in_one_point();
  hsp_workspace_free(&work);
  return check_report();
}
