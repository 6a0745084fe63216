/* Balls that move: arguments that tests/laws says nothing about, sizes, what a move changes and what it does not, and
 * all numbers against a new model of the same balls. Many sets and moves stand against new computations in
 * unit_moving_moving_balls. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "limit_sweep.h"
#include "moving_result.h"
#include "untouched.h"

enum { BALLS = 6, SMALL = 3 };
static const double step = 1e-6, largest_radius = 1.5;
static const double sigma[BALLS] = {1, 2, 0.5, 1, 3, 1};

static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)], other_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 64, 32)];
static unsigned char moving_memory[HSP_MOVING_BYTES(BALLS, BALLS)];
static hsp_model *model, *other;
static hsp_boundary *boundary;
static hsp_moving *moving;

/* A chain along x, and one ball beside it; what they become by moves. */
static const double start[3 * BALLS] = {0, 0, 0, 1.5, 0, 0, 3, 0, 0, 4.5, 0, 0, 6, 0, 0, 3, 1.25, 0};
static double xyz[3 * BALLS], radius[BALLS];

static hsp_model_options options_of_model(double probe) {
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = step;
  options.largest_radius = largest_radius;
  options.probe = probe;
  return options;
}

static int32_t set_with_room_for(uint32_t balls, uint32_t neighbours, double probe, hsp_moving_limits *limits) {
  const hsp_moving_limits room = {(uint32_t)sizeof room, balls, neighbours};
  const hsp_model_options options = options_of_model(probe);
  uint32_t i;
  memcpy(xyz, start, sizeof xyz);
  for (i = 0; i < BALLS; ++i) radius[i] = i == 5 ? 0.5 : 1;
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_init(moving_memory, sizeof moving_memory, &room, &moving), HSP_OK);
  return hsp_moving_set(moving, model, sigma, 1.5, -0.25, HSP_TANGENT_OVERLAP, limits, NULL);
}

static void make(void) {
  const hsp_boundary_limits limits = {(uint32_t)sizeof limits, BALLS, BALLS, 64, 32, 0};
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_init(other_memory, sizeof other_memory, BALLS, &other), HSP_OK);
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(set_with_room_for(BALLS, BALLS, 0, NULL), HSP_OK);
}

/* ---- everything, against a boundary ---- */

typedef struct everything {
  hsp_totals totals;
  hsp_energy energy;
  double area[BALLS], volume[BALLS], d_centre[3 * BALLS], d_radius[BALLS];
  uint32_t flags[BALLS];
} everything;

static everything read_moving(void) {
  everything all;
  uint32_t needed = 0;
  memset(&all, 0, sizeof all);
  CHECK_EQUAL(hsp_moving_measure(moving, &all.totals, all.area, all.volume, BALLS, &needed), HSP_OK);
  CHECK_EQUAL(needed, BALLS);
  needed = 0;
  CHECK_EQUAL(hsp_moving_gradient(moving, &all.energy, all.d_centre, all.d_radius, all.flags, BALLS, &needed), HSP_OK);
  CHECK_EQUAL(needed, BALLS);
  return all;
}

static everything read_boundary(const hsp_model *of) {
  everything all;
  memset(&all, 0, sizeof all);
  CHECK_EQUAL(hsp_boundary_compute(boundary, of, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, &all.totals, all.area, all.volume, BALLS, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_gradient(boundary,
                                        SIZED(hsp_gradient_request, .sigma = sigma, .tension = 1.5, .pressure = -0.25),
                                        SIZED(hsp_gradient_outputs, .energy = &all.energy, .d_centre = all.d_centre,
                                              .d_radius = all.d_radius, .flags = all.flags, .capacity = BALLS)),
              HSP_OK);
  return all;
}

/* Of the boundary that was read last. */
static void check_counts(void) {
  hsp_boundary_counts counts;
  hsp_moving_info info;
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_info(moving, &info), HSP_OK);
  CHECK_EQUAL(info.balls, counts.balls);
  CHECK_EQUAL(info.exposed_balls, counts.exposed_balls);
  CHECK_EQUAL(info.contained_balls, counts.contained_balls);
  CHECK_EQUAL(info.vertices, counts.vertices);
  CHECK_EQUAL(info.arcs, counts.arcs);
  CHECK_EQUAL(info.circles, counts.circles);
  CHECK_EQUAL(info.faces, counts.faces);
  CHECK_EQUAL(info.loops, counts.loops);
  CHECK_EQUAL(info.components, counts.components);
  CHECK_EQUAL(info.reserved, 0);
}

