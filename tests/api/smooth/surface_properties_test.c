/* The header's promises for every surface, on all sets of the interface tests with several probes; known values. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "limit_sweep.h"
#include "surface_result.h"
#include "topology_sets.h"

/* ---- known values ---- */

/* Balls of radius 1.7 and the probe 1.4, unless they say otherwise. */
typedef struct known_surface {
  const char *name;
  uint32_t n;
  double ball[4][4]; /* x, y, z, radius */
  double probe, convex, saddle, concave, volume;
  hsp_surface_counts counts;
} known_surface;

static const known_surface known_surfaces[] = {
    {"nothing", 0, {{0}}, 1.4, 0, 0, 0, 0, {0}},
    {"one ball", 1, {{1, 2, 3, 1}}, 1.4, 12.566370614359, 0, 0, 4.188790204786, {1, 0, 0, 0, 0, 0, 0, 0}},
    {"a saddle",
     2,
     {{0, 0, 0, 1.7}, {5.4, 0, 0, 1.7}},
     1.4,
     67.9475820122,
     6.8766538896,
     0,
     41.80379383311,
     {2, 1, 0, 0, 0, 0, 0, 0}},
    {"a saddle, larger probe",
     2,
     {{0, 0, 0, 1.7}, {5.4, 0, 0, 1.7}},
     3,
     57.1796599912,
     23.7817453226,
     0,
     47.93581275002,
     {2, 1, 0, 0, 0, 0, 0, 0}},
    {"two cusps",
     2,
     {{0, 0, 0, 2.0}, {5.6, 0, 0, 1.2}},
     1.4,
     66.2984492731,
     2.3200072966,
     0,
     40.84146738944,
     {2, 1, 0, 1, 0, 0, 0, 0}},
    {"a small ball beside a large one",
     2,
     {{0, 0, 0, 1.7}, {1.9, 0, 0, 0.3}},
     1.4,
     34.3749409815,
     2.5627595996,
     0,
     20.82937123191,
     {2, 1, 0, 0, 0, 0, 0, 0}},
    {"probes that see each other through a throat",
     3,
     {{2.9, 0, 0, 1.7}, {-1.45, 2.51147367, 0, 1.7}, {-1.45, -2.51147367, 0, 1.7}},
     1.4,
     89.1358433827,
     24.3930994435,
     6.35405963625,
     66.99444771262,
     {3, 3, 2, 0, 2, 0, 0, 0}},
    {"probes in a void and outside",
     4,
     {{1.79555934, 1.79555934, 1.79555934, 1.7},
      {1.79555934, -1.79555934, -1.79555934, 1.7},
      {-1.79555934, 1.79555934, -1.79555934, 1.7},
      {-1.79555934, -1.79555934, 1.79555934, 1.7}},
     1.4,
     108.55494545,
     36.4811662779,
     22.6266317068,
     92.23100491818,
     {8, 12, 8, 0, 8, 0, 0, 0}},
    {"four spheres through a point",
     4,
     {{2.1, 0, 0, 1.7}, {0, 2.1, 0, 1.7}, {-2.1, 0, 0, 1.7}, {0, -2.1, 0, 1.7}},
     1.4,
     76.903094407,
     33.136994481,
     4.740968667,
     87.0340342233,
     {4, 6, 4, 0, 0, 0, 0, 0}}};

