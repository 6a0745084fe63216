/* Pores in periodic boxes through the C interface: closed forms of packings, directions and vectors of channels in
 * upright and skew boxes, images and shifts that fit the points, and everything that is refused in a box. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "boxed_balls.h"
#include "check.h"

enum { POINTS = 512 };
static boxed_balls in;

static double distance(const double *at, const double *from, const int32_t *shift) {
  double square = 0;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const double x =
        from[axis] + shift[0] * in.box[axis] + shift[1] * in.box[3 + axis] + shift[2] * in.box[6 + axis] - at[axis];
    square += x * x;
  }
  return sqrt(square);
}

/* Balls of every point touch the probe there, where their shifts put them. */
static void images_fit(void) {
  hsp_image images[POINTS];
  uint32_t balls[POINTS], k, i, needed = 0, number = 0;
  for (k = 0; k < in.counts.maxima + in.counts.gates; ++k) {
    const uint32_t gate = k - in.counts.maxima;
    const int at_gate = k >= in.counts.maxima;
    double at[3], radius;
    hsp_pore_maximum top;
    hsp_pore_gate pass;
    hsp_pore_gate_shifts shifts;
    if (at_gate) {
      CHECK_EQUAL(hsp_pores_get_gates(in.work.pores, gate, 1, &pass), HSP_OK);
      CHECK_EQUAL(hsp_pores_get_gate_shifts(in.work.pores, gate, 1, &shifts), HSP_OK);
      CHECK_EQUAL(hsp_pores_get_gate_images(in.work.pores, gate, images, POINTS, &needed), HSP_OK);
      CHECK_EQUAL(hsp_pores_get_gate_balls(in.work.pores, gate, balls, POINTS, &number), HSP_OK);
      memcpy(at, pass.xyz, sizeof at);
      radius = pass.radius;
      CHECK(needed >= 3 && shifts.directions <= 3);
      for (i = 0; i < 3; ++i) {
        const uint32_t ball = pass.ball[i];
        CHECK_NEAR(distance(at, in.balls.xyz + 3 * (size_t)ball, shifts.ball + 3 * i) - in.balls.radius[ball], radius,
                   1e-7);
      }
    } else {
      CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, k, 1, &top), HSP_OK);
      CHECK_EQUAL(hsp_pores_get_maximum_images(in.work.pores, k, images, POINTS, &needed), HSP_OK);
      CHECK_EQUAL(hsp_pores_get_maximum_balls(in.work.pores, k, balls, POINTS, &number), HSP_OK);
      memcpy(at, top.xyz, sizeof at);
      radius = top.radius;
      CHECK(needed >= 4 && top.parent != HSP_PORE_OUTSIDE);
    }
    CHECK_EQUAL(number, needed);
    for (i = 0; i < needed; ++i) {
      const uint32_t ball = images[i].ball;
      CHECK_EQUAL(ball, balls[i]);
      CHECK_NEAR(distance(at, in.balls.xyz + 3 * (size_t)ball, images[i].shift) - in.balls.radius[ball], radius, 1e-7);
    }
  }
}

