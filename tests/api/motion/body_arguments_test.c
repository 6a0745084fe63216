/* Bodies and poses: arguments that tests/laws says nothing about, sizes, what they say of few balls, and answers one by
 * one and in lists. Many sets stand against brute force in unit_poses_pose_queries. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { BALLS = 6, POSES = 4 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char fixed_memory[HSP_BODY_BYTES(BALLS)], moving_memory[HSP_BODY_BYTES(BALLS)];
static hsp_model *model;
static hsp_body *fixed, *moving;

/* A row along x, and one ball beside it. */
static const double xyz[3 * BALLS] = {0, 0, 0, 2, 0, 0, 4, 0, 0, 6, 0, 0, 8, 0, 0, 4, 3, 0};
static const double radius[BALLS] = {1, 1, 1, 1, 1, 0.5};

/* Far; a gap of 1; touching; the row across the other one, by a quarter turn about z. */
static const hsp_pose pose[POSES] = {
    {{1, 0, 0, 0}, {0, 0, 100}}, {{2, 0, 0, 0}, {0, 0, 3}}, {{-1, 0, 0, 0}, {0, 0, 2}}, {{0.5, 0, 0, 0.5}, {4, -1, 0}}};

static void set_body(void *memory, size_t bytes, uint32_t n, hsp_body **body) {
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_init(memory, bytes, BALLS, body), HSP_OK);
  CHECK_EQUAL(hsp_body_set(*body, model), HSP_OK);
}

static void make(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  set_body(fixed_memory, sizeof fixed_memory, BALLS, &fixed);
  set_body(moving_memory, sizeof moving_memory, 5, &moving);
}

static void sizes(void) {
  static const uint32_t numbers[] = {0, 1, 2, 4, 5, 100, 4097, 1000000, HSP_MAX_BALLS};
  size_t bytes = 0, before = 0, i;
  hsp_body *body = NULL;
  CHECK_EQUAL(hsp_body_bytes(HSP_MAX_BALLS + 1, &bytes), HSP_E_RANGE);
  CHECK_EQUAL(bytes, 0);
  for (i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
    if (hsp_body_bytes(numbers[i], &bytes) != HSP_OK) {
      CHECK_EQUAL(hsp_body_bytes(numbers[i], &bytes), HSP_E_RANGE);
      continue;
    }
    CHECK(bytes <= HSP_BODY_BYTES(numbers[i]));
    CHECK(bytes > 0 && bytes >= before);
    before = bytes;
  }
  CHECK_EQUAL(hsp_body_bytes(BALLS, &bytes), HSP_OK);
  CHECK_EQUAL(hsp_body_init(moving_memory, bytes, HSP_MAX_BALLS + 1, &body), HSP_E_RANGE);
  CHECK(body == NULL);
  for (i = 0; i < 8; ++i) CHECK_EQUAL(hsp_body_init(moving_memory + i, sizeof moving_memory - i, BALLS, &body), HSP_OK);
}

/* Every function that asks; all report the same status and write nothing but what is refused. */
static void check_refused(const hsp_body *a, const hsp_body *b, uint32_t poses, const hsp_pose *at, int32_t status,
                          uint32_t bad) {
  uint32_t hit[POSES], pair[2], needed, first_bad = 77;
  hsp_body_gap gap[POSES];
  hsp_body_overlap overlap[POSES];
  FILL(hit);
  FILL(pair);
  FILL(needed);
  FILL(gap);
  FILL(overlap);
  CHECK_EQUAL(hsp_body_hits(a, b, poses, at, hit, &first_bad), status);
  CHECK_EQUAL(first_bad, bad);
  first_bad = 77;
  CHECK_EQUAL(hsp_body_hits_along(a, b, poses, at, 1, hit, &first_bad), status);
  CHECK_EQUAL(first_bad, bad);
  first_bad = 77;
  CHECK_EQUAL(hsp_body_gaps(a, b, poses, at, gap, &first_bad), status);
  CHECK_EQUAL(first_bad, bad);
  first_bad = 77;
  CHECK_EQUAL(hsp_body_overlaps(a, b, poses, at, overlap, &first_bad), status);
  CHECK_EQUAL(first_bad, bad);
  CHECK_EQUAL(hsp_body_overlaps(a, b, poses, at, overlap, NULL), status);
  CHECK_EQUAL(hsp_body_pairs(a, b, bad < POSES ? at + bad : at, pair, 1, &needed), status);
  CHECK_UNTOUCHED(hit);
  CHECK_UNTOUCHED(pair);
  CHECK_UNTOUCHED(needed);
  CHECK_UNTOUCHED(gap);
  CHECK_UNTOUCHED(overlap);
}

