/* Areas and volume terms of some of the balls, and of faces, against those of all balls, for every set of the
 * catalogue. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ball_formulas.h"
#include "ball_sets.h"
#include "check.h"
#include "computed.h"

static double largest_of(const double *values, uint32_t n) {
  double most = 0;
  uint32_t i;
  for (i = 0; i < n; ++i) most = fmax(most, fabs(values[i]));
  return most;
}

/* Measuring a selection: what is selected is as it was, the rest is 0, and totals are the sums. */
static void check_selected(const computed *c, const uint8_t *selected) {
  double area[BALL_SET_MOST], volume[BALL_SET_MOST], areas = 0, volumes = 0;
  hsp_totals totals;
  uint32_t i;
  memset(area, 0x5A, sizeof area);
  memset(volume, 0x5A, sizeof volume);
  CHECK_EQUAL(hsp_boundary_measure(c->boundary, selected, &totals, area, volume, c->n, NULL), HSP_OK);
  for (i = 0; i < c->n; ++i) {
    static const double nothing = 0;
    const int counts = selected == NULL || selected[i] != 0;
    CHECK_BYTES(area + i, counts ? c->area + i : &nothing, sizeof(double));
    CHECK_BYTES(volume + i, counts ? c->volume + i : &nothing, sizeof(double));
    areas += area[i];
    volumes += volume[i];
  }
  CHECK_NEAR(totals.area, areas, 1e-14 * c->totals.area);
  CHECK_NEAR(totals.volume, volumes, 1e-14 * c->n * largest_of(c->volume, c->n));
}