static void check_known(const known_surface *k) {
  double xyz[12], radius[4];
  const hsp_model_options options = options_with_probe(k->probe);
  computed c;
  surface_result s;
  check_scene("%s", k->name);
  spread_balls(k->n, k->ball, xyz, radius);
  CHECK_EQUAL(computed_make(k->n, xyz, radius, &options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK);
  CHECK_NEAR(s.totals.convex_area, k->convex, 1.1e-9);
  CHECK_NEAR(s.totals.saddle_area, k->saddle, 1.1e-9);
  CHECK_NEAR(s.totals.concave_area, k->concave, 1.1e-9);
  CHECK_NEAR(s.totals.area, k->convex + k->saddle + k->concave, 3e-9);
  CHECK_NEAR(s.totals.volume, k->volume, 1.1e-9);
  CHECK_EQUAL(s.counts.convex_patches, c.counts.faces);
  CHECK_EQUAL(s.counts.saddle_patches, c.counts.arcs + c.counts.circles);
  CHECK_EQUAL(s.counts.concave_patches, c.counts.vertices);
  CHECK_EQUAL(s.counts.cusped_patches, k->counts.cusped_patches);
  CHECK_EQUAL(s.counts.cut_patches, k->counts.cut_patches);
  CHECK_EQUAL(s.counts.hidden_patches, k->counts.hidden_patches);
  CHECK_EQUAL(s.counts.rounded_patches, 0);
  CHECK_EQUAL(s.counts.open_joints, 0);
  surface_result_release(&s);
  computed_release(&c);
}

/* ---- what holds of every set ---- */

/* hsp_surface_measure, property 2; shares that add up; the surface without a probe is the boundary. */
static void check_sums(const surface_result *s, double probe) {
  hsp_surface_totals sum = {0, 0, 0, 0, 0};
  const double scale = 1.0 + s->totals.area;
  uint32_t i;
  for (i = 0; i < s->base->n; ++i) {
    const hsp_surface_totals *ball = &s->balls[i];
    sum.area += ball->area;
    sum.volume += ball->volume;
    sum.convex_area += ball->convex_area;
    sum.saddle_area += ball->saddle_area;
    sum.concave_area += ball->concave_area;
    CHECK(ball->convex_area >= 0.0 && ball->saddle_area >= 0.0 && ball->concave_area >= 0.0);
    CHECK_NEAR(ball->area, ball->convex_area + ball->saddle_area + ball->concave_area, 1e-12 * scale);
    if (probe > 0.0) continue;
    CHECK_NEAR(ball->area, s->base->area[i], 1e-12 * scale);
    CHECK_NEAR(ball->volume, s->base->volume[i], 1e-12 * scale * (1.0 + s->base->radius[i]));
  }
  CHECK_NEAR(sum.area, s->totals.area, 1e-11 * scale);
  CHECK_NEAR(sum.convex_area, s->totals.convex_area, 1e-11 * scale);
  CHECK_NEAR(sum.saddle_area, s->totals.saddle_area, 1e-11 * scale);
  CHECK_NEAR(sum.concave_area, s->totals.concave_area, 1e-11 * scale);
  CHECK_NEAR(sum.volume, s->totals.volume, 1e-10 * scale * (1.0 + probe));
}

/* ---- gradients ---- */

typedef struct surface_gradient {
  hsp_energy energy;
  double *centre, *radius;
  uint32_t *flags;
} surface_gradient;

/* sigma may be NULL. */
static void surface_gradient_make(const surface_result *s, const double *sigma, double tension, double pressure,
                                  surface_gradient *g) {
  const uint32_t n = s->base->n;
  uint32_t i;
  g->centre = test_zeros(n, 3 * sizeof *g->centre);
  g->radius = test_zeros(n, sizeof *g->radius);
  g->flags = test_zeros(n, sizeof *g->flags);
  if (sigma == NULL) {
    CHECK_EQUAL(
        hsp_surface_get_gradient(s->surface, SIZED(hsp_gradient_request, .tension = tension, .pressure = pressure),
                                 SIZED(hsp_gradient_outputs, .energy = &g->energy, .d_centre = g->centre,
                                       .d_radius = g->radius, .flags = g->flags, .capacity = n)),
        HSP_OK);
  } else {
    CHECK_EQUAL(hsp_surface_get_gradient(
                    s->surface, SIZED(hsp_gradient_request, .sigma = sigma, .tension = tension, .pressure = pressure),
                    SIZED(hsp_gradient_outputs, .energy = &g->energy, .d_centre = g->centre, .d_radius = g->radius,
                          .flags = g->flags, .capacity = n)),
                HSP_OK);
  }
  for (i = 0; i < n; ++i) {
    CHECK(isfinite(g->centre[3 * i]) && isfinite(g->centre[3 * i + 1]) && isfinite(g->centre[3 * i + 2]));
    CHECK(isfinite(g->radius[i]) && (g->flags[i] & ~HSP_SURFACE_DEGENERATE) == 0);
  }
}
static void surface_gradient_release(surface_gradient *g) {
  free(g->centre);
  free(g->radius);
  free(g->flags);
}

static void same_gradients(const surface_gradient *a, const surface_gradient *b, uint32_t n) {
  CHECK_BYTES(&a->energy, &b->energy, sizeof a->energy);
  CHECK_BYTES(a->centre, b->centre, 3 * (size_t)n * sizeof(double));
  CHECK_BYTES(a->radius, b->radius, n * sizeof(double));
  CHECK_BYTES(a->flags, b->flags, n * sizeof(uint32_t));
}

/* Weights of balls that follow from their coordinates, so that another order of the balls does not change them. */
static double *weights_of(const computed *c) {
  double *sigma = test_zeros(c->n, sizeof *sigma);
  uint32_t i;
  for (i = 0; i < c->n; ++i) sigma[i] = 1 + sin(17 * c->xyz[3 * i] + 5 * c->xyz[3 * i + 1] + 3 * c->xyz[3 * i + 2]);
  return sigma;
}

/* hsp_surface_get_gradient: what it says for equal weights and without any; its sums; without a probe it is the
 * boundary's gradient. */
static void check_weights(const ball_set *set, const surface_result *s, double probe) {
  const uint32_t n = set->n;
  double *sigma = weights_of(s->base), *twos = test_zeros(n, sizeof *twos);
  double sum[3] = {0, 0, 0}, growth = 0, scale = 1.0, largest = 1.0, area = 0.0;
  surface_gradient plain, weighted;
  int degenerate = 0;
  uint32_t i, axis;
  surface_gradient_make(s, NULL, 1.5, -0.25, &plain);
  CHECK_EQUAL(hsp_surface_get_gradient(s->surface, SIZED(hsp_gradient_request, .tension = 1.5, .pressure = -0.25),
                                       SIZED(hsp_gradient_outputs, .capacity = 0)),
              HSP_OK);
  surface_gradient_make(s, twos, 1.5, -0.25, &weighted);
  CHECK_EQUAL(
      hsp_surface_get_gradient(s->surface, SIZED(hsp_gradient_request, .tension = 1.5, .pressure = -0.25),
                               SIZED(hsp_gradient_outputs, .energy = &weighted.energy, .d_centre = weighted.centre,
                                     .d_radius = weighted.radius, .flags = weighted.flags, .capacity = n)),
      HSP_OK);
  same_gradients(&plain, &weighted, n);
  surface_gradient_release(&weighted);
  for (i = 0; i < n; ++i) twos[i] = 2;
  surface_gradient_make(s, twos, 0.75, -0.25, &weighted);
  CHECK_NEAR(weighted.energy.value, plain.energy.value, 1e-12 * (1.0 + fabs(plain.energy.value) + s->totals.area));
  for (i = 0; i < n; ++i) {
    CHECK_EQUAL(weighted.flags[i], plain.flags[i]);
    CHECK_NEAR(weighted.radius[i], plain.radius[i], 1e-12 * (1.0 + fabs(plain.radius[i]) + s->totals.area));
    for (axis = 0; axis < 3; ++axis) {
      const double expected = plain.centre[3 * i + axis];
      CHECK_NEAR(weighted.centre[3 * i + axis], expected, 1e-12 * (1.0 + fabs(expected) + s->totals.area));
    }
  }
  surface_gradient_release(&weighted);
  surface_gradient_release(&plain);
  surface_gradient_make(s, sigma, 1, 0, &weighted);
  for (i = 0; i < n; ++i) {
    const double *c = set->xyz + 3 * i, *d = weighted.centre + 3 * i;
    for (axis = 0; axis < 3; ++axis) {
      sum[axis] += d[axis];
      growth += c[axis] * d[axis];
      scale += fabs(d[axis]);
      largest = fmax(largest, fabs(c[axis]));
    }
    growth += set->radius[i] * weighted.radius[i];
    scale += fabs(weighted.radius[i]);
    largest = fmax(largest, set->radius[i]);
    area += sigma[i] * s->balls[i].area;
    if (weighted.flags[i] != 0) degenerate = 1;
  }
  CHECK_NEAR(weighted.energy.area, area, 1e-11 * (1.0 + s->totals.area));
  CHECK_NEAR(weighted.energy.value, area, 1e-11 * (1.0 + s->totals.area));
  CHECK_NEAR(weighted.energy.volume, s->totals.volume, 1e-11 * (1.0 + s->totals.volume));
  if (!degenerate) {
    for (axis = 0; axis < 3; ++axis) CHECK_NEAR(sum[axis], 0.0, 1e-9 * scale);
    CHECK_NEAR(growth + probe * weighted.energy.d_probe, 2 * area, 1e-9 * scale * (largest + probe));
  }
  if (!degenerate && probe == 0.0) {
    surface_gradient_make(s, NULL, 1, 0, &plain);
    CHECK_EQUAL(hsp_boundary_get_gradient(
                    s->base->boundary,
                    SIZED(hsp_gradient_request, .sigma = sigma, .tension = 1, .tangency = HSP_TANGENT_DISJOINT),
                    SIZED(hsp_gradient_outputs, .energy = &plain.energy, .d_centre = plain.centre,
                          .d_radius = plain.radius, .flags = plain.flags, .capacity = n)),
                HSP_OK);
    for (i = 0; i < n; ++i) {
      CHECK_NEAR(weighted.radius[i], plain.radius[i], 1e-9 * scale);
      for (axis = 0; axis < 3; ++axis)
        CHECK_NEAR(weighted.centre[3 * i + axis], plain.centre[3 * i + axis], 1e-9 * scale);
    }
    surface_gradient_release(&plain);
  }
  surface_gradient_release(&weighted);
  free(twos);
  free(sigma);
}

/* hsp_surface_get_gradient, properties 1, 2 and 4, for the area alone and for the volume alone. Where vertices are
 * degenerate derivatives need not add up. */
static void check_gradient(const ball_set *set, const surface_result *s, double probe) {
  int of_volume;
  for (of_volume = 0; of_volume < 2; ++of_volume) {
    surface_gradient g;
    double sum[3] = {0, 0, 0}, torque[3] = {0, 0, 0}, growth = 0, radii = 0, scale = 1.0, largest = 1.0;
    const double value = of_volume ? s->totals.volume : s->totals.area;
    int degenerate = 0;
    uint32_t i, axis;
    surface_gradient_make(s, NULL, of_volume ? 0 : 1, of_volume ? 1 : 0, &g);
    CHECK_NEAR(g.energy.value, value, 1e-11 * (1.0 + value));
    CHECK_NEAR(g.energy.area, s->totals.area, 1e-11 * (1.0 + s->totals.area));
    CHECK_NEAR(g.energy.volume, s->totals.volume, 1e-11 * (1.0 + s->totals.volume));
    for (i = 0; i < set->n; ++i) {
      const double *c = set->xyz + 3 * i, *d = g.centre + 3 * i;
      for (axis = 0; axis < 3; ++axis) {
        const uint32_t next = (axis + 1) % 3, last = (axis + 2) % 3;
        sum[axis] += d[axis];
        torque[axis] += c[next] * d[last] - c[last] * d[next];
        growth += c[axis] * d[axis];
        scale += fabs(d[axis]);
        largest = fmax(largest, fabs(c[axis]));
      }
      growth += set->radius[i] * g.radius[i];
      radii += g.radius[i];
      scale += fabs(g.radius[i]);
      largest = fmax(largest, set->radius[i]);
      if (g.flags[i] != 0) degenerate = 1;
    }
    if (!degenerate) {
      const double tolerance = 1e-9 * scale * (largest + probe);
      for (axis = 0; axis < 3; ++axis) {
        CHECK_NEAR(sum[axis], 0.0, 1e-9 * scale);
        CHECK_NEAR(torque[axis], 0.0, tolerance);
      }
      CHECK_NEAR(growth + probe * g.energy.d_probe, of_volume ? 3 * value : 2 * value, tolerance);
      if (of_volume) CHECK_NEAR(g.energy.d_probe, radii - s->totals.area, tolerance);
    }
    surface_gradient_release(&g);
  }
}

/* Property 3, of a set and the same in another order. */
static void check_gradient_order(const surface_result *s, const surface_result *other, const uint32_t *order) {
  surface_gradient here, there;
  double *sigma = weights_of(s->base), *permuted = weights_of(other->base);
  uint32_t i;
  surface_gradient_make(s, sigma, 1.5, -0.25, &here);
  surface_gradient_make(other, permuted, 1.5, -0.25, &there);
  for (i = 0; i < s->base->n; ++i) {
    CHECK_BYTES(there.centre + 3 * i, here.centre + 3 * (size_t)order[i], 3 * sizeof(double));
    CHECK_BYTES(there.radius + i, here.radius + order[i], sizeof(double));
    CHECK_EQUAL(there.flags[i], here.flags[order[i]]);
  }
  surface_gradient_release(&here);
  surface_gradient_release(&there);
  free(sigma);
  free(permuted);
}

/* The solid holds the balls without the probe, and lies in the union with it. */
static void check_bounds(const ball_set *set, const surface_result *s) {
  computed bare;
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &bare), HSP_OK);
  CHECK(s->totals.volume >= bare.totals.volume * (1.0 - 1e-9));
  CHECK(s->totals.volume <= s->base->totals.volume * (1.0 + 1e-9));
  computed_release(&bare);
}

