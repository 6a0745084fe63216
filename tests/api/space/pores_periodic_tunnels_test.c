/* Places, widest probes and tunnels in periodic boxes: closed forms of packings and rods; any balls in upright and skew
 * boxes against a grid whose points are joined from the widest on, each with the copy it belongs to; points of tunnels,
 * their balls and copies against the distance to all images; and the arguments. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "boxed_balls.h"
#include "check.h"

enum { POINTS = 4096, SIDE = 24, NODES = SIDE * SIDE * SIDE, FAR = 3 };
static boxed_balls in;
static hsp_tunnel tunnel;
static hsp_tunnel_route route;
static hsp_pore_passage passage;
static hsp_tunnel_point points[POINTS];
static hsp_tunnel_point_shifts shifts[POINTS];
static uint32_t needed, state = 4711;

static double random_in(double low, double high) {
  state = state * 1664525U + 1013904223U;
  return low + (high - low) * (double)(state >> 8) / (double)(1U << 24);
}

static void moved(const double *from, const int32_t *shift, double *to) {
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    to[axis] = from[axis] + shift[0] * in.box[axis] + shift[1] * in.box[3 + axis] + shift[2] * in.box[6 + axis];
  }
}

static double distance(const double *p, const double *q) {
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return sqrt(x * x + y * y + z * z);
}

/* The largest probe at a point in or near the box, from all images that can be near. */
static double room_at(const double *at) {
  double least = INFINITY;
  int i, j, k;
  uint32_t ball;
  for (ball = 0; ball < in.balls.n; ++ball) {
    for (k = -FAR; k <= FAR; ++k) {
      const double z = in.balls.xyz[3 * ball + 2] + k * in.box[8] - at[2];
      if (fabs(z) - in.balls.radius[ball] > least) continue;
      for (j = -FAR; j <= FAR; ++j) {
        const double y = in.balls.xyz[3 * ball + 1] + k * in.box[7] + j * in.box[4] - at[1];
        if (fabs(y) - in.balls.radius[ball] > least) continue;
        for (i = -FAR; i <= FAR; ++i) {
          const double x = in.balls.xyz[3 * ball] + k * in.box[6] + j * in.box[3] + i * in.box[0] - at[0];
          least = fmin(least, sqrt(x * x + y * y + z * z) - in.balls.radius[ball]);
        }
      }
    }
  }
  return least;
}

/* The same anywhere: moved near to the box first. */
static double room_anywhere(const double *at) {
  int32_t shift[3];
  double near[3];
  shift[2] = -(int32_t)floor(at[2] / in.box[8]);
  shift[1] = -(int32_t)floor((at[1] + shift[2] * in.box[7]) / in.box[4]);
  shift[0] = -(int32_t)floor((at[0] + shift[2] * in.box[6] + shift[1] * in.box[3]) / in.box[0]);
  moved(at, shift, near);
  return room_at(near);
}

/* The grid: its points are joined by descending room. copy: of a point, from that of its set's. */
static double room[NODES];
static uint32_t order[NODES], parent[NODES];
static int copy[NODES][3], winds[NODES];

static int by_room(const void *p, const void *q) {
  const uint32_t a = *(const uint32_t *)p, b = *(const uint32_t *)q;
  return room[a] != room[b] ? (room[a] < room[b] ? 1 : -1) : a < b ? -1 : a > b ? 1 : 0;
}

static void grid_point(uint32_t node, double *at) {
  const double i = node % SIDE, j = node / SIDE % SIDE, k = node / SIDE / SIDE;
  int axis;
  for (axis = 0; axis < 3; ++axis) at[axis] = (i * in.box[axis] + j * in.box[3 + axis] + k * in.box[6 + axis]) / SIDE;
}

static void fill_grid(void) {
  uint32_t node;
  for (node = 0; node < NODES; ++node) {
    double at[3];
    grid_point(node, at);
    room[node] = room_at(at);
    order[node] = node;
  }
  qsort(order, NODES, sizeof *order, by_room);
}

/* The point that stands for a set, and how many boxes away from that this one is; which is kept. */
static uint32_t root_of(uint32_t node, int *from) {
  uint32_t root = node;
  int axis;
  from[0] = from[1] = from[2] = 0;
  for (; parent[root] != root; root = parent[root]) {
    for (axis = 0; axis < 3; ++axis) from[axis] += copy[root][axis];
  }
  if (root == node) return root;
  parent[node] = root;
  memcpy(copy[node], from, sizeof copy[node]);
  return root;
}