/* Fractions of an edge of 8: where balls of radius 1 are. */
static void packings(void) {
  static const double quarters[8][3] = {{0, 0, 0}, {0, 2, 2}, {2, 0, 2}, {2, 2, 0},
                                        {1, 1, 1}, {1, 3, 3}, {3, 1, 3}, {3, 3, 1}};
  const double edge = 8;
  const double largest[4] = {sqrt(3) / 2, sqrt(5) / 4, 0.5, sqrt(3) / 4};
  const double through[4] = {sqrt(2) / 2, 3 / (4 * sqrt(2)), 1 / sqrt(6), 1 / sqrt(6)};
  static const uint32_t balls[4] = {1, 2, 4, 8}, maxima[4] = {1, 12, 12, 24}, gates[4] = {3, 24, 32, 32};
  uint32_t kind, k;
  for (kind = 0; kind < 4; ++kind) {
    hsp_pore_channel channel;
    uint32_t needed = 0;
    in.balls.n = 0;
    for (k = 0; k < balls[kind]; ++k) {
      const double *q = quarters[k];
      if (kind == 1 && k == 1) {
        ball_set_add(&in.balls, edge / 2 - 3 * edge, edge / 2, edge / 2, 1); /* anywhere, three boxes away */
      } else {
        ball_set_add(&in.balls, q[0] * edge / 4, q[1] * edge / 4, q[2] * edge / 4, 1);
      }
    }
    set_box(&in, edge, 0, edge, 0, 0, edge);
    compute_pores(&in, 0);
    CHECK_EQUAL(in.counts.maxima, maxima[kind]);
    CHECK_EQUAL(in.counts.gates, gates[kind]);
    CHECK_NEAR(in.wide.largest, largest[kind] * edge - 1, 1e-7);
    for (k = 0; k < 3; ++k) {
      CHECK_NEAR(in.wide.through[k], through[kind] * edge - 1, 1e-7);
      CHECK_NEAR(in.wide.along[k], through[kind] * edge - 1, 1e-7);
      CHECK_NEAR(in.wide.included[k], largest[kind] * edge - 1, 1e-7);
      CHECK(in.wide.gate[k] < in.counts.gates && in.wide.maximum[k] < in.counts.maxima &&
            in.wide.gate_along[k] < in.counts.gates);
    }
    images_fit();
    CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, 0, &channel, 1, &needed), HSP_OK);
    CHECK_EQUAL(needed, 1);
    CHECK(channel.maximum == 0 && channel.maxima == in.counts.maxima && channel.radius == in.wide.largest);
    CHECK(channel.directions == 3 && channel.copies == 1 && channel.reserved == 0);
    for (k = 0; k < 9; ++k) CHECK_EQUAL(channel.row[k], k % 4 == 0 ? 1 : 0);
    CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, in.wide.largest, NULL, 0, &needed), HSP_OK);
    CHECK_EQUAL(needed, 0);
  }
}

/* One ball in an upright box of 8 x 10 x 3: rods, between which a probe goes along them first, then between them by
 * the wider side, then by the other. vectors: of the same lattice; ways are given in these. */
static void rods(const double *vectors, const int32_t (*ways)[3], int first, int second, int third) {
  const double radius = 1.6;
  const double levels[3] = {sqrt(41) - radius, sqrt(25 + 2.25) - radius, sqrt(16 + 2.25) - radius};
  uint32_t d, needed = 0, k;
  int32_t sign;
  in.balls.n = 0;
  ball_set_add(&in.balls, 3, 2, 1, radius);
  memcpy(in.box, vectors, sizeof in.box);
  compute_pores(&in, 0);
  CHECK(in.counts.maxima == 1 && in.counts.gates == 3 && in.counts.merges == 0 && in.counts.cavities == 1);
  CHECK_NEAR(in.wide.largest, sqrt(41 + 2.25) - radius, 1e-8);
  images_fit();
  for (d = 0; d < 3; ++d) {
    hsp_pore_channel channel;
    hsp_pore_gate gate;
    hsp_pore_gate_shifts shifts;
    hsp_pore_maximum top;
    CHECK_NEAR(in.wide.through[d], levels[d], 1e-8);
    CHECK(in.wide.gate[d] == d && in.wide.maximum[d] == 0 && in.wide.included[d] == in.wide.largest);
    CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, in.wide.through[d], &channel, 1, &needed), HSP_OK);
    CHECK(needed == 1 && channel.directions == d);
    CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, nextafter(in.wide.through[d], 0), &channel, 1, &needed), HSP_OK);
    CHECK(needed == 1 && channel.directions == d + 1 && channel.copies == 1 && channel.maxima == 1);
    CHECK_EQUAL(hsp_pores_get_gates(in.work.pores, d, 1, &gate), HSP_OK);
    CHECK_EQUAL(hsp_pores_get_gate_shifts(in.work.pores, d, 1, &shifts), HSP_OK);
    CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, 0, 1, &top), HSP_OK);
    CHECK(gate.end[0] == 0 && gate.end[1] == 0 && gate.merges == 0 && shifts.winds == 1 && shifts.directions == d + 1);
    /* Its two ends are on both sides, and one way apart. */
    CHECK_NEAR(distance(gate.xyz, top.xyz, shifts.end), d == 0 ? 1.5 : d == 1 ? 4 : 5, 1e-7);
    CHECK_NEAR(distance(gate.xyz, top.xyz, shifts.end + 3), d == 0 ? 1.5 : d == 1 ? 4 : 5, 1e-7);
    sign = 0;
    for (k = 0; k < 3; ++k) sign += (shifts.end[3 + k] - shifts.end[k]) * ways[d][k];
    for (k = 0; k < 3; ++k) CHECK_EQUAL(shifts.end[3 + k] - shifts.end[k], (sign > 0 ? 1 : -1) * ways[d][k]);
    if (d == 0) {
      for (k = 0; k < 3; ++k) CHECK_EQUAL(channel.row[k], ways[0][k]);
    }
  }
  CHECK_NEAR(in.wide.along[0], levels[first], 1e-8);
  CHECK_NEAR(in.wide.along[1], levels[second], 1e-8);
  CHECK_NEAR(in.wide.along[2], levels[third], 1e-8);
}

