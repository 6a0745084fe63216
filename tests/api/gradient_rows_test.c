/* The Jacobian of areas in one call: the bits of single rows, by weights and by threads; sums of columns; sizes known
 * beforehand; and what of the arrays is refused. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gradients.h"
#include "loops.h"

typedef struct rows {
  uint32_t first[BALL_SET_MOST + 1], needed;
  uint32_t *ball;
  double *centre, *radius;
} rows;

static void *room_for(uint32_t count, size_t size) {
  void *const memory = malloc((count + 1) * size);
  if (memory == NULL) exit(2);
  memset(memory, 0x5A, (count + 1) * size);
  return memory;
}

static void release(rows *r) {
  free(r->ball);
  free(r->centre);
  free(r->radius);
}

/* Counts, then lists; one entry more of each array stays as it was. */
static int32_t rows_make(const computed *c, const hsp_derivatives_request *request, rows *r) {
  static rows counted;
  const unsigned char untouched[sizeof(double)] = {0x5A, 0x5A, 0x5A, 0x5A, 0x5A, 0x5A, 0x5A, 0x5A};
  int32_t status = hsp_boundary_get_area_rows(c->boundary, request, counted.first, NULL, NULL, NULL, 0, &r->needed);
  CHECK_EQUAL(status, counted.first[c->n] > 0 ? HSP_E_CAPACITY : HSP_OK);
  CHECK(counted.first[0] == 0 && counted.first[c->n] == r->needed);
  CHECK(r->needed <= c->counts.exposed_balls + 2 * (c->counts.arcs + c->counts.circles));
  r->ball = room_for(r->needed, sizeof *r->ball);
  r->centre = room_for(3 * r->needed, sizeof *r->centre);
  r->radius = room_for(r->needed, sizeof *r->radius);
  status = hsp_boundary_get_area_rows(c->boundary, request, r->first, r->ball, r->centre, r->radius, r->needed, NULL);
  CHECK_BYTES(r->first, counted.first, (c->n + 1) * sizeof *r->first);
  CHECK_BYTES(r->ball + r->needed, untouched, sizeof *r->ball);
  CHECK_BYTES(r->centre + 3 * r->needed, untouched, sizeof *r->centre);
  CHECK_BYTES(r->radius + r->needed, untouched, sizeof *r->radius);
  return status;
}

static void have_the_bits_of_single_rows(const computed *c, const double *sigma, const rows *r, uint32_t tangency) {
  static hsp_area_derivative row[BALL_SET_MOST];
  uint32_t i, k, length;
  for (i = 0; i < c->n; ++i) {
    const double weight = sigma == NULL ? 1 : sigma[i];
    CHECK_EQUAL(hsp_boundary_get_area_row(c->boundary, i, tangency, row, BALL_SET_MOST, &length), HSP_OK);
    if (!CHECK_EQUAL(r->first[i + 1] - r->first[i], length)) return;
    for (k = 0; k < length; ++k) {
      const uint32_t e = r->first[i] + k;
      const double centre[3] = {weight * row[k].centre[0], weight * row[k].centre[1], weight * row[k].centre[2]};
      const double radius = weight * row[k].radius;
      CHECK_EQUAL(r->ball[e], row[k].ball);
      CHECK_BYTES(r->centre + 3 * e, centre, sizeof centre);
      CHECK_BYTES(r->radius + e, &radius, sizeof radius);
    }
  }
}

static void sum_to_the_gradient(const computed *c, const hsp_derivatives_request *request, const rows *r) {
  static double column[3 * BALL_SET_MOST], by_radius[BALL_SET_MOST], centre[3 * BALL_SET_MOST], radius[BALL_SET_MOST];
  hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs, .capacity = c->n};
  const double near_zero = 1e-10 * (1 + c->extent);
  uint32_t i, k, axis;
  outputs.area_centre = centre;
  outputs.area_radius = radius;
  memset(column, 0, sizeof column);
  memset(by_radius, 0, sizeof by_radius);
  for (k = 0; k < r->needed; ++k) {
    for (axis = 0; axis < 3; ++axis) column[3 * r->ball[k] + axis] += r->centre[3 * k + axis];
    by_radius[r->ball[k]] += r->radius[k];
  }
  CHECK_EQUAL(hsp_boundary_get_derivatives(c->boundary, request, &outputs), HSP_OK);
  for (i = 0; i < c->n; ++i) {
    for (axis = 0; axis < 3; ++axis) CHECK_NEAR(column[3 * i + axis], centre[3 * i + axis], near_zero);
    CHECK_NEAR(by_radius[i], radius[i], near_zero);
  }
}