/* The room at the tightest point of the widest way from one point of the grid to another, or, if that is the same, to
 * another copy of it: -INFINITY without any. */
static double widest_on_grid(uint32_t from, uint32_t to) {
  uint32_t k;
  for (k = 0; k < NODES; ++k) {
    parent[k] = NODES;
    winds[k] = 0;
  }
  for (k = 0; k < NODES; ++k) {
    const uint32_t node = order[k];
    const int own[3] = {(int)(node % SIDE), (int)(node / SIDE % SIDE), (int)(node / SIDE / SIDE)};
    int step, here[3], there[3];
    parent[node] = node;
    copy[node][0] = copy[node][1] = copy[node][2] = 0;
    for (step = 0; step < 27; ++step) {
      const int by[3] = {step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1};
      int at[3], across[3], axis, same = 1;
      uint32_t other = 0, a, b;
      for (axis = 2; axis >= 0; --axis) {
        at[axis] = (own[axis] + by[axis] + SIDE) % SIDE;
        across[axis] = (own[axis] + by[axis] - at[axis]) / SIDE;
        other = other * SIDE + (uint32_t)at[axis];
      }
      if (step == 13 || parent[other] == NODES) continue;
      a = root_of(node, here);
      b = root_of(other, there);
      for (axis = 0; axis < 3; ++axis) {
        /* Set b's root is so many boxes from that of set a. */
        const int way = across[axis] + here[axis] - there[axis];
        same = same && way == 0;
        if (a != b) copy[b][axis] = way;
      }
      if (a != b) {
        parent[b] = a;
        winds[a] = winds[a] || winds[b];
      } else if (!same) {
        winds[a] = 1;
      }
    }
    if (parent[from] == NODES || parent[to] == NODES) continue;
    if (from == to ? winds[root_of(from, here)] : root_of(from, here) == root_of(to, there)) return room[node];
  }
  return -INFINITY;
}

/* Points, balls and copies of the last tunnel, and where it ends. to: NULL for a copy of from. */
static void check_points(const double *from, const double *to) {
  double end[3], length = 0, cost = 0;
  uint32_t k, gates = 0, b;
  hsp_pore_place place;
  hsp_pore_place_shifts beside;
  CHECK_EQUAL(hsp_pores_get_tunnel_route(in.work.pores, &route), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_tunnel_points(in.work.pores, points, POINTS, &needed), HSP_OK);
  CHECK_EQUAL(needed, tunnel.points);
  CHECK_EQUAL(hsp_pores_get_tunnel_point_shifts(in.work.pores, shifts, POINTS, &needed), HSP_OK);
  CHECK_EQUAL(needed, tunnel.points);
  CHECK(tunnel.outside == 0 && tunnel.reserved == 0 && route.reserved == 0 && needed > 0);
  moved(to == NULL ? from : to, route.shift, end);
  CHECK(distance(points[0].xyz, from) < 1e-6 && distance(points[needed - 1].xyz, end) < 1e-6);
  if (to == NULL) CHECK(route.shift[0] != 0 || route.shift[1] != 0 || route.shift[2] != 0);
  for (k = 0; k < needed; ++k) {
    const hsp_tunnel_point *const point = &points[k];
    double at[3];
    CHECK_NEAR(room_anywhere(point->xyz), point->radius, 1e-6);
    CHECK(point->radius >= tunnel.radius - 1e-6);
    for (b = 0; b < 4 && point->ball[b] != HSP_NONE; ++b) {
      moved(in.balls.xyz + 3 * (size_t)point->ball[b], shifts[k].ball + 3 * (size_t)b, at);
      CHECK_NEAR(distance(at, point->xyz) - in.balls.radius[point->ball[b]], point->radius, 1e-6);
    }
    CHECK(b > 0);
    if (point->gate != HSP_NONE) {
      hsp_pore_gate gate;
      CHECK_EQUAL(hsp_pores_get_gates(in.work.pores, point->gate, 1, &gate), HSP_OK);
      moved(gate.xyz, shifts[k].at, at);
      CHECK(distance(at, point->xyz) < 1e-9);
      CHECK(gate.radius >= tunnel.radius);
      ++gates;
    } else if (point->maximum != HSP_NONE) {
      hsp_pore_maximum top;
      CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, point->maximum, 1, &top), HSP_OK);
      moved(top.xyz, shifts[k].at, at);
      CHECK(distance(at, point->xyz) < 1e-9);
    } else {
      CHECK(shifts[k].at[0] == 0 && shifts[k].at[1] == 0 && shifts[k].at[2] == 0);
    }
    if (k == 0) continue;
    length += distance(point->xyz, points[k - 1].xyz);
    for (b = 1; b < 4; ++b) { /* between two points it is nearly as wide */
      int axis;
      for (axis = 0; axis < 3; ++axis) {
        at[axis] = point->xyz[axis] + 0.25 * b * (points[k - 1].xyz[axis] - point->xyz[axis]);
      }
      CHECK(room_anywhere(at) > tunnel.radius - 0.05);
    }
  }
  CHECK_EQUAL(gates, tunnel.gates);
  CHECK_NEAR(length, tunnel.length, 1e-9 * (1 + length));
  /* The first maximum is that above the start, and which copy of it. */
  CHECK_EQUAL(hsp_pores_locate_with_shifts(in.work.pores, from, &place, &beside), HSP_OK);
  for (k = 0; k < needed && points[k].maximum == HSP_NONE;) ++k;
  CHECK(k < needed && points[k].maximum == place.maximum);
  if (k < needed) CHECK(memcmp(shifts[k].at, beside.maximum, sizeof beside.maximum) == 0);
  moved(in.balls.xyz + 3 * (size_t)place.ball, beside.ball, end);
  CHECK_NEAR(distance(end, from) - in.balls.radius[place.ball], place.radius, 1e-6);
  /* Gates lie between maxima: the cost by straight lines. */
  for (; k < needed; ++k) {
    uint32_t before, after;
    if (points[k].gate == HSP_NONE) continue;
    for (before = k; points[before].maximum == HSP_NONE;) --before;
    for (after = k; points[after].maximum == HSP_NONE;) ++after;
    cost += distance(points[before].xyz, points[k].xyz) / (points[before].radius * points[k].radius);
    cost += distance(points[after].xyz, points[k].xyz) / (points[after].radius * points[k].radius);
  }
  CHECK_NEAR(cost, route.cost, 1e-9 * cost);
}