/* Walls that leave closed cavities, and a floor above everything. */
static void closed(void) {
  hsp_pore_channel channel;
  hsp_pore_maximum top;
  uint32_t needed = 0, member = 0;
  int d;
  in.balls.n = 0;
  ball_set_add(&in.balls, 0, 0, 0, 2.9); /* an edge of 4: 2 sqrt(2) < 2.9 < 2 sqrt(3) */
  set_box(&in, 4, 0, 4, 0, 0, 4);
  compute_pores(&in, 0);
  CHECK(in.counts.maxima == 1 && in.counts.gates == 0 && in.counts.cavities == 1);
  CHECK_NEAR(in.wide.largest, 2 * sqrt(3) - 2.9, 1e-8);
  for (d = 0; d < 3; ++d) {
    CHECK(in.wide.through[d] == 0 && in.wide.along[d] == 0 && in.wide.included[d] == 0);
    CHECK(in.wide.gate[d] == HSP_NONE && in.wide.maximum[d] == HSP_NONE && in.wide.gate_along[d] == HSP_NONE);
  }
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, 0.5, &channel, 1, &needed), HSP_OK);
  CHECK(needed == 1 && channel.directions == 0 && channel.copies == 1 && channel.maxima == 1);
  CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, 0, 1, &top), HSP_OK);
  CHECK(top.gate == HSP_NONE && top.parent == HSP_NONE && top.death == 0);
  CHECK_EQUAL(hsp_pores_class_at(in.work.pores, 0, 0.5, &member), HSP_OK);
  CHECK_EQUAL(member, 0);
  compute_pores(&in, 1);
  CHECK(in.counts.maxima == 0 && in.wide.largest == 1);
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, 1, &channel, 1, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0);
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, 0.5, &channel, 1, &needed), HSP_E_RANGE);
  compute_pores(&in, -2.9); /* everything is one class then */
  CHECK(in.counts.maxima == 1 && in.counts.gates == 3 && in.wide.through[2] < 0);
}

/* Points in boxes that are not upright are rounded as these are turned, so that what would tie differs by a step: a
 * maximum is no lower than its gate all the same. */
