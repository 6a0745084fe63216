#include "draw/occlusion.h"

#include <stdlib.h>
#include <string.h>

/* Lengths in angstrom where a typical large ball has the radius of carbon. */
static const double carbon_radius = 1.7;
static const double reach = 4.0; /* of the smoothing */
static const double bond = 1.9;  /* nearer balls are one body: there is no line between them */
static const double largest_probe = 7.0;

/* The larger the probe, the more neighbours a ball has: 7 costs about five times as much as 2.8, and that as 1.4. So
 * large sets do without the larger probes. Weights change gradually with the number of balls: a ball more or less makes
 * no visible difference. */
struct probe_rule {
  double probe;
  uint32_t none_at, all_from; /* its weight rises from 0 to 1 between these numbers of balls */
  uint32_t all_to, none_from; /* and falls to 0 between these */
};
static const struct probe_rule probe_rules[] = {
    {2.8, 0, 1, 5000, 15000}, {7.0, 0, 1, 500, 1000}, {1.4, 5000, 15000, UINT32_MAX - 1, UINT32_MAX}};
enum { PROBE_RULES = sizeof probe_rules / sizeof probe_rules[0] };

/* Few balls shade each other little; their darkest would look dirty. So exposure does not fall below this in sets of up
 * to 30 balls, and the limit fades out up to 90. */
static const double least_exposure_of_few = 0.6;
enum { FEW = 30, NOT_FEW = 90 };

/* 0 up to `low`, 1 from `high` on, linear between. */
static double ramp(uint32_t value, uint32_t low, uint32_t high) {
  if (value <= low) return 0.0;
  return value >= high ? 1.0 : (double)(value - low) / (double)(high - low);
}

static double probe_weight(const struct probe_rule *rule, uint32_t balls) {
  return ramp(balls, rule->none_at, rule->all_from) - ramp(balls, rule->all_to, rule->none_from);
}

/* The number of shades of a colour. Few are enough, and pictures write a colour once for all balls that have it. */
enum { SHADES = 16 };

static const double pi = 3.14159265358979323846;

static int order_of_doubles(const void *left, const void *right) {
  const double a = *(const double *)left;
  const double b = *(const double *)right;
  return (a > b) - (a < b);
}

/* Stores in *found the quantile of the values: the one that the fraction `part` of the others does not exceed. False if
 * there is no memory. */
static bool quantile(const double *values, uint32_t count, double part, double *found, struct failure *failure) {
  *found = 0.0;
  if (count == 0) return true;
  double *sorted = malloc(count * sizeof *sorted);
  if (sorted == NULL) return failure_of_memory(failure);
  memcpy(sorted, values, count * sizeof *sorted);
  qsort(sorted, count, sizeof *sorted, order_of_doubles);
  *found = sorted[(uint32_t)(part * (double)(count - 1))];
  free(sorted);
  return true;
}

/* Find whether the balls are crowded: far more of them meet than in molecules, and the boundary would take too long for
 * a picture, for each ball about the square of the number of its neighbours. False: memory is short. */
static bool find_crowd(const struct geometry *geometry, uint32_t balls, bool *crowded, struct failure *failure) {
  uint32_t *first = calloc((size_t)balls + 1, sizeof *first);
  if (first == NULL) return failure_of_memory(failure);
  uint32_t ids = 0;
  const int32_t status = hsp_query_pairs(geometry->work.model, 0, first, NULL, 0, &ids);
  double squares = 0.0;
  for (uint32_t i = 0; i < balls; ++i) {
    const double neighbours = (double)first[i + 1] - (double)first[i];
    squares += neighbours * neighbours;
  }
  *crowded = status == HSP_E_RANGE || squares > 5e9;
  free(first);
  return status == HSP_OK || status == HSP_E_CAPACITY || status == HSP_E_RANGE || failure_in_library(failure, status);
}

/* Add to exposure the free part of each ball's area when a probe is added to all radii, times the weight. With a limit,
 * *crowded may be set instead. */