/* Simple cubic, and two such boxes: from the middle of a cube to the next one, straight through the window. */
static void packings(void) {
  const double edge = 8, top = sqrt(3) / 2 * edge - 1, window = sqrt(2) / 2 * edge - 1;
  static const double middle[3] = {4, 4, 4}, far[3] = {4 + 16 * 40, 4 - 8 * 25, 4 + 8 * 30}, beside[3] = {3.5, 4, 4.2};
  uint32_t kind;
  for (kind = 0; kind < 2; ++kind) {
    hsp_pore_place place;
    hsp_pore_place_shifts beside_shifts;
    in.balls.n = 0;
    ball_set_add(&in.balls, 0, 0, 0, 1);
    if (kind == 1) ball_set_add(&in.balls, edge, 3 * edge, -edge, 1);
    set_box(&in, edge * (1 + kind), 0, edge, 0, 0, edge);
    compute_pores(&in, 0);
    CHECK_EQUAL(hsp_pores_locate_with_shifts(in.work.pores, far, &place, &beside_shifts), HSP_OK);
    CHECK_NEAR(place.radius, top, 1e-7);
    CHECK(place.maximum < in.counts.maxima);
    if (kind == 0) CHECK(beside_shifts.maximum[0] == 80 && beside_shifts.maximum[2] == 30);
    CHECK_EQUAL(beside_shifts.maximum[1], -25);
    CHECK_EQUAL(hsp_pores_widest(in.work.pores, middle, NULL, &passage), HSP_OK);
    CHECK_NEAR(passage.radius, window, 1e-7);
    CHECK(passage.passes == 1 && passage.gate < in.counts.gates && passage.ball == HSP_NONE);
    CHECK(passage.at[0] == passage.at[1] && passage.reserved == 0);
    CHECK_EQUAL(hsp_workspace_tunnel_periodic(&in.work, NULL, middle, NULL, NULL, 0, &tunnel), HSP_OK);
    CHECK(tunnel.there == 1 && tunnel.gates == 1 && tunnel.radius == passage.radius);
    CHECK_NEAR(tunnel.length, edge, 1e-6);
    check_points(middle, NULL);
    CHECK_NEAR(route.cost, edge / (top * window), 1e-6);
    CHECK_EQUAL(abs(route.shift[0]) + abs(route.shift[1]) + abs(route.shift[2]), 1);
    /* The way up from beside the middle is no part of the cost, and leads back to its copy. */
    CHECK_EQUAL(hsp_pores_find_cheapest_tunnel(in.work.pores, beside, NULL, NULL, 0, &tunnel, NULL), HSP_OK);
    CHECK(tunnel.there == 1 && tunnel.gates == 1 && tunnel.length > edge);
    check_points(beside, NULL);
    CHECK_NEAR(route.cost, edge / (top * window), 1e-6);
    /* To itself far away: any copy is as good. */
    CHECK_EQUAL(hsp_pores_widest(in.work.pores, middle, far, &passage), HSP_OK);
    if (kind == 0) CHECK(passage.gate == HSP_NONE && passage.ball == 0);
    CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, middle, far, NULL, 0, &tunnel, NULL), HSP_OK);
    check_points(middle, far);
    if (kind == 0) {
      CHECK(tunnel.gates == 0 && tunnel.gate == HSP_NONE && route.cost == 0);
      CHECK(route.shift[0] == -80 && route.shift[1] == 25 && route.shift[2] == -30);
    }
  }
}