static void births_and_deaths(void) {
  static const double boxes[4][9] = {{0, 3, -1, 0, -3, -1, 1, -2, -1},
                                     {2, -3, 0, 0, -1, 1, -1, 0, 1},
                                     {-2, -2, -2, -1, 0, 3, 3, 1, 0},
                                     {2, 0, -2, 1, 3, 0, -1, 3, -1}};
  static const double centres[4][9] = {
      {2, 0, -1, -1, 3, 5, 3, 0, 2}, {5, 2, 0, 0, -4, 6}, {-4, 3, -1, 5, 4, 4}, {-4, 1, 3}};
  static const uint32_t count[4] = {3, 2, 2, 1};
  static const double radius[3] = {0, 0, 0};
  uint32_t which, k;
  for (which = 0; which < 4; ++which) {
    hsp_model_options options;
    hsp_pores_counts counts;
    hsp_model_options_init(&options, sizeof options);
    options.step = 1e-8;
    CHECK_EQUAL(hsp_workspace_periodic(&in.work, count[which], centres[which], radius, boxes[which], &options, NULL),
                HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores_periodic(&in.work, NULL), HSP_OK);
    CHECK_EQUAL(hsp_pores_get_counts(in.work.pores, &counts), HSP_OK);
    CHECK(counts.maxima >= 3);
    for (k = 0; k < counts.maxima; ++k) {
      hsp_pore_maximum top;
      CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, k, 1, &top), HSP_OK);
      CHECK(top.radius >= top.death);
    }
  }
}