static void check_balls(const everything *all, double probe) {
  static const uint32_t order[BALLS + 1] = {5, 0, 1, 4, 3, 2, 0};
  hsp_moving_ball ball[BALLS + 1];
  hsp_ball of_boundary[BALLS];
  uint32_t needed = 0, k;
  CHECK_EQUAL(hsp_boundary_get_balls(boundary, of_boundary, BALLS, &needed), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_balls(moving, BALLS + 1, order, ball), HSP_OK);
  for (k = 0; k < BALLS + 1; ++k) {
    const uint32_t i = order[k];
    CHECK_NEAR(ball[k].centre[0], xyz[3 * i], 1e-14);
    CHECK_NEAR(ball[k].centre[1], xyz[3 * i + 1], 1e-14);
    CHECK_NEAR(ball[k].centre[2], xyz[3 * i + 2], 1e-14);
    CHECK_NEAR(ball[k].radius, radius[i] + probe, 1e-14);
    CHECK_BYTES(&ball[k].area, &all->area[i], sizeof(double));
    CHECK_BYTES(&ball[k].volume_term, &all->volume[i], sizeof(double));
    CHECK_BYTES(ball[k].d_centre, &all->d_centre[3 * i], 3 * sizeof(double));
    CHECK_BYTES(&ball[k].d_radius, &all->d_radius[i], sizeof(double));
    CHECK_EQUAL(ball[k].faces, of_boundary[i].faces);
    CHECK_EQUAL(ball[k].flags, of_boundary[i].flags);
    CHECK_EQUAL(ball[k].gradient_flags, all->flags[i]);
    CHECK_EQUAL(ball[k].reserved, 0);
  }
}

/* A new model of the balls, and the one that the handle gives, have the same numbers. */
static void check_fresh(double probe) {
  const hsp_model_options options = options_of_model(probe);
  const everything all = read_moving();
  everything fresh;
  hsp_model_info info;
  hsp_moving_info moving_info;
  uint32_t hits[BALLS], needed = 0;
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, &options, NULL), HSP_OK);
  fresh = read_boundary(model);
  CHECK_BYTES(&all, &fresh, sizeof all);
  check_counts();
  check_balls(&all, probe);
  CHECK_EQUAL(hsp_moving_get_model(moving, other), HSP_OK);
  fresh = read_boundary(other);
  CHECK_BYTES(&all, &fresh, sizeof all);
  CHECK_EQUAL(hsp_model_get_info(other, &info), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_info(moving, &moving_info), HSP_OK);
  CHECK_EQUAL(info.balls, BALLS);
  CHECK_BYTES(&info.step, &moving_info.step, sizeof info.step);
  CHECK_BYTES(&info.probe, &moving_info.probe, sizeof info.probe);
  CHECK_NEAR(moving_info.largest_radius, largest_radius + probe, 1e-14);
  CHECK_EQUAL(hsp_query_point(other, xyz, hits, BALLS, &needed), HSP_OK);
  CHECK(needed > 0);
}

/* ---- moves ---- */

static int32_t move_one(uint32_t ball, double x, double y, double r) {
  const double to[3] = {x, y, 0};
  const int32_t status = hsp_moving_move(moving, 1, &ball, to, &r, NULL, NULL);
  if (status == HSP_OK) {
    memcpy(xyz + 3 * ball, to, sizeof to);
    radius[ball] = r;
  }
  return status;
}

