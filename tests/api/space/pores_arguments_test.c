/* Pores: arguments that tests/laws says nothing about, every call out of order, options, and how the last pockets and
 * the last tunnel come and go. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { CAGE = 26, MAXIMA = 64, GATES = 200, TIED = 400, CANDIDATES = 2000, NEIGHBOURS = 40, POINTS = 400 };
static unsigned char model_memory[HSP_MODEL_BYTES(CAGE)];
static unsigned char pores_memory[HSP_PORES_BYTES(CAGE, MAXIMA, GATES, TIED, CANDIDATES, NEIGHBOURS, POINTS)];
static unsigned char fewer_memory[HSP_MODEL_BYTES(CAGE)];
static unsigned char before_memory[HSP_PORES_BYTES(CAGE, MAXIMA, GATES, TIED, CANDIDATES, NEIGHBOURS, POINTS)];
static hsp_model *model, *fewer;
static hsp_pores *pores, *before;
static hsp_pores_counts counts;
static hsp_pores_options options;
static hsp_tunnel tunnel;
static hsp_tunnel_point points[POINTS];
static uint32_t number;
static const double middle[3] = {10, 10, 10}, beside[3] = {11, 9, 10}, away[3] = {10, 10, 100};

static hsp_pores_limits roomy(void) {
  const hsp_pores_limits limits = {(uint32_t)sizeof limits, CAGE, MAXIMA, GATES, TIED, CANDIDATES, NEIGHBOURS, POINTS};
  return limits;
}

/* 26 balls of a cubic lattice around a place without one. */
static void set_cage(double radius) {
  double xyz[3 * CAGE], radii[CAGE];
  uint32_t n = 0, x, y, z;
  for (x = 0; x < 3; ++x) {
    for (y = 0; y < 3; ++y) {
      for (z = 0; z < 3; ++z) {
        if (x == 1 && y == 1 && z == 1) continue;
        xyz[3 * n] = 10.0 * x;
        xyz[3 * n + 1] = 10.0 * y;
        xyz[3 * n + 2] = 10.0 * z;
        radii[n++] = radius;
      }
    }
  }
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radii, NULL, NULL), HSP_OK);
}