/* Two balls of one place in a box twice as long give the same levels; the same balls elsewhere give the same bits. */
static void copies_and_stale_results(void) {
  static const double upright[9] = {8, 0, 0, 0, 10, 0, 0, 0, 3};
  hsp_pore_percolation one;
  int d;
  in.balls.n = 0;
  ball_set_add(&in.balls, 3, 2, 1, 1.6);
  memcpy(in.box, upright, sizeof in.box);
  compute_pores(&in, 0);
  one = in.wide;
  ball_set_add(&in.balls, 3, 2, 4, 1.6);
  in.box[8] = 6;
  compute_pores(&in, 0);
  CHECK_EQUAL(in.counts.maxima, 2);
  CHECK_EQUAL(in.counts.gates, 6);
  for (d = 0; d < 3; ++d) CHECK(in.wide.through[d] == one.through[d] && in.wide.along[d] == one.along[d]);
  /* Pores of other balls are not there, of the same again they are, of a copy elsewhere they are not: other shifts. */
  in.balls.xyz[0] = 3.5;
  CHECK_EQUAL(hsp_workspace_periodic(&in.work, in.balls.n, in.balls.xyz, in.balls.radius, in.box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_percolation(in.work.pores, &in.wide), HSP_E_STATE);
  in.balls.xyz[0] = 3;
  CHECK_EQUAL(hsp_workspace_periodic(&in.work, in.balls.n, in.balls.xyz, in.balls.radius, in.box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_percolation(in.work.pores, &in.wide), HSP_OK);
  in.balls.xyz[0] = 11;
  CHECK_EQUAL(hsp_workspace_periodic(&in.work, in.balls.n, in.balls.xyz, in.balls.radius, in.box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_percolation(in.work.pores, &in.wide), HSP_E_STATE);
  compute_pores(&in, 0);
  for (d = 0; d < 3; ++d) CHECK(in.wide.through[d] == one.through[d]);
  in.box[3] = 8; /* other vectors of the same lattice */
  CHECK_EQUAL(hsp_workspace_periodic(&in.work, in.balls.n, in.balls.xyz, in.balls.radius, in.box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_counts(in.work.pores, &in.counts), HSP_E_STATE);
  compute_pores(&in, 0);
  for (d = 0; d < 3; ++d) CHECK(in.wide.through[d] == one.through[d]);
}

static uint32_t checked_pockets, checked_mouths;

/* Where the maximum of a gate is in a pocket and the other one is not, that is where the wide probe gets. */
static void pockets_against_channels(double narrow, double wider) {
  static hsp_pore_gate gates[POINTS];
  static hsp_pore_channel channels[POINTS];
  static uint32_t part[POINTS], listed[POINTS];
  static int reached[POINTS];
  uint32_t pockets = 0, needed = 0, k, p, found = 0, closed_channels = 0;
  int changed = 1;
  CHECK(in.counts.maxima <= POINTS && in.counts.gates <= POINTS);
  CHECK_EQUAL(hsp_pores_get_gates(in.work.pores, 0, in.counts.gates, gates), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, wider, channels, POINTS, &needed), HSP_OK);
  for (p = 0; p < needed; ++p) closed_channels += channels[p].directions == 0 ? 1 : 0;
  for (k = 0; k < in.counts.maxima; ++k) {
    uint32_t member = 0;
    CHECK_EQUAL(hsp_pores_class_at(in.work.pores, k, wider, &member), HSP_OK);
    reached[k] = 0;
    for (p = 0; p < needed; ++p)
      reached[k] = reached[k] || (channels[p].maximum == member && channels[p].directions > 0);
    part[k] = k;
  }
  while (changed) { /* the least number of each part */
    changed = 0;
    for (k = 0; k < in.counts.gates && gates[k].radius > narrow; ++k) {
      const uint32_t a = gates[k].end[0], b = gates[k].end[1];
      if (reached[a] || reached[b] || part[a] == part[b]) continue;
      part[a] = part[b] = part[a] < part[b] ? part[a] : part[b];
      changed = 1;
    }
  }
  CHECK_EQUAL(hsp_pores_find_pockets(in.work.pores, narrow, wider, &pockets), HSP_OK);
  if (narrow == wider) CHECK_EQUAL(pockets, closed_channels);
  for (k = 0; k < in.counts.maxima; ++k) {
    hsp_pore_maximum top;
    CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, k, 1, &top), HSP_OK);
    if (reached[k] || part[k] != k || !(top.radius > narrow)) continue;
    if (found < pockets) { /* the widest one comes first, as in the list */
      hsp_pore_pocket pocket;
      uint32_t mouths = 0, members = 0, i;
      CHECK_EQUAL(hsp_pores_get_pockets(in.work.pores, found, 1, &pocket), HSP_OK);
      CHECK(pocket.maximum == k && pocket.radius == top.radius);
      CHECK_EQUAL(hsp_pores_get_pocket_maxima(in.work.pores, found, listed, POINTS, &needed), HSP_OK);
      CHECK_EQUAL(needed, pocket.maxima);
      for (i = 0; i < needed; ++i) CHECK(part[listed[i]] == k && !reached[listed[i]]);
      for (i = 0; i < in.counts.maxima; ++i) members += part[i] == k ? 1 : 0;
      CHECK_EQUAL(members, pocket.maxima);
      for (i = 0; i < in.counts.gates && gates[i].radius > narrow; ++i) {
        const uint32_t a = gates[i].end[0], b = gates[i].end[1];
        const int first = !reached[a] && part[a] == k, second = !reached[b] && part[b] == k;
        if (first == second) continue;
        CHECK(reached[first ? b : a]);
        if (mouths == 0) CHECK(pocket.gate == i && pocket.mouth == gates[i].radius);
        ++mouths;
      }
      CHECK_EQUAL(mouths, pocket.mouths);
      ++checked_pockets;
      checked_mouths += mouths;
      if (mouths == 0) CHECK_EQUAL(pocket.gate, HSP_NONE);
    }
    ++found;
  }
  CHECK_EQUAL(found, pockets);
}

/* A room in each box of 4 with a window of 2 sqrt(2) - 2.5 to the next ones; and balls anywhere. */
static void pockets_in_a_box(void) {
  const double window = 2 * sqrt(2) - 2.5;
  uint32_t pockets = 0, state = 12345, turn, k;
  in.balls.n = 0;
  ball_set_add(&in.balls, 0, 0, 0, 2.5);
  set_box(&in, 4, 0, 4, 0, 0, 4);
  compute_pores(&in, 0);
  CHECK_EQUAL(hsp_pores_find_pockets(in.work.pores, 0, 0.99 * window, &pockets), HSP_OK);
  CHECK_EQUAL(pockets, 0); /* the wide probe goes on for ever */
  CHECK_EQUAL(hsp_pores_find_pockets(in.work.pores, 0, 1.01 * window, &pockets), HSP_OK);
  CHECK_EQUAL(pockets, 1);
  for (turn = 0; turn < 40; ++turn) {
    const double floor = turn % 2 == 0 ? 0 : -0.3;
    in.balls.n = 0;
    set_box(&in, 6, turn % 3, 5, 0, turn % 4, 7);
    for (k = 0; k < 10; ++k) {
      double at[4];
      int axis;
      for (axis = 0; axis < 4; ++axis) {
        state = state * 1664525U + 1013904223U;
        at[axis] = 7.0 * (double)(state >> 8) / 16777216.0;
      }
      ball_set_add(&in.balls, at[0], at[1], at[2], 1 + at[3] / 7);
    }
    compute_pores(&in, floor);
    for (k = 0; k < 4; ++k) {
      pockets_against_channels(0.1 * k, 0.1 * k);
      pockets_against_channels(0.1 * k, 0.1 * k + 0.2);
    }
    pockets_against_channels(0, in.wide.through[0] > 0 ? in.wide.through[0] : 0);
    pockets_against_channels(0, in.wide.through[2] > 0 ? 0.999 * in.wide.through[2] : 0);
  }
  CHECK(checked_pockets > 100 && checked_mouths > 100);
}

static void refused_in_a_box(void) {
  uint32_t gate = 0;
  CHECK_EQUAL(hsp_pores_gate_between(in.work.pores, 0, HSP_PORE_OUTSIDE, &gate), HSP_OK);
  CHECK_EQUAL(gate, HSP_NONE);
  CHECK_EQUAL(hsp_pores_compute_periodic(in.work.pores, NULL, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_pores_get_counts(in.work.pores, &in.counts), HSP_E_STATE);
  set_box(&in, 100000, 0, 400, 0, 0, 400);
  in.balls.n = 0;
  ball_set_add(&in.balls, 0, 0, 0, 100);
  CHECK_EQUAL(hsp_workspace_periodic(&in.work, in.balls.n, in.balls.xyz, in.balls.radius, in.box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores_periodic(&in.work, NULL), HSP_E_RANGE); /* too long for its width */
  CHECK_EQUAL(hsp_pores_get_counts(in.work.pores, &in.counts), HSP_E_STATE);
}

/* Of gates that tie some join a class that goes on for ever to a wider one: which of them comes first, numbers decide,
 * and these are others where the box is taken several times. */
static void tied_gates_of_a_channel(void) {
  static const double boxes[2][9] = {{5, 0, 0, -4, 3, 0, 2, -2, 4},
                                     {2.48171011, 0, 0, 2.05990951, 4.39873914, 0, 0.05098067, 2.31683036, 3.55545758}};
  static const double balls[2][16] = {
      {2, -1, 3, 1, -1, 5, 2, 0, 3, 3, 2, 2, 3, 6, -4, 0},
      {2.610967, 3.442225, 3.0736913, 0.45445093, 4.3242515, 0.05255148, 3.0132895, 1.44318169}};
  static const uint32_t count[2] = {4, 2};
  uint32_t which, copies, k, d;
  for (which = 0; which < 2; ++which) {
    hsp_pore_percolation one;
    hsp_model_options options;
    memset(&one, 0, sizeof one);
    hsp_model_options_init(&options, sizeof options);
    options.step = 1e-8;
    for (copies = 0; copies < 8; ++copies) {
      double box[9];
      const int times[3] = {copies & 1 ? 2 : 1, copies & 2 ? 2 : 1, copies & 4 ? 2 : 1};
      int copy[3];
      in.balls.n = 0;
      for (copy[0] = 0; copy[0] < times[0]; ++copy[0]) {
        for (copy[1] = 0; copy[1] < times[1]; ++copy[1]) {
          for (copy[2] = 0; copy[2] < times[2]; ++copy[2]) {
            for (k = 0; k < count[which]; ++k) {
              double at[3];
              for (d = 0; d < 3; ++d) {
                at[d] = balls[which][4 * k + d] + copy[0] * boxes[which][d] + copy[1] * boxes[which][3 + d] +
                        copy[2] * boxes[which][6 + d];
              }
              ball_set_add(&in.balls, at[0], at[1], at[2], balls[which][4 * k + 3]);
            }
          }
        }
      }
      for (k = 0; k < 9; ++k) box[k] = times[k / 3] * boxes[which][k];
      CHECK_EQUAL(hsp_workspace_periodic(&in.work, in.balls.n, in.balls.xyz, in.balls.radius, box, &options, NULL),
                  HSP_OK);
      CHECK_EQUAL(hsp_workspace_pores_periodic(&in.work, NULL), HSP_OK);
      CHECK_EQUAL(hsp_pores_get_percolation(in.work.pores, &in.wide), HSP_OK);
      if (copies == 0) one = in.wide;
      for (d = 0; d < 3; ++d) {
        hsp_pore_maximum top;
        CHECK(in.wide.gate[d] != HSP_NONE);
        CHECK_NEAR(in.wide.through[d], one.through[d], 1e-9);
        CHECK_NEAR(in.wide.included[d], one.included[d], 1e-9);
        CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, in.wide.maximum[d], 1, &top), HSP_OK);
        CHECK(top.radius == in.wide.included[d] && !(top.death >= in.wide.through[d]));
      }
    }
  }
}

/* Of a model nothing winds, and shifts are 0. */
static void without_a_box(void) {
  hsp_pore_channel channels[4];
  hsp_pore_gate_shifts shifts;
  hsp_image images[4];
  uint32_t needed = 0, k;
  in.balls.n = 0;
  ball_set_add(&in.balls, 1, 1, 1, 1);
  ball_set_add(&in.balls, 1, -1, -1, 1);
  ball_set_add(&in.balls, -1, 1, -1, 1);
  ball_set_add(&in.balls, -1, -1, 1, 1);
  CHECK_EQUAL(hsp_workspace_set(&in.work, in.balls.n, in.balls.xyz, in.balls.radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores(&in.work, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_percolation(in.work.pores, &in.wide), HSP_OK);
  CHECK_NEAR(in.wide.largest, sqrt(3) - 1, 1e-8);
  for (k = 0; k < 3; ++k) CHECK(in.wide.gate[k] == HSP_NONE && in.wide.through[k] == 0);
  CHECK_EQUAL(hsp_pores_get_gate_shifts(in.work.pores, 0, 1, &shifts), HSP_OK);
  CHECK(shifts.winds == 0 && shifts.directions == 0);
  for (k = 0; k < 9; ++k) CHECK_EQUAL(shifts.ball[k], 0);
  for (k = 0; k < 6; ++k) CHECK_EQUAL(shifts.end[k], 0);
  CHECK_EQUAL(hsp_pores_get_maximum_images(in.work.pores, 0, images, 4, &needed), HSP_OK);
  CHECK(needed == 4 && images[3].ball == 3 && images[3].shift[0] == 0);
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, 0, channels, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0); /* it is a part of the outside */
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, 0.7, channels, 4, &needed), HSP_OK);
  CHECK(needed == 1 && channels[0].directions == 0 && channels[0].maximum == 0 && channels[0].maxima == 1);
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, 0.7, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 1);
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, NAN, channels, 4, &needed), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, -1, channels, 4, &needed), HSP_E_RANGE);
}

int main(void) {
  static const double upright[9] = {8, 0, 0, 0, 10, 0, 0, 0, 3}, skew[9] = {8, 0, 0, 8, 10, 0, -8, 0, 3};
  static const int32_t along_axes[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  static const int32_t in_skew[3][3] = {{1, 0, 1}, {1, 0, 0}, {-1, 1, 0}};
  static const double other_skew[9] = {8, 0, 0, 8, 10, 0, 8, 0, 3};
  static const int32_t in_other_skew[3][3] = {{1, 0, -1}, {1, 0, 0}, {-1, 1, 0}};
  memset(&in.work, 0, sizeof in.work);
  packings();
  rods(upright, along_axes, 1, 2, 0);
  rods(skew, in_skew, 0, 2, 0);
  rods(other_skew, in_other_skew, 0, 2, 0);
  closed();
  births_and_deaths();
  tied_gates_of_a_channel();
  copies_and_stale_results();
  pockets_in_a_box();
  refused_in_a_box();
  without_a_box();
  hsp_workspace_free(&in.work);
  return check_report();
}