/* In an upright box of 8 x 10 x 3 with one ball the best ways lead along z, then x, then y, as gates are avoided. */
static void rods(void) {
  static const double from[3] = {-1, 7, 2.5};
  static const int axis_of[3] = {2, 0, 1};
  static const double lengths[3] = {3, 8, 10};
  uint32_t avoided[3], k;
  in.balls.n = 0;
  ball_set_add(&in.balls, 3, 2, 1, 1.6);
  set_box(&in, 8, 0, 10, 0, 0, 3);
  compute_pores(&in, 0);
  for (k = 0; k < 3; ++k) {
    int axis;
    CHECK_EQUAL(hsp_workspace_tunnel_periodic(&in.work, NULL, from, NULL, avoided, k, &tunnel), HSP_OK);
    CHECK(tunnel.there == 1 && tunnel.gate == k && tunnel.gates == 1);
    CHECK_NEAR(tunnel.length, lengths[k], 1e-6);
    check_points(from, NULL);
    for (axis = 0; axis < 3; ++axis) CHECK_EQUAL(abs(route.shift[axis]), axis == axis_of[k] ? 1 : 0);
    avoided[k] = tunnel.gate;
  }
  CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, from, NULL, avoided, 3, &tunnel, NULL), HSP_OK);
  CHECK(tunnel.there == 0 && tunnel.points == 0 && tunnel.gate == HSP_NONE && tunnel.length == 0);
  CHECK_EQUAL(hsp_pores_get_tunnel_route(in.work.pores, &route), HSP_OK);
  CHECK(route.cost == 0 && route.shift[0] == 0 && route.shift[1] == 0 && route.shift[2] == 0);
}

/* For every maximum: the channel that it is in below the widest probe goes on for ever, above it does not. */
static void widest_against_channels(void) {
  static hsp_pore_channel channels[512];
  hsp_pore_percolation wide;
  double best = -INFINITY;
  uint32_t k, side, c;
  CHECK_EQUAL(hsp_pores_get_percolation(in.work.pores, &wide), HSP_OK);
  for (k = 0; k < in.counts.maxima; ++k) {
    hsp_pore_maximum top;
    CHECK_EQUAL(hsp_pores_get_maxima(in.work.pores, k, 1, &top), HSP_OK);
    CHECK_EQUAL(hsp_pores_widest(in.work.pores, top.xyz, NULL, &passage), HSP_OK);
    if (top.radius < 1e-6 || passage.at[0] != k) continue;
    best = passage.passes == 1 ? fmax(best, passage.radius) : best;
    for (side = 0; side < 2; ++side) {
      const double radius = passage.passes == 1 ? (side == 0 ? passage.radius : nextafter(passage.radius, -9)) : 0;
      uint32_t member = 0, directions = 0;
      if (radius < 0 || (passage.passes == 1 && passage.gate == HSP_NONE)) continue;
      CHECK_EQUAL(hsp_pores_class_at(in.work.pores, k, radius, &member), HSP_OK);
      CHECK_EQUAL(hsp_pores_get_channels(in.work.pores, radius, channels, 512, &needed), HSP_OK);
      for (c = 0; c < needed; ++c) directions = channels[c].maximum == member ? channels[c].directions : directions;
      CHECK_EQUAL(directions > 0, passage.passes == 1 && side == 1);
    }
  }
  if (wide.gate[0] != HSP_NONE && wide.through[0] > 1e-6) CHECK_EQUAL(best, wide.through[0]);
}