static void refusals(void) {
  hsp_pose bad[POSES];
  uint32_t hit[POSES], k;
  hsp_body_gap gap;
  hsp_body_overlap overlap;
  hsp_model_options options;
  check_refused(NULL, moving, POSES, pose, HSP_E_ARGUMENT, HSP_NONE);
  check_refused(fixed, NULL, POSES, pose, HSP_E_ARGUMENT, HSP_NONE);
  check_refused(fixed, moving, POSES, NULL, HSP_E_ARGUMENT, HSP_NONE);
  CHECK_EQUAL(hsp_body_hits(fixed, moving, 0, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_gaps(fixed, moving, 0, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_overlaps(fixed, moving, 0, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_set(NULL, model), HSP_E_ARGUMENT);
  for (k = 0; k < 7; ++k) {
    double *const number = k < 4 ? &bad[2].quaternion[k] : &bad[2].translation[k - 4];
    memcpy(bad, pose, sizeof bad);
    *number = (double)NAN;
    check_refused(fixed, moving, POSES, bad, HSP_E_NOT_FINITE, 2);
    *number = (double)-INFINITY;
    check_refused(fixed, moving, POSES, bad, HSP_E_NOT_FINITE, 2);
    *number = 1e200;
    check_refused(fixed, moving, POSES, bad, HSP_E_RANGE, 2);
  }
  memcpy(bad, pose, sizeof bad);
  memset(bad[3].quaternion, 0, sizeof bad[3].quaternion);
  check_refused(fixed, moving, POSES, bad, HSP_E_RANGE, 3);
  /* The step is 1e-9: 2^50 steps are 1.126e6. */
  memcpy(bad, pose, sizeof bad);
  bad[0].translation[1] = 1.12e6;
  CHECK_EQUAL(hsp_body_hits(fixed, moving, POSES, bad, hit, NULL), HSP_OK);
  bad[0].translation[1] = -1.13e6;
  check_refused(fixed, moving, POSES, bad, HSP_E_RANGE, 0);

  /* Another lattice. */
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 1e-6;
  CHECK_EQUAL(hsp_model_set(model, 5, xyz, radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_set(moving, model), HSP_OK);
  check_refused(fixed, moving, POSES, pose, HSP_E_ARGUMENT, HSP_NONE);
  check_refused(fixed, moving, 0, NULL, HSP_E_ARGUMENT, HSP_NONE);
  CHECK_EQUAL(hsp_body_hits_along(fixed, moving, 0, NULL, -1, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_model_set(model, 5, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_set(moving, model), HSP_OK);

  /* A failed call leaves nothing to ask for. */
  CHECK_EQUAL(hsp_body_set(moving, NULL), HSP_E_ARGUMENT);
  check_refused(fixed, moving, POSES, pose, HSP_E_STATE, HSP_NONE);
  check_refused(moving, fixed, POSES, pose, HSP_E_STATE, HSP_NONE);
  /* A body without balls has gaps that are infinite. */
  options.step = 1e-9;
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_set(moving, model), HSP_OK);
  CHECK_EQUAL(hsp_body_gaps(fixed, moving, 1, pose + 3, &gap, NULL), HSP_OK);
  CHECK(isinf(gap.gap) && gap.gap > 0 && gap.fixed == HSP_NONE && gap.posed == HSP_NONE);
  CHECK_EQUAL(hsp_body_overlaps(fixed, moving, 1, pose + 3, &overlap, NULL), HSP_OK);
  CHECK(overlap.pairs == 0 && overlap.volume == 0 && overlap.reserved == 0);
  CHECK_EQUAL(hsp_body_hits(moving, fixed, 1, pose + 3, hit, NULL), HSP_OK);
  CHECK_EQUAL(hit[0], 0);
  CHECK_EQUAL(hsp_model_set(model, 5, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_init(moving_memory, sizeof moving_memory, 4, &moving), HSP_OK);
  CHECK_EQUAL(hsp_body_set(moving, model), HSP_E_CAPACITY);
  check_refused(fixed, moving, POSES, pose, HSP_E_STATE, HSP_NONE);
  /* A handle of another kind: not even first_bad is written. */
  CHECK_EQUAL(hsp_body_set((hsp_body *)(void *)model, model), HSP_E_HANDLE);
  check_refused((const hsp_body *)(const void *)model, fixed, POSES, pose, HSP_E_HANDLE, 77);
  check_refused(fixed, (const hsp_body *)(const void *)model, POSES, pose, HSP_E_HANDLE, 77);
}

static void answers(void) {
  static const uint32_t hits[POSES] = {0, 0, 1, 1};
  static const double gaps[POSES] = {98, 1, 0, -1.5};
  static const uint32_t nearest[POSES][2] = {{0, 0}, {0, 0}, {0, 0}, {5, 2}};
  uint32_t hit[POSES], pair[64], needed = 0, k, one;
  hsp_body_gap gap[POSES], alone;
  hsp_body_overlap overlap[POSES];
  make();
  CHECK_EQUAL(hsp_body_hits(fixed, moving, POSES, pose, hit, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_gaps(fixed, moving, POSES, pose, gap, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_overlaps(fixed, moving, POSES, pose, overlap, NULL), HSP_OK);
  for (k = 0; k < POSES; ++k) {
    CHECK_EQUAL(hit[k], hits[k]);
    CHECK_NEAR(gap[k].gap, gaps[k], 1e-12);
    CHECK(gap[k].fixed == nearest[k][0] && gap[k].posed == nearest[k][1]);
    CHECK_EQUAL(hsp_body_pairs(fixed, moving, pose + k, pair, 64, &needed), HSP_OK);
    CHECK_EQUAL(overlap[k].pairs, needed);
    CHECK_EQUAL(needed > 0, hit[k]);
    CHECK_EQUAL(hsp_body_hits(fixed, moving, 1, pose + k, &one, NULL), HSP_OK);
    CHECK_EQUAL(one, hit[k]);
    CHECK_EQUAL(hsp_body_gaps(fixed, moving, 1, pose + k, &alone, NULL), HSP_OK);
    CHECK_BYTES(&alone, &gap[k], sizeof alone);
  }
  /* Touching: each ball of the row the one below it. */
  CHECK_EQUAL(hsp_body_pairs(fixed, moving, pose + 2, pair, 64, &needed), HSP_OK);
  CHECK_EQUAL(needed, 5);
  for (k = 0; k < 5; ++k) CHECK(pair[2 * k] == k && pair[2 * k + 1] == k);
  CHECK(overlap[2].volume == 0);
  CHECK_EQUAL(hsp_body_pairs(fixed, moving, pose + 2, pair, 4, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_body_pairs(fixed, moving, pose + 2, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 5);
  /* Across: the row goes up from (4, -1) to (4, 7). Its first two balls meet ball 2 by lenses of height 1, and ball 5
   * lies within the third. */
  CHECK_EQUAL(overlap[3].pairs, 3);
  CHECK_NEAR(overlap[3].volume, 2 * (5 * 3.14159265358979324 / 12) + 3.14159265358979324 / 6, 1e-14);
  /* The moving body does not need its model. */
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_gaps(fixed, moving, 1, pose + 1, &alone, NULL), HSP_OK);
  CHECK_BYTES(&alone, &gap[1], sizeof alone);
}

static void matrices(void) {
  static const double turn[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1}, mirror[9] = {1, 0, 0, 0, 1, 0, 0, 0, -1};
  static const double shift[3] = {4, -1, 0};
  double bad_shift[3] = {0, 0, 0}, bad_turn[9];
  hsp_pose made;
  hsp_body_gap one, other;
  FILL(made);
  CHECK_EQUAL(hsp_pose_from_matrix(mirror, shift, &made), HSP_E_RANGE);
  bad_shift[1] = (double)INFINITY;
  CHECK_EQUAL(hsp_pose_from_matrix(turn, bad_shift, &made), HSP_E_NOT_FINITE);
  memcpy(bad_turn, turn, sizeof turn);
  bad_turn[8] = (double)NAN;
  CHECK_EQUAL(hsp_pose_from_matrix(bad_turn, shift, &made), HSP_E_NOT_FINITE);
  CHECK_UNTOUCHED(made);
  make();
  CHECK_EQUAL(hsp_pose_from_matrix(turn, shift, &made), HSP_OK);
  CHECK_EQUAL(hsp_body_gaps(fixed, moving, 1, &made, &one, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_gaps(fixed, moving, 1, pose + 3, &other, NULL), HSP_OK);
  CHECK_BYTES(&one, &other, sizeof one);
}

/* The poses of above by integers; touching is touching, whatever the angle. */
static const hsp_rational_pose rational[POSES] = {
    {{1, 0, 0, 0}, {0, 0, 100}}, {{2, 0, 0, 0}, {0, 0, 3}}, {{-1, 0, 0, 0}, {0, 0, 2}}, {{1, 0, 0, 1}, {4, -1, 0}}};

static void check_rational_refused(const hsp_body *a, const hsp_body *b, uint32_t poses, const hsp_rational_pose *at,
                                   int32_t status, uint32_t bad) {
  uint32_t hit[POSES], pair[2], needed, first_bad = 77;
  hsp_body_gap gap[POSES];
  FILL(hit);
  FILL(pair);
  FILL(needed);
  FILL(gap);
  CHECK_EQUAL(hsp_body_rational_hits(a, b, poses, at, hit, &first_bad), status);
  CHECK_EQUAL(first_bad, bad);
  first_bad = 77;
  CHECK_EQUAL(hsp_body_rational_hits_along(a, b, poses, at, 1, hit, &first_bad), status);
  CHECK_EQUAL(first_bad, bad);
  first_bad = 77;
  CHECK_EQUAL(hsp_body_rational_gaps(a, b, poses, at, gap, &first_bad), status);
  CHECK_EQUAL(first_bad, bad);
  CHECK_EQUAL(hsp_body_rational_pairs(a, b, bad < POSES ? at + bad : at, pair, 1, &needed), status);
  CHECK_UNTOUCHED(hit);
  CHECK_UNTOUCHED(pair);
  CHECK_UNTOUCHED(needed);
  CHECK_UNTOUCHED(gap);
}

static void rational_poses(void) {
  hsp_rational_pose bad[POSES];
  uint32_t hit[POSES], other_hit[POSES], pair[2 * 5], needed = 0, k;
  hsp_body_gap gap[POSES], other_gap[POSES];
  make();
  check_rational_refused(NULL, moving, POSES, rational, HSP_E_ARGUMENT, HSP_NONE);
  check_rational_refused(fixed, NULL, POSES, rational, HSP_E_ARGUMENT, HSP_NONE);
  check_rational_refused(fixed, moving, POSES, NULL, HSP_E_ARGUMENT, HSP_NONE);
  check_rational_refused((const hsp_body *)(const void *)model, moving, POSES, rational, HSP_E_HANDLE, 77);
  CHECK_EQUAL(hsp_body_rational_hits(fixed, moving, 0, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_rational_gaps(fixed, moving, 0, NULL, NULL, NULL), HSP_OK);
  memcpy(bad, rational, sizeof bad);
  bad[2].translation[1] = (double)NAN;
  check_rational_refused(fixed, moving, POSES, bad, HSP_E_NOT_FINITE, 2);
  bad[2].translation[1] = 1e300;
  check_rational_refused(fixed, moving, POSES, bad, HSP_E_RANGE, 2);
  memcpy(bad, rational, sizeof bad);
  bad[3].quaternion[0] = bad[3].quaternion[3] = 0;
  check_rational_refused(fixed, moving, POSES, bad, HSP_E_RANGE, 3);
  CHECK_EQUAL(hsp_body_rational_hits(fixed, moving, POSES, rational, hit, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_hits(fixed, moving, POSES, pose, other_hit, NULL), HSP_OK);
  CHECK_BYTES(hit, other_hit, sizeof hit);
  CHECK_EQUAL(hsp_body_rational_gaps(fixed, moving, POSES, rational, gap, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_gaps(fixed, moving, POSES, pose, other_gap, NULL), HSP_OK);
  for (k = 0; k < POSES; ++k) {
    CHECK_NEAR(gap[k].gap, other_gap[k].gap, 1e-12);
    CHECK(gap[k].fixed == other_gap[k].fixed && gap[k].posed == other_gap[k].posed);
  }
  CHECK_EQUAL(hsp_body_rational_pairs(fixed, moving, rational + 2, pair, 4, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 5);
  CHECK_EQUAL(hsp_body_rational_pairs(fixed, moving, rational + 2, pair, 5, &needed), HSP_OK);
  for (k = 0; k < 5; ++k) CHECK(pair[2 * k] == k && pair[2 * k + 1] == k);
}

/* The answers of hsp_body_hits, whatever the margin. */
static void motions(void) {
  static const double margins[5] = {0, 1e-12, 0.5, 20, 1e300};
  static const double bad_margins[4] = {-1, -1e-300, (double)INFINITY, (double)NAN};
  hsp_pose way[200];
  hsp_rational_pose ideal_way[200];
  uint32_t hit[200], ideal_hit[200], found[200], first_bad, k, m, hits = 0;
  make();
  for (k = 0; k < 200; ++k) {
    way[k] = pose[2];
    way[k].translation[0] = 0.05 * (k % 100);
    way[k].translation[2] = 2.5 - 0.01 * k;
    memset(&ideal_way[k], 0, sizeof ideal_way[k]);
    ideal_way[k].quaternion[0] = 3;
    memcpy(ideal_way[k].translation, way[k].translation, sizeof way[k].translation);
  }
  CHECK_EQUAL(hsp_body_hits(fixed, moving, 200, way, hit, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_rational_hits(fixed, moving, 200, ideal_way, ideal_hit, NULL), HSP_OK);
  for (k = 0; k < 200; ++k) hits += hit[k];
  CHECK(hits > 50 && hits < 150);
  for (m = 0; m < 5; ++m) {
    first_bad = 77;
    CHECK_EQUAL(hsp_body_hits_along(fixed, moving, 200, way, margins[m], found, &first_bad), HSP_OK);
    CHECK_EQUAL(first_bad, HSP_NONE);
    CHECK_BYTES(found, hit, sizeof hit);
    CHECK_EQUAL(hsp_body_rational_hits_along(fixed, moving, 200, ideal_way, margins[m], found, NULL), HSP_OK);
    CHECK_BYTES(found, ideal_hit, sizeof ideal_hit);
  }
  FILL(found);
  for (m = 0; m < 4; ++m) {
    const int32_t status = m < 2 ? HSP_E_RANGE : HSP_E_NOT_FINITE;
    first_bad = 77;
    CHECK_EQUAL(hsp_body_hits_along(fixed, moving, 200, way, bad_margins[m], found, &first_bad), status);
    CHECK_EQUAL(first_bad, HSP_NONE);
    CHECK_EQUAL(hsp_body_hits_along(fixed, moving, 0, NULL, bad_margins[m], NULL, NULL), status);
    CHECK_EQUAL(hsp_body_rational_hits_along(fixed, moving, 200, ideal_way, bad_margins[m], found, NULL), status);
  }
  CHECK_UNTOUCHED(found);
  CHECK_EQUAL(hsp_body_hits_along(fixed, moving, 0, NULL, 1, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_rational_hits_along(fixed, moving, 0, NULL, 1, NULL, NULL), HSP_OK);
}

/* A ball turned about the one that it touches goes on to touch it, and one that is a step farther never does. Snapped
 * poses cannot know. */
static void rigid(void) {
  hsp_rational_pose turn = {{0, 1, -2, 3}, {0, 0, 0}};
  hsp_pose snapped = {{0, 1, -2, 3}, {0, 0, 0}};
  double at[3] = {2, 0, 0};
  uint32_t hit = 0, wrong = 0;
  int farther, w;
  for (farther = 0; farther < 2; ++farther) {
    at[0] = farther ? 2.000000001 : 2;
    CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
    set_body(fixed_memory, sizeof fixed_memory, 1, &fixed);
    CHECK_EQUAL(hsp_model_set(model, 1, at, radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_body_init(moving_memory, sizeof moving_memory, 1, &moving), HSP_OK);
    CHECK_EQUAL(hsp_body_set(moving, model), HSP_OK);
    for (w = 1; w <= 100; ++w) {
      turn.quaternion[0] = w;
      snapped.quaternion[0] = w;
      CHECK_EQUAL(hsp_body_rational_hits(fixed, moving, 1, &turn, &hit, NULL), HSP_OK);
      CHECK_EQUAL(hit, farther ? 0 : 1);
      CHECK_EQUAL(hsp_body_hits(fixed, moving, 1, &snapped, &hit, NULL), HSP_OK);
      if (hit != (farther ? 0U : 1U)) ++wrong;
    }
  }
  CHECK(wrong > 20);
}

int main(void) {
  sizes();
  make();
  refusals();
  answers();
  matrices();
  rational_poses();
  motions();
  rigid();
  return check_report();
}