static bool add_free_part(const struct molecule *molecule, double probe, double weight, bool limited, double *area,
                          double *exposure, bool *crowded, struct failure *failure) {
  struct geometry inflated = {.work = {0}};
  bool done = geometry_set_model(&inflated, molecule, probe, 0.0, failure);
  if (done && limited) done = find_crowd(&inflated, molecule->atoms, crowded, failure);
  if (done && *crowded) {
    geometry_free(&inflated);
    return true;
  }
  done = done && geometry_compute_boundary(&inflated, failure);
  if (done) {
    const int32_t status = hsp_boundary_measure(inflated.work.boundary, NULL, NULL, area, NULL, molecule->atoms, NULL);
    done = status == HSP_OK || failure_in_library(failure, status);
  }
  geometry_free(&inflated);
  for (uint32_t i = 0; done && i < molecule->atoms; ++i) {
    const double radius = molecule->radius[i] + probe;
    exposure[i] += weight * (area[i] / (4.0 * pi * radius * radius));
  }
  return done;
}

/* The balls near a ball, in memory that grows. */
struct neighbourhood {
  uint32_t *ids;
  uint32_t count;
  uint32_t capacity;
};

static bool find_neighbourhood(const struct geometry *geometry, const double xyz[3], double radius,
                               struct neighbourhood *near, struct failure *failure) {
  for (;;) {
    const int32_t status = hsp_query_ball(geometry->work.model, xyz, radius, near->ids, near->capacity, &near->count);
    if (status == HSP_OK) return true;
    if (status != HSP_E_CAPACITY) return failure_in_library(failure, status);
    near->capacity = near->count + near->count / 2;
    free(near->ids);
    near->ids = malloc(near->capacity * sizeof *near->ids);
    if (near->ids == NULL) return failure_of_memory(failure);
  }
}

/* (1 - (d/reach)^2)^3 falls off as exp(-3 (d/reach)^2) does, and reaches 0. */
static double weight_at(const double a[3], const double b[3], double radius) {
  double part = 1.0;
  for (int axis = 0; axis < 3; ++axis) part -= (a[axis] - b[axis]) / radius * ((a[axis] - b[axis]) / radius);
  return part > 0.0 ? part * part * part : 0.0;
}

/* Sums of whole numbers do not depend on the order of their terms. */
static int64_t whole(double part) {
  return (int64_t)(part * 1099511627776.0 + 0.5); /* 2^40: room for millions of neighbours */
}

/* The mean of all balls that near, with weights that fall off, or even ones. */
static bool smooth(const struct molecule *molecule, const struct geometry *geometry, double radius, bool even,
                   const double *from, double *to, struct neighbourhood *near, struct failure *failure) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const double *centre = molecule->xyz + 3 * (size_t)i;
    if (!find_neighbourhood(geometry, centre, radius, near, failure)) return false;
    int64_t sum = 0;
    int64_t weights = 0;
    for (uint32_t k = 0; k < near->count; ++k) {
      const double weight = even ? 1.0 : weight_at(centre, molecule->xyz + 3 * (size_t)near->ids[k], radius);
      sum += whole(weight * from[near->ids[k]]);
      weights += whole(weight);
    }
    to[i] = weights == 0 ? from[i] : (double)sum / (double)weights;
  }
  return true;
}

/* Make exposures relative to the most exposed balls: 1 for these, 0 for balls that no probe reaches. */
static bool normalise(double *exposure, uint32_t count, struct failure *failure) {
  const double least = least_exposure_of_few * (1.0 - ramp(count, FEW, NOT_FEW));
  double most;
  if (!quantile(exposure, count, 0.8, &most, failure)) return false;
  for (uint32_t i = 0; i < count; ++i) {
    double part = most > 0.0 ? exposure[i] / most : 1.0;
    if (part > 1.0) part = 1.0;
    exposure[i] = least + (1.0 - least) * part;
  }
  return true;
}

