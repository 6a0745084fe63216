/* The output arrays of measures of parts, of gradients and of rows of the Jacobian, for every set of the catalogue, at
 * capacities 0, 1, needed-1, needed and needed+1, with guard bytes around every array: a capacity that is too small
 * writes nothing, any other the same numbers and nothing behind them. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "gradients.h"
#include "guarded_memory.h"
#include "output_sweep.h"

static double *doubles(const guarded_memory *memory) {
  return (double *)(void *)memory->block;
}

static uint32_t *numbers(const guarded_memory *memory) {
  return (uint32_t *)(void *)memory->block;
}

/* Whether an output holds what was expected and nothing behind it, or is as it was. */
static int holds(const guarded_memory *memory, int written, const void *expected, size_t bytes) {
  size_t i;
  if (!written) return guarded_untouched(memory, GUARDED_PATTERN);
  if (memory->bytes < bytes || (bytes > 0 && memcmp(memory->block, expected, bytes) != 0)) return 0;
  for (i = bytes; i < memory->bytes; ++i) {
    if (memory->block[i] != GUARDED_PATTERN) return 0;
  }
  return 1;
}

/* Two arrays of `count` doubles and the totals, any of which may be missing: areas and volumes, of balls or faces. */
typedef int32_t (*measuring)(const computed *c, hsp_totals *totals, double *area, double *volume, uint32_t capacity);

static int32_t measure_selected(const computed *c, hsp_totals *totals, double *area, double *volume,
                                uint32_t capacity) {
  uint8_t selected[BALL_SET_MOST];
  uint32_t i;
  for (i = 0; i < c->n; ++i) selected[i] = (uint8_t)(i % 3);
  return hsp_boundary_measure(c->boundary, selected, totals, area, volume, capacity, NULL);
}

static int32_t measure_faces(const computed *c, hsp_totals *totals, double *area, double *volume, uint32_t capacity) {
  (void)totals;
  return hsp_boundary_measure_faces(c->boundary, area, volume, capacity, NULL);
}

static void sweep_measure(const computed *c, measuring measure, uint32_t count, int has_totals) {
  const size_t bytes = count * sizeof(double);
  guarded_memory area = guarded_take(bytes, 0, 0), volume = guarded_take(bytes, 0, 0);
  hsp_totals totals;
  uint32_t capacities[AROUND], i, arrays;
  memset(&totals, 0, sizeof totals);
  CHECK_EQUAL(measure(c, &totals, doubles(&area), doubles(&volume), count), HSP_OK);
  CHECK(guarded_clean(&area) && guarded_clean(&volume));
  values_around(count, capacities);
  for (i = 0; i < AROUND; ++i) {
    for (arrays = 1; arrays < 4; ++arrays) {
      const int enough = capacities[i] >= count;
      guarded_memory a = guarded_take(capacities[i] * sizeof(double), 0, GUARDED_PATTERN);
      guarded_memory v = guarded_take(capacities[i] * sizeof(double), 0, GUARDED_PATTERN);
      hsp_totals written, untouched;
      memset(&written, GUARDED_PATTERN, sizeof written);
      untouched = written;
      CHECK_EQUAL(measure(c, &written, (arrays & 1) != 0 ? doubles(&a) : NULL, (arrays & 2) != 0 ? doubles(&v) : NULL,
                          capacities[i]),
                  enough ? HSP_OK : HSP_E_CAPACITY);
      CHECK(holds(&a, enough && (arrays & 1) != 0, area.block, bytes));
      CHECK(holds(&v, enough && (arrays & 2) != 0, volume.block, bytes));
      CHECK_BYTES(&written, enough && has_totals ? &totals : &untouched, sizeof written);
      CHECK(guarded_clean(&a) && guarded_clean(&v));
      guarded_give_back(&a);
      guarded_give_back(&v);
    }
  }
  guarded_give_back(&area);
  guarded_give_back(&volume);
}