static void selections(const computed *c) {
  static const uint8_t not_zero[4] = {1, 2, 0x80, 0xFF};
  uint8_t selected[BALL_SET_MOST];
  hsp_totals totals;
  uint32_t i, modulus;
  check_selected(c, NULL);
  CHECK_EQUAL(hsp_boundary_measure(c->boundary, NULL, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&totals, &c->totals, sizeof totals);
  memset(selected, 0, sizeof selected);
  check_selected(c, selected);
  for (modulus = 1; modulus < 5; ++modulus) {
    for (i = 0; i < c->n; ++i) selected[i] = i % modulus == 0 ? not_zero[i % 4] : 0;
    check_selected(c, selected);
  }
  for (i = 0; i < c->n; i += 1 + c->n / 7) {
    memset(selected, 0, sizeof selected);
    selected[i] = 1;
    check_selected(c, selected);
  }
}

/* hsp_boundary_measure_faces, property 1; no face is larger than its sphere. */
static void faces(const computed *c) {
  const uint32_t count = c->counts.faces;
  double *area = calloc((size_t)count + 1, sizeof *area), *volume = calloc((size_t)count + 1, sizeof *volume);
  uint32_t i, f;
  if (area == NULL || volume == NULL) exit(2);
  CHECK_EQUAL(hsp_boundary_measure_faces(c->boundary, area, volume, count, NULL), HSP_OK);
  for (i = 0; i < c->n; ++i) {
    const double sphere = 4 * acos(-1.0) * c->radius[i] * c->radius[i];
    double areas = 0, volumes = 0, size = 0;
    for (f = 0; f < c->balls[i].faces; ++f) {
      const uint32_t face = c->balls[i].first_face + f;
      CHECK_EQUAL(c->faces[face].ball, i);
      CHECK(area[face] >= 0 && area[face] <= sphere * (1 + 1e-14));
      if (c->faces[face].loops == 0) CHECK_NEAR(area[face], sphere, 1e-15 * sphere);
      areas += area[face];
      volumes += volume[face];
      size += fabs(volume[face]);
    }
    CHECK_NEAR(areas, c->area[i], 1e-13 * sphere);
    CHECK_NEAR(volumes, c->volume[i], 1e-13 * (size + sphere * c->radius[i]));
    if (c->balls[i].faces == 0) CHECK(c->area[i] == 0 && c->volume[i] == 0);
    if (c->balls[i].faces == 1) CHECK_NEAR(areas, c->area[i], 1e-15 * sphere);
  }
  free(area);
  free(volume);
}

typedef struct plain_face {
  double xyz[3], r, area, volume;
} plain_face;

static int by_bytes(const void *a, const void *b) {
  return memcmp(a, b, sizeof(plain_face));
}

static plain_face *plain_faces(const ball_set *set, const computed *c) {
  const uint32_t count = c->counts.faces;
  double *area = calloc((size_t)count + 1, sizeof *area), *volume = calloc((size_t)count + 1, sizeof *volume);
  plain_face *all = calloc((size_t)count + 1, sizeof *all);
  uint32_t f;
  if (area == NULL || volume == NULL || all == NULL) exit(2);
  CHECK_EQUAL(hsp_boundary_measure_faces(c->boundary, area, volume, count, NULL), HSP_OK);
  for (f = 0; f < count; ++f) {
    const uint32_t ball = c->faces[f].ball;
    memcpy(all[f].xyz, set->xyz + 3 * ball, sizeof all[f].xyz);
    all[f].r = set->radius[ball];
    all[f].area = area[f];
    all[f].volume = volume[f];
  }
  qsort(all, count, sizeof *all, by_bytes);
  free(area);
  free(volume);
  return all;
}

/* The order of the balls has no effect on the numbers of any face. */
static void any_order(const ball_set *set, const computed *c) {
  static ball_set permuted;
  uint32_t order[BALL_SET_MOST], i;
  plain_face *all = plain_faces(set, c);
  int round;
  for (round = 0; round < 3; ++round) {
    computed d;
    plain_face *other;
    for (i = 0; i < set->n; ++i) order[i] = set->n - 1 - i;
    if (round > 0) ball_set_shuffle(set->n, (uint64_t)round, order);
    ball_set_permute(set, order, &permuted);
    CHECK_EQUAL(computed_make(permuted.n, permuted.xyz, permuted.radius, NULL, &d), HSP_OK);
    other = plain_faces(&permuted, &d);
    if (CHECK_EQUAL(d.counts.faces, c->counts.faces)) CHECK_BYTES(other, all, c->counts.faces * sizeof *all);
    free(other);
    computed_release(&d);
  }
  free(all);
}

/* A ball with a belt of smaller ones has two faces, equal up to the mirror z -> -z, and the belt's balls have one each.
 * A ball that another one cuts has one, whose area is known. */
static void known_faces(void) {
  static ball_set s;
  computed c;
  uint32_t which;
  double area[64], volume[64];
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &s);
    if (strcmp(s.name, "a ball with a belt and a bump on its pole") == 0) break;
  }
  CHECK(which < ball_set_count());
  s.n -= 1; /* without the bump */
  check_scene("a ball with a belt");
  CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, NULL, &c), HSP_OK);
  if (CHECK_EQUAL(c.balls[0].faces, 2) && CHECK(c.counts.faces <= 64)) {
    const uint32_t first = c.balls[0].first_face;
    CHECK_EQUAL(hsp_boundary_measure_faces(c.boundary, area, volume, 64, NULL), HSP_OK);
    CHECK(area[first] > 0.25 * c.totals.area / s.n);
    CHECK_NEAR(area[first], area[first + 1], 1e-13 * area[first]);
    CHECK_NEAR(area[first], c.area[0] / 2, 1e-13 * area[first]);
  }
  computed_release(&c);

  check_scene("two balls");
  ball_set_start(&s, "two balls", 1e-8);
  ball_set_add(&s, 0, 0, 0, 1.5);
  ball_set_add(&s, 1.75, 0, 0, 1.25);
  CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, NULL, &c), HSP_OK);
  if (CHECK_EQUAL(c.counts.faces, 2)) {
    const double h = (1.75 * 1.75 + 1.5 * 1.5 - 1.25 * 1.25) / (2 * 1.75);
    const uint32_t first = c.balls[0].first_face, second = c.balls[1].first_face;
    const amount both = amount_of_two_balls(1.5, 1.25, 1.75);
    CHECK_EQUAL(hsp_boundary_measure_faces(c.boundary, area, volume, 2, NULL), HSP_OK);
    CHECK_NEAR(area[first], amount_of_ball(1.5).area - amount_of_cap(1.5, h).area, 1e-14 * both.area);
    CHECK_NEAR(area[second], amount_of_ball(1.25).area - amount_of_cap(1.25, 1.75 - h).area, 1e-14 * both.area);
    CHECK_NEAR(volume[first] + volume[second], both.volume, 1e-14 * both.volume);
  }
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  uint32_t which;
  for (which = 0; which < ball_set_count(); ++which) {
    computed c;
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      selections(&c);
      faces(&c);
      any_order(&set, &c);
    }
    computed_release(&c);
  }
  known_faces();
  return check_report();
}