/* Property 1: shares are the same bits in any order. Equal balls are interchangeable: sets with such are left out. */
static void check_order(const ball_set *set, const hsp_model_options *options, const surface_result *s) {
  static ball_set permuted;
  uint32_t order[BALL_SET_MOST];
  computed c;
  surface_result other;
  uint32_t i, j;
  for (i = 0; i < set->n; ++i) {
    for (j = 0; j < i; ++j) {
      if (memcmp(set->xyz + 3 * i, set->xyz + 3 * j, 3 * sizeof(double)) == 0) return;
    }
  }
  ball_set_shuffle(set->n, 16, order);
  ball_set_permute(set, order, &permuted);
  CHECK_EQUAL(computed_make(permuted.n, permuted.xyz, permuted.radius, options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &other), HSP_OK);
  for (i = 0; i < set->n; ++i) CHECK_BYTES(&other.balls[i], &s->balls[order[i]], sizeof other.balls[i]);
  CHECK_BYTES(&other.counts, &s->counts, sizeof other.counts);
  CHECK_BYTES(&other.needed, &s->needed, sizeof other.needed);
  check_gradient_order(s, &other, order);
  surface_result_release(&other);
  computed_release(&c);
}

/* ---- limits and sizes ---- */

static void same_results(const void *handle, const void *source) {
  const surface_result *s = source;
  hsp_surface_counts counts;
  hsp_surface_totals totals;
  CHECK_EQUAL(hsp_surface_get_counts(handle, &counts), HSP_OK);
  CHECK_BYTES(&counts, &s->counts, sizeof counts);
  CHECK_EQUAL(hsp_surface_measure(handle, &totals, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&totals, &s->totals, sizeof totals);
}
static void no_results(const void *handle) {
  hsp_surface_counts counts;
  CHECK_EQUAL(hsp_surface_get_counts(handle, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_measure(handle, NULL, NULL, 0, NULL), HSP_E_STATE);
}

static size_t macro(const limit_numbers *limits) {
  return HSP_SURFACE_BYTES(limits->number[1], limits->number[2], limits->number[3], limits->number[4],
                           limits->number[5], limits->number[6]);
}

static void sizes(void) {
  static const uint32_t values[] = {0, 1, 65, 1000, 4097, 0x0FFFFFFF};
  static const size_bound bound = {macro, {8192, 54, 9, 1152, 106, 26, 16}, 4.8e10};
  check_scene("sizes");
  sweep_sizes(&surface_handle, &bound, values, sizeof values / sizeof values[0]);
}

static void check_set(const ball_set *set, double probe) {
  const hsp_model_options options = options_with_probe(probe);
  computed c;
  surface_result s;
  check_scene("%s, probe %g", set->name, probe);
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK) &&
      CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK)) {
    const known_handle known = {&surface_handle, &s, &s.needed, same_results, no_results, NULL};
    CHECK(s.enlargements <= 6);
    check_sums(&s, probe);
    check_bounds(set, &s);
    check_gradient(set, &s, probe);
    check_weights(set, &s, probe);
    check_order(set, &options, &s);
    if (set->n <= 30) sweep_limits(&known, set->name);
    if (set->n > 3 && set->n < 10) sweep_alignments(&known, NULL);
    surface_result_release(&s);
  }
  computed_release(&c);
}

int main(void) {
  static const double probes[] = {0.0, 0.25, 1.5, 4.0};
  size_t i;
  for (i = 0; i < sizeof known_surfaces / sizeof known_surfaces[0]; ++i) check_known(&known_surfaces[i]);
  sizes();
  sets_with_probes(probes, (uint32_t)(sizeof probes / sizeof probes[0]), check_set);
  return check_report();
}