static void sweep_gradient(const computed *c) {
  static gradients g;
  const uint32_t n = c->n;
  uint32_t capacities[AROUND], i, arrays;
  CHECK_EQUAL(gradients_make(c, NULL, 2, 0.5, HSP_TANGENT_OVERLAP, &g), HSP_OK);
  values_around(n, capacities);
  for (i = 0; i < AROUND; ++i) {
    for (arrays = 0; arrays < 8; ++arrays) {
      const uint32_t capacity = capacities[i];
      const int enough = capacity >= n || arrays == 0;
      guarded_memory centre = guarded_take(3 * capacity * sizeof(double), 0, GUARDED_PATTERN);
      guarded_memory radius = guarded_take(capacity * sizeof(double), 0, GUARDED_PATTERN);
      guarded_memory flags = guarded_take(capacity * sizeof(uint32_t), 0, GUARDED_PATTERN);
      hsp_energy energy, untouched;
      memset(&energy, GUARDED_PATTERN, sizeof energy);
      untouched = energy;
      CHECK_EQUAL(
          hsp_boundary_get_gradient(
              c->boundary, SIZED(hsp_gradient_request, .tension = 2, .pressure = 0.5),
              SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = (arrays & 1) != 0 ? doubles(&centre) : NULL,
                    .d_radius = (arrays & 2) != 0 ? doubles(&radius) : NULL,
                    .flags = (arrays & 4) != 0 ? numbers(&flags) : NULL, .capacity = capacity)),
          enough ? HSP_OK : HSP_E_CAPACITY);
      CHECK_BYTES(&energy, enough ? &g.energy : &untouched, sizeof energy);
      CHECK(holds(&centre, enough && (arrays & 1) != 0, g.centre, 3 * n * sizeof(double)));
      CHECK(holds(&radius, enough && (arrays & 2) != 0, g.radius, n * sizeof(double)));
      CHECK(holds(&flags, enough && (arrays & 4) != 0, g.flags, n * sizeof(uint32_t)));
      CHECK(guarded_clean(&centre) && guarded_clean(&radius) && guarded_clean(&flags));
      guarded_give_back(&centre);
      guarded_give_back(&radius);
      guarded_give_back(&flags);
    }
  }
}

static void sweep_row(const computed *c, uint32_t ball, uint32_t tangency) {
  uint32_t capacities[AROUND], i, length = 12345;
  const int32_t status = hsp_boundary_get_area_row(c->boundary, ball, tangency, NULL, 0, &length);
  guarded_memory row;
  CHECK_EQUAL(status, length == 0 ? HSP_OK : HSP_E_CAPACITY);
  if (!CHECK(length <= c->n)) return;
  row = guarded_take(length * sizeof(hsp_area_derivative), 0, 0);
  CHECK_EQUAL(
      hsp_boundary_get_area_row(c->boundary, ball, tangency, (hsp_area_derivative *)(void *)row.block, length, &length),
      HSP_OK);
  CHECK(guarded_clean(&row));
  values_around(length, capacities);
  for (i = 0; i < AROUND; ++i) {
    const int enough = capacities[i] >= length;
    guarded_memory out = guarded_take(capacities[i] * sizeof(hsp_area_derivative), 0, GUARDED_PATTERN);
    uint32_t needed = 12345;
    CHECK_EQUAL(hsp_boundary_get_area_row(c->boundary, ball, tangency, (hsp_area_derivative *)(void *)out.block,
                                          capacities[i], &needed),
                enough ? HSP_OK : HSP_E_CAPACITY);
    CHECK_EQUAL(needed, length);
    CHECK(holds(&out, enough, row.block, length * sizeof(hsp_area_derivative)));
    CHECK(guarded_clean(&out));
    guarded_give_back(&out);
  }
  guarded_give_back(&row);
}

int main(void) {
  static ball_set set;
  uint32_t which, i;
  for (which = 0; which < ball_set_count(); ++which) {
    computed c;
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      sweep_measure(&c, measure_selected, c.n, 1);
      sweep_measure(&c, measure_faces, c.counts.faces, 0);
      sweep_gradient(&c);
      for (i = 0; i < set.n; ++i) sweep_row(&c, i, i % 2 == 0 ? HSP_TANGENT_OVERLAP : HSP_TANGENT_DISJOINT);
    }
    computed_release(&c);
  }
  return check_report();
}