static void compute(double floor) {
  options.floor = floor;
  CHECK_EQUAL(hsp_pores_compute(pores, model, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_counts(pores, &counts), HSP_OK);
}

/* One limit, or all, at or above a power of two, where tables grow; the others small. */
static void sizes(void) {
  static const uint32_t small[2] = {0, 1};
  uint32_t which, other, exponent, k;
  for (which = 0; which < 8; ++which) {
    for (exponent = 0; exponent < 21; ++exponent) {
      for (k = 0; k < 4; ++k) {
        uint32_t n[8] = {0};
        hsp_pores_limits limits;
        size_t bytes = 0;
        for (other = 1; other < 8; ++other) {
          n[other] = which == 0 || which == other ? (UINT32_C(1) << exponent) + k / 2 : small[k % 2];
        }
        n[0] = (uint32_t)sizeof limits;
        memcpy(&limits, n, sizeof limits);
        CHECK_EQUAL(hsp_pores_bytes(&limits, &bytes), HSP_OK);
        CHECK(bytes > 0 && bytes <= HSP_PORES_BYTES(n[1], n[2], n[3], n[4], n[5], n[6], n[7]));
      }
    }
  }
}

static void defaults(void) {
  hsp_pores_limits limits;
  const uint32_t most = (HSP_MAX_BALLS - 2048) / 8;
  size_t bytes = 0;
  CHECK_EQUAL(hsp_pores_limits_init(&limits, (uint32_t)sizeof limits, most + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_pores_limits_init(&limits, (uint32_t)sizeof limits, most), HSP_OK);
  CHECK_EQUAL(hsp_pores_limits_init(&limits, (uint32_t)sizeof limits, 10), HSP_OK);
  CHECK(limits.balls == 10 && limits.maxima == 84 && limits.gates == 168 && limits.tied == 266);
  CHECK(limits.candidates == 2088 && limits.neighbours == 26 && limits.points == 4106);
  /* The header's words on a large set. */
  CHECK_EQUAL(hsp_pores_limits_init(&limits, (uint32_t)sizeof limits, 1000000), HSP_OK);
  CHECK_EQUAL(hsp_pores_bytes(&limits, &bytes), HSP_OK);
  CHECK((double)bytes < 1.9e9);
  CHECK_EQUAL(hsp_pores_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK(options.struct_size == sizeof options && options.reserved == 0 && options.floor == 0);
}

/* Limits that come back suffice, also where the search takes all the room that it is given: beside a curve of balls. */
static void limits_that_come_back(void) {
  enum { CURVE = 200 };
  static unsigned char curve_memory[HSP_MODEL_BYTES(CURVE)];
  double xyz[3 * CURVE] = {0}, radii[CURVE];
  hsp_pores_limits limits;
  hsp_model *curve;
  hsp_pores *along;
  uint32_t k;
  CHECK_EQUAL(hsp_model_init(curve_memory, sizeof curve_memory, CURVE, &curve), HSP_OK);
  for (k = 0; k < CURVE; ++k) {
    xyz[3 * k] = k;
    xyz[3 * k + 1] = 0.01 * k * k;
    radii[k] = 1;
  }
  CHECK_EQUAL(hsp_model_set(curve, CURVE, xyz, radii, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_limits_init(&limits, (uint32_t)sizeof limits, CURVE), HSP_OK);
  for (k = 0; k < 2; ++k) {
    void *memory;
    size_t bytes;
    CHECK_EQUAL(hsp_pores_bytes(&limits, &bytes), HSP_OK);
    memory = malloc(bytes);
    CHECK_EQUAL(hsp_pores_init(memory, bytes, &limits, &along), HSP_OK);
    CHECK_EQUAL(hsp_pores_compute(along, curve, NULL, &limits), HSP_OK);
    free(memory);
  }
}

static void bad_options(void) {
  set_cage(6);
  options.reserved = 1;
  CHECK_EQUAL(hsp_pores_compute(pores, model, &options, NULL), HSP_E_VERSION);
  options.reserved = 0;
  options.floor = (double)NAN;
  CHECK_EQUAL(hsp_pores_compute(pores, model, &options, NULL), HSP_E_NOT_FINITE);
  options.floor = -(double)INFINITY;
  CHECK_EQUAL(hsp_pores_compute(pores, model, &options, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_pores_get_counts(pores, &counts), HSP_E_STATE);
}

/* Pores of fewer balls, which have grown since, say the same sooner; they have to be others, and to have results. */
static void points_of_pores_before(void) {
  static const double xyz[9] = {0, 0, 0, 10, 0, 0, 5, 8, 0}, radius[4] = {2, 2, 3, 1}, grown[4] = {3, 3, 4, 1};
  static const double more[12] = {0, 0, 0, 10, 0, 0, 5, 8, 0, 5, 3, 4};
  hsp_pore_gate anew[4], taken[4];
  uint32_t gates;
  CHECK_EQUAL(hsp_model_set(fewer, 3, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 4, more, grown, NULL, NULL), HSP_OK);
  compute(-1);
  gates = counts.gates;
  CHECK(gates > 0 && gates <= 4);
  CHECK_EQUAL(hsp_pores_get_gates(pores, 0, gates, anew), HSP_OK);
  options.before = pores;
  CHECK_EQUAL(hsp_pores_compute(pores, model, &options, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_pores_get_counts(pores, &counts), HSP_E_STATE);
  options.before = before;
  CHECK_EQUAL(hsp_pores_compute(pores, model, &options, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_pores_compute(before, fewer, NULL, NULL), HSP_OK);
  compute(-1);
  CHECK_EQUAL(counts.gates, gates);
  CHECK_EQUAL(hsp_pores_get_gates(pores, 0, gates, taken), HSP_OK);
  CHECK(memcmp(anew, taken, gates * sizeof *anew) == 0);
  CHECK_EQUAL(hsp_model_set(fewer, 2, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_compute(pores, model, &options, NULL), HSP_E_STATE);
  options.before = NULL;
}

/* Higher floors hide what is below; where nothing can be, there is nothing. */
static void floors(void) {
  hsp_pore_maximum widest;
  uint32_t gates;
  set_cage(6);
  compute(-1e300);
  CHECK(counts.maxima > 0 && counts.cavities == 0);
  gates = counts.gates;
  compute(-6);
  CHECK_EQUAL(counts.gates, gates);
  compute(0);
  CHECK(counts.maxima == 9 && counts.cavities == 0 && counts.merges == 9);
  compute(3);
  CHECK(counts.maxima == 1 && counts.cavities == 1 && counts.gates == 0);
  CHECK_EQUAL(hsp_pores_get_maxima(pores, 0, 1, &widest), HSP_OK);
  CHECK(widest.gate == HSP_NONE && widest.parent == HSP_NONE && widest.death == 3 && widest.radius == 4);
  compute(4); /* a level is above the floor */
  CHECK(counts.maxima == 0);
  compute(1e300);
  CHECK(counts.maxima == 0 && counts.gates == 0);
}

static void pockets_come_and_go(void) {
  hsp_pore_pocket pocket;
  set_cage(6);
  compute(0);
  CHECK_EQUAL(hsp_pores_get_pockets(pores, 0, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_pockets(pores, 0, 1, &pocket), HSP_E_ID);
  CHECK_EQUAL(hsp_pores_find_pockets(pores, 0.5, 3, &number), HSP_OK);
  CHECK_EQUAL(number, 1);
  CHECK_EQUAL(hsp_pores_get_pockets(pores, 0, 1, &pocket), HSP_OK);
  FILL(number);
  CHECK_EQUAL(hsp_pores_find_pockets(pores, 3, 0.5, &number), HSP_E_ARGUMENT);
  CHECK_UNTOUCHED(number);
  CHECK_EQUAL(hsp_pores_get_pockets(pores, 0, 1, &pocket), HSP_E_ID);
  CHECK_EQUAL(hsp_pores_find_pockets(pores, -1e-3, 3, &number), HSP_E_RANGE);
  CHECK_EQUAL(hsp_pores_find_pockets(pores, 0, 0, &number), HSP_OK);
  CHECK_EQUAL(hsp_pores_compute(pores, model, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_pockets(pores, 0, 1, &pocket), HSP_E_ID);
}

static void classes(void) {
  set_cage(6);
  compute(0);
  CHECK_EQUAL(hsp_pores_class_at(pores, 0, -1e-3, &number), HSP_E_RANGE);
  CHECK_EQUAL(hsp_pores_class_at(pores, 0, 0, &number), HSP_OK);
  CHECK_EQUAL(number, HSP_PORE_OUTSIDE);
  CHECK_EQUAL(hsp_pores_class_at(pores, 0, 3.9, &number), HSP_OK);
  CHECK_EQUAL(number, 0);
  CHECK_EQUAL(hsp_pores_class_at(pores, 0, 4, &number), HSP_OK); /* not narrower than what is there */
  CHECK_EQUAL(number, HSP_NONE);
  CHECK_EQUAL(hsp_pores_class_at(pores, HSP_PORE_OUTSIDE, 100, &number), HSP_OK);
  CHECK_EQUAL(number, HSP_PORE_OUTSIDE);
  CHECK_EQUAL(hsp_pores_class_at(pores, 9, 0, &number), HSP_E_ID);
  CHECK_EQUAL(hsp_pores_gate_between(pores, 0, HSP_PORE_OUTSIDE, &number), HSP_OK);
  CHECK(number < counts.gates);
  CHECK_EQUAL(hsp_pores_gate_between(pores, HSP_PORE_OUTSIDE, HSP_PORE_OUTSIDE, &number), HSP_OK);
  CHECK_EQUAL(number, HSP_NONE);
  CHECK_EQUAL(hsp_pores_gate_between(pores, 0, 9, &number), HSP_E_ID);
}

/* On the finest lattice lengths of less than some steps are subnormal: up to 2^51 levels have the same one. */
static void probes_of_next_to_no_width(void) {
  static const double widths[4] = {1e-321, 1e-318, 1e-315, 1e-310};
  const hsp_model_options finest = {(uint32_t)sizeof finest, 0, 0, 5.6e-309, 0};
  const double side = 1e6 * finest.step;
  double xyz[24], radii[8];
  uint32_t k;
  for (k = 0; k < 8; ++k) {
    xyz[3 * k] = 4 * side * (k & 1);
    xyz[3 * k + 1] = 4 * side * (k >> 1 & 1);
    xyz[3 * k + 2] = 4 * side * (k >> 2 & 1);
    radii[k] = side;
  }
  CHECK_EQUAL(hsp_model_set(model, 8, xyz, radii, &finest, NULL), HSP_OK);
  compute(-0.5 * side);
  CHECK(counts.maxima == 1 && counts.gates == 6);
  for (k = 0; k < 8; ++k) {
    const double width = (k & 1) != 0 ? widths[k / 2] : -widths[k / 2];
    CHECK_EQUAL(hsp_pores_class_at(pores, 0, width, &number), HSP_OK);
    CHECK_EQUAL(number, HSP_PORE_OUTSIDE);
    CHECK_EQUAL(hsp_pores_get_channels(pores, width, NULL, 0, &number), HSP_OK);
    CHECK_EQUAL(number, 0);
    CHECK_EQUAL(hsp_pores_find_pockets(pores, width, side, &number), HSP_OK);
  }
}

/* Gates of a cube of balls of 13860 steps, 19601 steps apart, are 1.8e-5 steps wide: the length is subnormal, and some
 * 2^17 levels have it. A probe of this width, to the last bit, does not pass; the next narrower one does. In larger
 * cubes the gate has another place among these levels. */
static void gates_of_next_to_no_width(void) {
  const hsp_model_options finest = {(uint32_t)sizeof finest, 0, 0, 5.6e-309, 0};
  hsp_pore_gate gate;
  double xyz[24], radii[8];
  uint32_t times, k;
  for (times = 1; times <= 16; ++times) {
    const double side = times * 19601 * finest.step;
    for (k = 0; k < 8; ++k) {
      xyz[3 * k] = side * (k & 1);
      xyz[3 * k + 1] = side * (k >> 1 & 1);
      xyz[3 * k + 2] = side * (k >> 2 & 1);
      radii[k] = times * 13860 * finest.step;
    }
    CHECK_EQUAL(hsp_model_set(model, 8, xyz, radii, &finest, NULL), HSP_OK);
    compute(0);
    CHECK(counts.maxima == 1 && counts.gates == 6);
    CHECK_EQUAL(hsp_pores_get_gates(pores, 0, 1, &gate), HSP_OK);
    CHECK(gate.radius > 1e-314 && gate.radius < 2e-312);
    CHECK_EQUAL(hsp_pores_class_at(pores, 0, gate.radius, &number), HSP_OK);
    CHECK_EQUAL(number, 0);
    CHECK_EQUAL(hsp_pores_class_at(pores, 0, nextafter(gate.radius, 0), &number), HSP_OK);
    CHECK_EQUAL(number, HSP_PORE_OUTSIDE);
  }
}

/* From the middle and from beside it: once the gates that are avoided close the cage nothing gets out. */
static void tunnels_avoid_gates(void) {
  uint32_t avoided[GATES], count = 0, k;
  hsp_tunnel_point one;
  set_cage(6);
  compute(0);
  CHECK_EQUAL(hsp_pores_get_tunnel_points(pores, NULL, 0, NULL), HSP_OK);
  for (;; ++count) {
    CHECK_EQUAL(hsp_pores_find_tunnel(pores, count % 2 == 0 ? middle : beside, NULL, avoided, count, &tunnel, NULL),
                HSP_OK);
    CHECK_EQUAL(tunnel.reserved, 0);
    if (tunnel.there == 0 || count == GATES) break;
    CHECK(tunnel.outside == 1 && tunnel.gates >= 1 && tunnel.points > 2);
    for (k = 0; k < count; ++k) CHECK(avoided[k] != tunnel.gate);
    avoided[count] = tunnel.gate;
  }
  CHECK_EQUAL(count, 24); /* four squares on each of six sides */
  CHECK(tunnel.points == 0 && tunnel.radius == 0 && tunnel.length == 0 && tunnel.gate == HSP_NONE);
  CHECK_EQUAL(hsp_pores_get_tunnel_points(pores, points, POINTS, &number), HSP_OK);
  CHECK_EQUAL(number, 0);
  avoided[0] = counts.gates;
  CHECK_EQUAL(hsp_pores_find_tunnel(pores, middle, NULL, avoided, 1, &tunnel, NULL), HSP_E_ID);
  CHECK_EQUAL(hsp_pores_find_tunnel(pores, middle, away, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_tunnel_points(pores, &one, 1, &number), HSP_E_CAPACITY);
  CHECK_EQUAL(number, tunnel.points);
  CHECK_EQUAL(hsp_pores_get_tunnel_points(pores, points, POINTS, NULL), HSP_OK);
  CHECK(memcmp(points[0].xyz, middle, sizeof middle) == 0 && memcmp(points[number - 1].xyz, away, sizeof away) == 0);
  CHECK_EQUAL(hsp_pores_find_tunnel(pores, middle, NULL, NULL, 1, &tunnel, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_pores_get_tunnel_points(pores, NULL, 0, &number), HSP_OK);
  CHECK_EQUAL(number, 0);
}

/* No balls, one, and a point in one. */
static void few_balls(void) {
  static const double at[3] = {1, 2, 3}, radius[1] = {2};
  hsp_pore_place place;
  hsp_pore_passage passage;
  uint32_t n;
  for (n = 0; n < 2; ++n) {
    CHECK_EQUAL(hsp_model_set(model, n, at, radius, NULL, NULL), HSP_OK);
    compute(0);
    CHECK(counts.maxima == 0 && counts.gates == 0 && counts.outer_balls == n && counts.reserved == 0);
    CHECK_EQUAL(hsp_pores_locate(pores, middle, &place), HSP_OK);
    CHECK(place.maximum == HSP_PORE_OUTSIDE && place.ball == (n == 0 ? HSP_NONE : 0));
    CHECK(n == 0 ? isinf(place.radius) : fabs(place.radius - (sqrt(194) - 2)) < 1e-12);
    CHECK_EQUAL(hsp_pores_widest(pores, middle, NULL, &passage), HSP_OK);
    CHECK(passage.passes == 1 && passage.gate == HSP_NONE && passage.ball == place.ball);
    CHECK(passage.radius == place.radius && passage.reserved == 0);
    CHECK_EQUAL(hsp_pores_find_tunnel(pores, middle, NULL, NULL, 0, &tunnel, NULL), HSP_OK);
    CHECK(tunnel.there == 1 && tunnel.gates == 0 && tunnel.radius == place.radius && tunnel.points == 1);
  }
  CHECK_EQUAL(hsp_pores_locate(pores, at, &place), HSP_OK);
  CHECK(place.radius == -2 && place.ball == 0 && place.maximum == HSP_NONE);
  CHECK_EQUAL(hsp_pores_widest(pores, at, middle, &passage), HSP_OK);
  CHECK(passage.passes == 0 && passage.radius == 0 && passage.ball == HSP_NONE && passage.at[0] == HSP_NONE);
  CHECK_EQUAL(hsp_pores_find_tunnel(pores, at, middle, NULL, 0, &tunnel, NULL), HSP_OK);
  CHECK(tunnel.there == 0 && tunnel.points == 0);
}

int main(void) {
  const hsp_pores_limits limits = roomy();
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, CAGE, &model), HSP_OK);
  CHECK_EQUAL(hsp_pores_init(pores_memory, sizeof pores_memory, &limits, &pores), HSP_OK);
  CHECK_EQUAL(hsp_model_init(fewer_memory, sizeof fewer_memory, CAGE, &fewer), HSP_OK);
  CHECK_EQUAL(hsp_pores_init(before_memory, sizeof before_memory, &limits, &before), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_pockets(pores, 0, 1, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_pores_find_pockets(pores, 1, 0, &number), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_pores_find_tunnel(pores, middle, NULL, NULL, 0, &tunnel, NULL), HSP_E_STATE);
  sizes();
  defaults();
  limits_that_come_back();
  bad_options();
  points_of_pores_before();
  floors();
  pockets_come_and_go();
  classes();
  probes_of_next_to_no_width();
  gates_of_next_to_no_width();
  tunnels_avoid_gates();
  few_balls();
  return check_report();
}