/* Two rooms without a way between them, or to their copies. */
static void closed_rooms(void) {
  static const double one[3] = {2, 2, 2}, other[3] = {6, 2, -2}, copy_of_one[3] = {10, -2, 6};
  in.balls.n = 0;
  ball_set_add(&in.balls, 0, 0, 0, 2.9);
  ball_set_add(&in.balls, 4, 0, 0, 2.9);
  set_box(&in, 8, 0, 4, 0, 0, 4);
  compute_pores(&in, 0);
  CHECK(in.counts.maxima == 2 && in.counts.gates == 0);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, one, NULL, &passage), HSP_OK);
  CHECK(passage.passes == 0 && passage.radius == 0 && passage.gate == HSP_NONE && passage.ball == HSP_NONE);
  CHECK(passage.at[0] < 2 && passage.at[1] == passage.at[0]);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, one, other, &passage), HSP_OK);
  CHECK(passage.passes == 0 && passage.at[0] + passage.at[1] == 1);
  CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, one, other, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK_EQUAL(tunnel.there, 0);
  CHECK_EQUAL(hsp_pores_find_cheapest_tunnel(in.work.pores, one, NULL, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK_EQUAL(tunnel.there, 0);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, one, copy_of_one, &passage), HSP_OK);
  CHECK(passage.passes == 1 && passage.gate == HSP_NONE && passage.ball < 2);
  CHECK_NEAR(passage.radius, 2 * sqrt(3) - 2.9, 1e-8);
}

static uint32_t ways, loops;

static void compare(const double *from, uint32_t node, const double *to, uint32_t other) {
  const int32_t shift[3] = {3, -2, 1};
  double diagonal = 0, grid, far[3];
  hsp_pore_passage moved_passage;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const double across = fabs(in.box[axis]) + fabs(in.box[3 + axis]) + fabs(in.box[6 + axis]);
    diagonal += across * across / SIDE / SIDE;
  }
  diagonal = sqrt(diagonal);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, from, to, &passage), HSP_OK);
  CHECK_EQUAL(hsp_workspace_tunnel_periodic(&in.work, NULL, from, to, NULL, 0, &tunnel), HSP_OK);
  CHECK_EQUAL(tunnel.there, passage.passes);
  CHECK(tunnel.radius == passage.radius);
  grid = widest_on_grid(node, other);
  /* A probe that gets along the grid does between its points, up to half of their distance; ways lead by near some. */
  if (grid > diagonal) CHECK(passage.passes == 1 && passage.radius > grid - diagonal / 2);
  if (passage.passes == 1) CHECK(grid > passage.radius - diagonal);
  moved(from, shift, far);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, far, to, &moved_passage), HSP_OK);
  CHECK(moved_passage.passes == passage.passes && fabs(moved_passage.radius - passage.radius) < 1e-6);
  if (passage.passes == 0) return;
  ++*(to == NULL ? &loops : &ways);
  check_points(from, to);
  {
    const double by_width = route.cost, width = tunnel.radius;
    CHECK_EQUAL(hsp_workspace_cheapest_tunnel_periodic(&in.work, NULL, from, to, NULL, 0, &tunnel), HSP_OK);
    CHECK(tunnel.there == 1 && tunnel.radius <= width);
    check_points(from, to);
    CHECK(route.cost <= by_width * (1 + 1e-9));
  }
}

static void any_balls(void) {
  uint32_t turn, k, free_nodes;
  for (turn = 0; turn < 16; ++turn) {
    in.balls.n = 0;
    set_box(&in, 6, turn % 3, 5, turn % 2, turn % 4 - 1.0, 7);
    for (k = 0; k < 4 + turn % 8; ++k) {
      ball_set_add(&in.balls, random_in(-3, 9), random_in(-3, 9), random_in(-3, 9),
                   random_in(0.6, turn % 2 == 0 ? 1.9 : 2.6));
    }
    compute_pores(&in, 0);
    widest_against_channels();
    fill_grid();
    for (free_nodes = 0; free_nodes < NODES && room[order[free_nodes]] > 0.02;) ++free_nodes;
    for (k = 0; k < 4 && free_nodes > 0; ++k) {
      const uint32_t node = order[(uint32_t)random_in(0, free_nodes)];
      const uint32_t other = order[(uint32_t)random_in(0, free_nodes)];
      double from[3], to[3];
      grid_point(node, from);
      grid_point(other, to);
      compare(from, node, k < 2 ? NULL : to, k < 2 ? node : other);
    }
  }
  CHECK(ways > 20 && loops > 20);
}