/* The limits of the library's lattice: below its finest step balls are points, and balls larger than the limit are
 * refused. Probes must stay within them, too. */
static const double finest_step = 1e-22;
static const double largest_ball = 1e31;

/* Lengths are relative to this: 1 in angstrom. 0, nothing to shade, where most balls are points, or where the largest
 * probe makes balls too large. */
static bool find_scale(const struct molecule *molecule, double probe, double *scale, struct failure *failure) {
  double largest;
  if (!quantile(molecule->radius, molecule->atoms, 0.8, scale, failure)) return false;
  if (!quantile(molecule->radius, molecule->atoms, 1.0, &largest, failure)) return false;
  *scale = (*scale + probe) / carbon_radius;
  if (*scale < finest_step || largest + probe + largest_probe * *scale > largest_ball) *scale = 0.0;
  return true;
}

static bool find_exposure(const struct molecule *molecule, const struct geometry *geometry, double probe, double scale,
                          bool limited, double *exposure, double *scratch, bool *crowded, struct failure *failure) {
  for (int i = 0; i < PROBE_RULES; ++i) {
    const double weight = probe_weight(&probe_rules[i], molecule->atoms);
    const double grown = probe + probe_rules[i].probe * scale;
    if (weight == 0.0) continue;
    if (!add_free_part(molecule, grown, weight, limited, scratch, exposure, crowded, failure)) return false;
    if (*crowded) return true;
  }
  struct neighbourhood near = {NULL, 0, 0};
  bool done = true;
  for (int even = 0; even <= 1; ++even) {
    const double radius = (even == 1 ? bond : reach) * scale;
    done = done && smooth(molecule, geometry, radius, even == 1, exposure, scratch, &near, failure) &&
           smooth(molecule, geometry, radius, even == 1, scratch, exposure, &near, failure);
  }
  done = done && normalise(exposure, molecule->atoms, failure);
  free(near.ids);
  return done;
}

static uint32_t mixed(uint32_t channel, double factor, double offset, double darkness) {
  const double light = channel / 255.0;
  const double value = light + darkness * (factor * light + offset - light);
  return (uint32_t)(255.0 * value + 0.5);
}

/* Shades are a little cool: blue falls off less than red and green. */
static uint32_t darkened(uint32_t colour, double darkness) {
  return mixed(colour >> 16 & 0xFF, 0.42, 0.03, darkness) << 16 | mixed(colour >> 8 & 0xFF, 0.40, 0.03, darkness) << 8 |
         mixed(colour & 0xFF, 0.46, 0.06, darkness);
}

bool occlusion_darken(const struct molecule *molecule, const struct geometry *geometry, double probe, double *strength,
                      bool limited, uint32_t *colour, struct failure *failure) {
  double scale = 0.0;
  bool crowded = false;
  if (*strength == 0.0) return true;
  if (molecule->atoms >= 2 && !find_scale(molecule, probe, &scale, failure)) return false;
  if (scale == 0.0) {
    *strength = 0.0;
    return true;
  }
  double *exposure = calloc(molecule->atoms, sizeof *exposure);
  double *scratch = calloc(molecule->atoms, sizeof *scratch);
  bool done = exposure != NULL && scratch != NULL;
  if (!done) failure_of_memory(failure);
  done = done && find_exposure(molecule, geometry, probe, scale, limited, exposure, scratch, &crowded, failure);
  for (uint32_t i = 0; done && !crowded && i < molecule->atoms; ++i) {
    const double hidden = 1.0 - exposure[i];
    const double curved = hidden * (0.87 + 0.13 * hidden); /* within 0.01 of hidden^1.1 */
    const int shade = (int)(curved * SHADES + 0.5);
    colour[i] = darkened(colour[i], *strength * shade / SHADES);
  }
  if (crowded) *strength = 0.0;
  free(exposure);
  free(scratch);
  return done;
}