static void of_a_set(const ball_set *set, uint32_t which) {
  static double sigma[BALL_SET_MOST];
  loop own = loop_of(LOOP_SHUFFLED);
  hsp_executor executor = executor_of(&own, 3);
  hsp_derivatives_request request = {.struct_size = sizeof request};
  rows alone, shared;
  computed c;
  uint32_t i;
  for (i = 0; i < set->n; ++i) sigma[i] = i % 5 == 2 ? 0 : 0.25 * i - 1.5;
  check_scene("rows of %s", set->name);
  request.tangency = which % 2 == 0 ? HSP_TANGENT_OVERLAP : HSP_TANGENT_DISJOINT;
  request.sigma = which % 3 == 0 ? NULL : sigma;
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK)) {
    CHECK_EQUAL(rows_make(&c, &request, &alone), HSP_OK);
    have_the_bits_of_single_rows(&c, request.sigma, &alone, request.tangency);
    sum_to_the_gradient(&c, &request, &alone);
    request.executor = &executor;
    CHECK_EQUAL(rows_make(&c, &request, &shared), HSP_OK);
    CHECK_BYTES(shared.ball, alone.ball, alone.needed * sizeof *alone.ball);
    CHECK_BYTES(shared.centre, alone.centre, 3 * alone.needed * sizeof *alone.centre);
    CHECK_BYTES(shared.radius, alone.radius, alone.needed * sizeof *alone.radius);
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, &request, shared.first, shared.ball, shared.centre, NULL,
                                           alone.needed, NULL),
                HSP_OK);
    CHECK_BYTES(shared.centre, alone.centre, 3 * alone.needed * sizeof *alone.centre);
    release(&alone);
    release(&shared);
  }
  computed_release(&c);
}

static void refused(void) {
  static ball_set set;
  static uint32_t first[BALL_SET_MOST + 1], ball[BALL_SET_MOST], needed;
  static double centre[3 * BALL_SET_MOST], sigma[THREE_BALLS] = {1, 1, 1};
  loop own = loop_of(LOOP_FORGETS);
  hsp_executor executor = executor_of(&own, 2);
  hsp_derivatives_request request = {.struct_size = sizeof request};
  computed c;
  ball_set_start(&set, "three", 0.25);
  ball_set_add_three(&set);
  check_scene("rows that are refused");
  if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, NULL, first, NULL, centre, NULL, 1, &needed), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, NULL, first, ball, NULL, NULL, 1, &needed), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, NULL, NULL, ball, centre, NULL, 99, &needed), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, NULL, first, ball, centre, NULL, 8, &needed), HSP_E_CAPACITY);
    CHECK(needed == 9 && first[1] == 3 && first[2] == 6 && first[3] == 9);
    sigma[2] = (double)INFINITY;
    request.sigma = sigma;
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, &request, first, ball, centre, NULL, 9, &needed),
                HSP_E_NOT_FINITE);
    request.sigma = NULL;
    request.tangency = 2;
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, &request, first, ball, centre, NULL, 9, &needed),
                HSP_E_ARGUMENT);
  }
  computed_release(&c);
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 200, 3);
  request.tangency = 0;
  request.executor = &executor;
  if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
    const uint32_t most = c.counts.exposed_balls + 2 * (c.counts.arcs + c.counts.circles);
    uint32_t *const columns = room_for(most, sizeof *columns);
    double *const entries = room_for(3 * most, sizeof *entries);
    CHECK_EQUAL(hsp_boundary_get_area_rows(c.boundary, &request, first, columns, entries, NULL, most, &needed),
                HSP_E_EXECUTOR);
    free(columns);
    free(entries);
  }
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  uint32_t which;
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &set);
    of_a_set(&set, which);
  }
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 300, 78);
  of_a_set(&set, 1);
  refused();
  return check_report();
}