static void arguments(void) {
  static const double at[3] = {4, 4, 4}, in_ball[3] = {8.5, 0, 0}, beyond[3] = {8.0 * (1 << 18), 0, 0};
  static const double huge[3] = {0, 1e300, 0}, odd[3] = {0, 0, (double)NAN};
  const uint32_t avoided[1] = {99};
  hsp_pore_place place;
  hsp_pore_place_shifts beside;
  hsp_tunnel_point_shifts one;
  in.balls.n = 0;
  ball_set_add(&in.balls, 0, 0, 0, 1);
  set_box(&in, 8, 0, 8, 0, 0, 8);
  compute_pores(&in, 0);
  CHECK_EQUAL(hsp_pores_get_tunnel_route(in.work.pores, &route), HSP_OK);
  CHECK(route.cost == 0 && route.shift[0] == 0);
  CHECK_EQUAL(hsp_pores_get_tunnel_point_shifts(in.work.pores, NULL, 0, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0);
  CHECK_EQUAL(hsp_pores_locate(in.work.pores, huge, &place), HSP_E_RANGE);
  CHECK_EQUAL(hsp_pores_locate(in.work.pores, beyond, &place), HSP_E_RANGE);
  CHECK_EQUAL(hsp_pores_locate(in.work.pores, odd, &place), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, at, beyond, &passage), HSP_E_RANGE);
  CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, beyond, at, NULL, 0, &tunnel, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_pores_find_cheapest_tunnel(in.work.pores, at, odd, NULL, 0, &tunnel, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_pores_find_cheapest_tunnel(in.work.pores, at, NULL, avoided, 1, &tunnel, NULL), HSP_E_ID);
  CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, at, NULL, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_tunnel_point_shifts(in.work.pores, &one, 1, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, tunnel.points);
  /* In a ball nothing is above, and nothing gets out. */
  CHECK_EQUAL(hsp_pores_locate_with_shifts(in.work.pores, in_ball, &place, &beside), HSP_OK);
  CHECK(place.radius == -0.5 && place.ball == 0 && place.maximum == HSP_NONE);
  CHECK(beside.ball[0] == 1 && beside.ball[1] == 0 && beside.maximum[0] == 0);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, in_ball, NULL, &passage), HSP_OK);
  CHECK(passage.passes == 0 && passage.radius == 0 && passage.at[0] == HSP_NONE && passage.at[1] == HSP_NONE);
  CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, in_ball, NULL, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK_EQUAL(tunnel.there, 0);
  CHECK_EQUAL(hsp_pores_get_tunnel_route(in.work.pores, &route), HSP_OK);
  CHECK(route.cost == 0 && route.shift[0] == 0);
  /* Of a box without balls everything is outside. */
  in.balls.n = 0;
  compute_pores(&in, 0);
  CHECK_EQUAL(hsp_pores_locate_with_shifts(in.work.pores, at, &place, &beside), HSP_OK);
  CHECK(isinf(place.radius) && place.ball == HSP_NONE && place.maximum == HSP_PORE_OUTSIDE && beside.ball[0] == 0);
  CHECK_EQUAL(hsp_pores_widest(in.work.pores, at, NULL, &passage), HSP_OK);
  CHECK(passage.passes == 1 && isinf(passage.radius) && passage.at[1] == HSP_PORE_OUTSIDE);
  CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, at, NULL, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK(tunnel.there == 1 && tunnel.gates == 0 && isinf(tunnel.radius));
  CHECK(tunnel.points == 1 && tunnel.outside == 1 && tunnel.length == 0); /* as without a box */
  /* A floor below 0: the widest way is there, but costs without end. */
  ball_set_add(&in.balls, 0, 0, 0, 3);
  set_box(&in, 4, 0, 4, 0, 0, 4);
  compute_pores(&in, -2.9);
  CHECK_EQUAL(hsp_pores_find_tunnel(in.work.pores, at, NULL, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK_EQUAL(tunnel.there, 0); /* nothing is as wide as the floor there: it is in a ball */
}

int main(void) {
  memset(&in.work, 0, sizeof in.work);
  packings();
  rods();
  closed_rooms();
  any_balls();
  arguments();
  hsp_workspace_free(&in.work);
  return check_report();
}
