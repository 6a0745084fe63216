/* Pores between balls that are far apart for the lattice: the same sets on lattices with steps of other sizes, on which
 * all of their numbers are exact, have the same maxima and gates; and which way the axes lie makes no difference. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "random_numbers.h"

enum { MOST = 400, RECORDS = 2000 };
static unsigned char model_memory[HSP_MODEL_BYTES(MOST)];
static hsp_model *model;
static hsp_pores *pores;
static void *pores_memory;

typedef struct found {
  hsp_pores_counts counts;
  hsp_pore_maximum maxima[RECORDS];
  hsp_pore_gate gates[RECORDS];
} found;

static int32_t find(uint32_t n, const double *xyz, const double *radius, double step, found *all) {
  const hsp_model_options options = {(uint32_t)sizeof options, 0, 0, step, 0};
  hsp_pores_limits limits = {(uint32_t)sizeof limits, 0, 0, 0, 0, 0, 0, 0};
  int32_t status;
  size_t bytes;
  memset(all, 0, sizeof *all);
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_limits_init(&limits, (uint32_t)sizeof limits, n), HSP_OK);
  do {
    CHECK_EQUAL(hsp_pores_bytes(&limits, &bytes), HSP_OK);
    free(pores_memory);
    pores_memory = malloc(bytes);
    CHECK_EQUAL(hsp_pores_init(pores_memory, bytes, &limits, &pores), HSP_OK);
    status = hsp_pores_compute(pores, model, NULL, &limits);
  } while (status == HSP_E_CAPACITY);
  if (status != HSP_OK) return status;
  CHECK_EQUAL(hsp_pores_get_counts(pores, &all->counts), HSP_OK);
  if (!CHECK(all->counts.maxima <= RECORDS && all->counts.gates <= RECORDS)) return HSP_E_CAPACITY;
  CHECK_EQUAL(hsp_pores_get_maxima(pores, 0, all->counts.maxima, all->maxima), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_gates(pores, 0, all->counts.gates, all->gates), HSP_OK);
  return HSP_OK;
}

/* Equal radii are in any order. */
static void check_same(const found *a, const found *b, double size) {
  uint32_t k;
  CHECK_BYTES(&a->counts, &b->counts, sizeof a->counts);
  for (k = 0; k < a->counts.maxima && k < b->counts.maxima; ++k) {
    CHECK_NEAR(a->maxima[k].radius, b->maxima[k].radius, 1e-10 * size);
    CHECK(a->maxima[k].radius >= a->maxima[k].death);
    CHECK_NEAR(a->maxima[k].death, b->maxima[k].death, 1e-10 * size);
    if (k > 0 && a->maxima[k - 1].radius - a->maxima[k].radius < 1e-9 * size) continue;
    if (k + 1 < a->counts.maxima && a->maxima[k].radius - a->maxima[k + 1].radius < 1e-9 * size) continue;
    CHECK_BYTES(a->maxima[k].ball, b->maxima[k].ball, sizeof a->maxima[k].ball);
    CHECK_NEAR(a->maxima[k].xyz[0], b->maxima[k].xyz[0], 1e-8 * size);
  }
  for (k = 0; k < a->counts.gates && k < b->counts.gates; ++k) {
    CHECK_NEAR(a->gates[k].radius, b->gates[k].radius, 1e-10 * size);
    if (k > 0 && a->gates[k - 1].radius - a->gates[k].radius < 1e-9 * size) continue;
    if (k + 1 < a->counts.gates && a->gates[k].radius - a->gates[k + 1].radius < 1e-9 * size) continue;
    CHECK_BYTES(a->gates[k].ball, b->gates[k].ball, sizeof a->gates[k].ball);
    CHECK_EQUAL(a->gates[k].merges, b->gates[k].merges);
  }
}

/* Points of small lattices, stretched, which tie often, and points anywhere. */
static void other_steps(void) {
  static found coarse, fine;
  uint64_t seed = 5;
  int turn;
  for (turn = 0; turn < 150; ++turn) {
    const uint32_t n = 3 + (uint32_t)random_below(&seed, turn % 10 == 0 ? 40 : 9);
    const int grid = turn % 3 == 0 ? 1 << 20 : 2 + turn % 5;
    const double stretch = turn % 3 == 0 ? 1 : (double)((1 << 20) / grid);
    double xyz[3 * 64], radius[64], size = 0;
    int power;
    uint32_t i;
    for (i = 0; i < 3 * n; ++i) xyz[i] = (random_below(&seed, 2 * grid + 1) - grid) * stretch;
    for (i = 0; i < n; ++i) radius[i] = 1 + random_below(&seed, turn % 2 == 0 ? 1 : 500);
    for (i = 0; i < 3 * n; ++i) size = fmax(size, fabs(xyz[i]));
    check_scene("turn %d, step 1", turn);
    if (!CHECK_EQUAL(find(n, xyz, radius, 1, &coarse), HSP_OK)) continue;
    for (power = 13; power <= 20; power += 7) {
      check_scene("turn %d, step 2^-%d", turn, power);
      if (CHECK_EQUAL(find(n, xyz, radius, ldexp(1, -power), &fine), HSP_OK)) check_same(&coarse, &fine, size);
    }
  }
}

/* One triangle, wider than 2^36 steps of 1e-5, in all 48 directions. */
static void axes(void) {
  static const double at[9] = {1047974, 730540, 736254, -1219408, 1419365, 98643, 275145, -148042, 348274};
  static const double radius[3] = {1e4, 1e-4, 1e-4};
  static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  static found first, other;
  int way;
  for (way = 0; way < 48; ++way) {
    double xyz[9];
    int k;
    check_scene("a triangle, way %d", way);
    for (k = 0; k < 9; ++k) xyz[k] = at[k / 3 * 3 + order[way % 6][k % 3]] * ((way / 6) >> (k % 3) & 1 ? -1 : 1);
    if (!CHECK_EQUAL(find(3, xyz, radius, 0, way == 0 ? &first : &other), HSP_OK) || way == 0) continue;
    CHECK_BYTES(&other.counts, &first.counts, sizeof first.counts);
    CHECK_NEAR(other.gates[0].radius, first.gates[0].radius, 1e-9 * first.gates[0].radius);
  }
  CHECK_EQUAL(first.counts.gates, 1);
}

/* A cage on a sphere of 65, of balls of radius 1: at the default step it is 6.5e10 steps wide. */
static void cage(void) {
  static found all;
  static double xyz[3 * 390], radius[390];
  uint32_t i;
  for (i = 0; i < 390; ++i) { /* a spiral */
    const double z = 1 - (2 * i + 1) / 390.0, turn = 2.399963229728653 * i;
    xyz[3 * i] = 65 * sqrt(1 - z * z) * cos(turn);
    xyz[3 * i + 1] = 65 * sqrt(1 - z * z) * sin(turn);
    xyz[3 * i + 2] = 65 * z;
    radius[i] = 1;
  }
  check_scene("a cage");
  if (!CHECK_EQUAL(find(390, xyz, radius, 0, &all), HSP_OK)) return;
  CHECK_NEAR(all.maxima[0].radius, 64, 1e-6);
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, MOST, &model), HSP_OK);
  other_steps();
  axes();
  cage();
  free(pores_memory);
  return check_report();
}