static void check_changed(uint32_t count, const uint32_t *expected) {
  uint32_t list[BALLS] = {0}, needed = 77;
  hsp_moving_info info;
  CHECK_EQUAL(hsp_moving_get_changed(moving, list, BALLS, &needed), HSP_OK);
  CHECK_EQUAL(needed, count);
  CHECK_EQUAL(hsp_moving_get_info(moving, &info), HSP_OK);
  CHECK_EQUAL(info.changed, count);
  if (count == 0) return;
  CHECK_BYTES(list, expected, count * sizeof(uint32_t));
  FILL(list);
  CHECK_EQUAL(hsp_moving_get_changed(moving, list, count - 1, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, count);
  CHECK_UNTOUCHED(list);
}

static void moves(double probe) {
  static const uint32_t all_balls[BALLS] = {4, 0, 1, 5, 3, 2};
  static const uint32_t end_and_neighbour[] = {3, 4};
  everything before, after;
  double others[3 * BALLS];
  uint32_t i;
  check_scene("moves, probe %g", probe);
  CHECK_EQUAL(set_with_room_for(BALLS, BALLS, probe, NULL), HSP_OK);
  check_changed(0, NULL);
  check_fresh(probe);
  if (probe == 0) {
    CHECK_EQUAL(move_one(4, 6.25, 0, 1), HSP_OK);
    check_changed(2, end_and_neighbour);
    check_fresh(probe);
  }
  /* The chain breaks, a ball goes into another one, one grows as far as it may, one loses its radius. */
  CHECK_EQUAL(move_one(2, 30, 0, 1), HSP_OK);
  check_fresh(probe);
  CHECK_EQUAL(move_one(5, 0.25, 0, 0.5), HSP_OK);
  check_fresh(probe);
  CHECK_EQUAL(move_one(1, 1.5, 0, largest_radius), HSP_OK);
  check_fresh(probe);
  CHECK_EQUAL(move_one(3, 4.5, 0, 0), HSP_OK);
  check_fresh(probe);

  /* All at once, and back. */
  before = read_moving();
  for (i = 0; i < BALLS; ++i) memcpy(others + 3 * i, start + 3 * all_balls[i], 3 * sizeof(double));
  CHECK_EQUAL(hsp_moving_move(moving, BALLS, all_balls, others, NULL, NULL, NULL), HSP_OK);
  after = read_moving();
  CHECK(memcmp(&before, &after, sizeof before) != 0);
  CHECK_EQUAL(hsp_moving_undo(moving), HSP_OK);
  after = read_moving();
  CHECK_BYTES(&after, &before, sizeof before);
  check_fresh(probe);
  CHECK_EQUAL(hsp_moving_undo(moving), HSP_E_STATE);
  CHECK_EQUAL(hsp_moving_move(moving, BALLS, all_balls, others, NULL, NULL, NULL), HSP_OK);
  memcpy(xyz, start, sizeof xyz);
  check_fresh(probe);

  /* Radii alone, and nothing at all. */
  CHECK_EQUAL(hsp_moving_move(moving, 1, all_balls, NULL, others, NULL, NULL), HSP_E_RANGE);
  others[0] = 1.25;
  CHECK_EQUAL(hsp_moving_move(moving, 1, all_balls, NULL, others, NULL, NULL), HSP_OK);
  radius[4] = 1.25;
  check_fresh(probe);
  CHECK_EQUAL(hsp_moving_move(moving, 2, all_balls, NULL, NULL, NULL, NULL), HSP_OK);
  check_changed(0, NULL);
  CHECK_EQUAL(hsp_moving_move(moving, 0, NULL, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_undo(moving), HSP_OK);
  check_fresh(probe);
}

/* ---- refusals ---- */

static void refused_moves(void) {
  static const struct refusal {
    uint32_t ball[2];
    double x, r;
    int32_t status;
    uint32_t first_bad;
  } refusals[] = {{{0, BALLS}, 1, 1, HSP_E_ID, 1},
                  {{HSP_NONE, 1}, 1, 1, HSP_E_ID, 0},
                  {{3, 3}, 1, 1, HSP_E_ID, 1},
                  {{2, 3}, (double)NAN, 1, HSP_E_NOT_FINITE, 1},
                  {{2, 3}, (double)INFINITY, 1, HSP_E_NOT_FINITE, 1},
                  {{2, 3}, 1, (double)NAN, HSP_E_NOT_FINITE, 1},
                  {{2, 3}, 1, -1, HSP_E_NEGATIVE, 1},
                  {{2, 3}, 1.13e9, 1, HSP_E_RANGE, 1}, /* 2^50 steps are 1.126e9 */
                  {{2, 3}, 1, 1.5000006, HSP_E_RANGE, 1},
                  {{2, 3}, 1, 1e300, HSP_E_RANGE, 1}};
  hsp_moving_limits limits;
  size_t k;
  uint32_t first_bad = 77;
  everything before, after;
  CHECK_EQUAL(set_with_room_for(BALLS, BALLS, 0, NULL), HSP_OK);
  CHECK_EQUAL(move_one(0, 0.25, 0, 1), HSP_OK);
  before = read_moving();
  for (k = 0; k < sizeof refusals / sizeof refusals[0]; ++k) {
    const struct refusal *r = &refusals[k];
    const double to[6] = {2, 0, 0, r->x, 0, 0}, radii[2] = {1, r->r};
    check_scene("refusal %u", (unsigned)k);
    FILL(limits);
    limits.struct_size = (uint32_t)sizeof limits;
    CHECK_EQUAL(hsp_moving_move(moving, 2, r->ball, to, radii, &limits, &first_bad), r->status);
    CHECK_EQUAL(first_bad, r->first_bad);
    CHECK_EQUAL(limits.balls, 0xA5A5A5A5);
    CHECK_EQUAL(limits.neighbours, 0xA5A5A5A5);
    CHECK_EQUAL(hsp_moving_move(moving, 2, r->ball, to, radii, NULL, NULL), r->status);
    after = read_moving();
    CHECK_BYTES(&after, &before, sizeof before);
    check_fresh(0);
  }
  /* A call that was refused before anything was computed leaves the move before it to be taken back. */
  CHECK_EQUAL(hsp_moving_undo(moving), HSP_OK);
  xyz[0] = 0;
  check_fresh(0);
}

/* A ball with more neighbours than there is room for: nothing changes, and a larger handle takes the balls over. */
static void too_many_neighbours(void) {
  static unsigned char larger_memory[HSP_MOVING_BYTES(BALLS, BALLS)];
  hsp_moving_limits limits = {(uint32_t)sizeof limits, 0, 0};
  hsp_moving *smaller = NULL;
  everything before, after;
  const uint32_t ball = 4;
  const double to[3] = {3.25, 0, 0};
  uint32_t first_bad = 77;
  check_scene("too many neighbours");
  CHECK_EQUAL(set_with_room_for(BALLS, 1, 0, &limits), HSP_E_CAPACITY);
  CHECK_EQUAL(limits.balls, BALLS);
  CHECK_EQUAL(limits.neighbours, 3);
  CHECK_EQUAL(hsp_moving_undo(moving), HSP_E_STATE);
  CHECK_EQUAL(set_with_room_for(BALLS, 3, 0, &limits), HSP_OK);
  CHECK_EQUAL(limits.neighbours, 3);
  CHECK_EQUAL(move_one(0, 0.25, 0, 1), HSP_OK);
  before = read_moving();
  CHECK_EQUAL(hsp_moving_move(moving, 1, &ball, to, NULL, &limits, &first_bad), HSP_E_CAPACITY);
  CHECK_EQUAL(limits.balls, BALLS);
  CHECK_EQUAL(limits.neighbours, 4);
  CHECK_EQUAL(first_bad, HSP_NONE);
  after = read_moving();
  CHECK_BYTES(&after, &before, sizeof before);
  check_changed(0, NULL);
  check_fresh(0);
  CHECK_EQUAL(hsp_moving_undo(moving), HSP_E_STATE);
  /* As the header says. */
  smaller = moving;
  CHECK_EQUAL(hsp_moving_get_model(smaller, other), HSP_OK);
  CHECK_EQUAL(hsp_moving_init(larger_memory, sizeof larger_memory, &limits, &moving), HSP_OK);
  CHECK_EQUAL(hsp_moving_set(moving, other, sigma, 1.5, -0.25, HSP_TANGENT_OVERLAP, &limits, NULL), HSP_OK);
  CHECK_EQUAL(limits.neighbours, 3);
  after = read_moving();
  CHECK_BYTES(&after, &before, sizeof before);
  CHECK_EQUAL(hsp_moving_move(moving, 1, &ball, to, NULL, &limits, NULL), HSP_OK);
  CHECK_EQUAL(limits.neighbours, 4);
  memcpy(xyz + 12, to, sizeof to);
  check_fresh(0);
}

/* Calls that hsp_moving_set refuses; afterwards nothing can be read. */
static void refused_sets(void) {
  double weights[BALLS];
  hsp_moving_limits limits = {8, 9, 9};
  hsp_moving_info info;
  uint32_t k, first_bad;
  const uint32_t id = 0;
  for (k = 0; k < 7; ++k) {
    const hsp_model *from = k == 0 ? NULL : k == 6 ? (const hsp_model *)(const void *)moving : model;
    check_scene("set, refusal %u", (unsigned)k);
    CHECK_EQUAL(set_with_room_for(BALLS, BALLS, 0, NULL), HSP_OK);
    memcpy(weights, sigma, sizeof weights);
    if (k == 3) weights[2] = (double)NAN;
    first_bad = 77;
    CHECK_EQUAL(hsp_moving_set(moving, from, weights, k == 4 ? (double)NAN : 1, k == 5 ? (double)INFINITY : 0,
                               k == 1 ? 2 : HSP_TANGENT_DISJOINT, k == 2 ? &limits : NULL, &first_bad),
                k < 2    ? HSP_E_ARGUMENT
                : k == 2 ? HSP_E_VERSION
                : k == 6 ? HSP_E_HANDLE
                         : HSP_E_NOT_FINITE);
    CHECK_EQUAL(first_bad, k == 3 ? 2 : k == 6 ? 77 : HSP_NONE);
    CHECK_EQUAL(hsp_moving_get_info(moving, &info), HSP_E_STATE);
    CHECK_EQUAL(hsp_moving_move(moving, 1, &id, xyz, NULL, NULL, NULL), HSP_E_STATE);
    CHECK_EQUAL(hsp_moving_undo(moving), HSP_E_STATE);
  }
}

static void refused_reading(void) {
  hsp_moving_ball ball[2];
  const uint32_t list[2] = {0, BALLS};
  hsp_model *small_model = NULL;
  hsp_model_info of_model;
  unsigned char small_memory[HSP_MODEL_BYTES(SMALL)];
  check_scene("refused reading");
  CHECK_EQUAL(set_with_room_for(BALLS, BALLS, 0, NULL), HSP_OK);
  FILL(ball);
  CHECK_EQUAL(hsp_moving_measure(moving, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_gradient(moving, NULL, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_balls(moving, 2, list, ball), HSP_E_ID);
  CHECK_EQUAL(hsp_moving_get_balls(moving, 0, NULL, NULL), HSP_OK);
  CHECK_UNTOUCHED(ball);
  /* A model without room stays as it is. */
  CHECK_EQUAL(hsp_model_init(small_memory, sizeof small_memory, SMALL, &small_model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(small_model, SMALL, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, small_model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_model(moving, small_model), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_model_get_info(small_model, &of_model), HSP_OK);
  CHECK_EQUAL(of_model.balls, SMALL);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, NULL, 0, NULL), HSP_OK);
  /* One that gets the same balls is the same, one that gets others is not. */
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_model(moving, model), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_move(moving, 1, list, xyz + 3, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_model(moving, model), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, NULL, 0, NULL), HSP_E_STATE);
}

/* ---- few balls, limits, memory ---- */

static void no_balls(void) {
  const hsp_moving_limits limits = {(uint32_t)sizeof limits, 0, 0};
  hsp_moving_info info;
  hsp_energy energy;
  everything all;
  uint32_t needed = 77;
  check_scene("no balls");
  memset(&all, 0, sizeof all);
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_init(moving_memory, sizeof moving_memory, &limits, &moving), HSP_OK);
  CHECK_EQUAL(hsp_moving_set(moving, model, NULL, 1, 1, HSP_TANGENT_OVERLAP, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_gradient(moving, &energy, all.d_centre, all.d_radius, all.flags, 0, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0);
  CHECK(energy.value == 0 && energy.area == 0 && energy.volume == 0 && energy.d_probe == 0);
  CHECK_EQUAL(hsp_moving_move(moving, 0, NULL, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_moving_get_info(moving, &info), HSP_OK);
  CHECK_EQUAL(info.balls, 0);
  CHECK_EQUAL(info.components, 0);
  CHECK_EQUAL(hsp_moving_get_model(moving, model), HSP_OK);
}

static void limits_init(void) {
  hsp_moving_limits limits;
  const uint32_t size = (uint32_t)sizeof limits;
  check_scene("limits");
  CHECK_EQUAL(hsp_moving_limits_init(&limits, size, HSP_MAX_BALLS + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_moving_limits_init(&limits, size, 255), HSP_OK);
  CHECK(limits.balls == 255 && limits.neighbours == 255 && limits.struct_size == size);
  CHECK_EQUAL(hsp_moving_limits_init(&limits, size, HSP_MAX_BALLS), HSP_OK);
  CHECK(limits.balls == HSP_MAX_BALLS && limits.neighbours == 256);
}

static size_t moving_macro(const limit_numbers *limits) {
  return HSP_MOVING_BYTES(limits->number[1], limits->number[2]);
}

static void sizes(void) {
  static const uint32_t box[] = {0, 1, 2, 3, 7, 8, 9, 64, 65, 1000, 4097, 65535, 1000000, 0x0FFFFFFE, 0x0FFFFFFF};
  static const size_bound bound = {moving_macro, {196608, 640, 1280}, 3e11};
  check_scene("sizes");
  sweep_sizes(&moving_handle, &bound, box, sizeof box / sizeof box[0]);
}

static void same_results(const void *handle, const void *source) {
  const moving_result *all = source;
  hsp_energy energy;
  CHECK_EQUAL(hsp_moving_gradient(handle, &energy, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&energy, &all->energy, sizeof energy);
}
static void no_results(const void *handle) {
  hsp_moving_info info;
  CHECK_EQUAL(hsp_moving_get_info(handle, &info), HSP_E_STATE);
}

static void alignments(void) {
  computed base;
  moving_result all;
  check_scene("alignments");
  CHECK_EQUAL(set_with_room_for(BALLS, BALLS, 0, NULL), HSP_OK);
  if (CHECK_EQUAL(computed_make(BALLS, xyz, radius, NULL, &base), HSP_OK) &&
      CHECK_EQUAL(moving_result_make(&base, &all), HSP_OK)) {
    const known_handle known = {&moving_handle, &all, &all.needed, same_results, no_results, NULL};
    sweep_alignments(&known, NULL);
    moving_result_release(&all);
  }
  computed_release(&base);
}

int main(void) {
  make();
  moves(0);
  moves(1.25);
  refused_moves();
  too_many_neighbours();
  refused_sets();
  refused_reading();
  no_balls();
  limits_init();
  sizes();
  alignments();
  return check_report();
}
