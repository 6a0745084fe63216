/* The rows of the areas' Jacobian: the promises of hsp_boundary_get_area_row for each row, the relations between rows,
 * and those to the boundary's arcs and circles and to gradients. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "gradient_invariants.h"
#include "gradients.h"
#include "vectors.h"

/* All rows, what they are compared with, and the sums of their entries. */
typedef struct row_set {
  const computed *c;
  jacobian rows;
  double *angle; /* [n][n] free angle of the circle of two balls, less than 0 if none of it is free */
  const hsp_area_derivative **find; /* [n][n] the entry for ball j in row i, or NULL */
} row_set;

static void add_angle(row_set *s, const uint32_t ball[2], double angle) {
  const size_t n = s->c->n, there = ball[0] * n + ball[1], back = ball[1] * n + ball[0];
  s->angle[there] = s->angle[back] = fmax(s->angle[there], 0) + angle;
}

static const char *row_set_make(const computed *c, uint32_t tangency, row_set *s) {
  const size_t n = c->n;
  const int32_t status = jacobian_make(c, tangency, &s->rows);
  uint32_t i, k;
  s->c = c;
  s->angle = test_zeros(n * n, sizeof *s->angle);
  s->find = test_zeros(n * n, sizeof *s->find);
  for (k = 0; k < n * n; ++k) s->angle[k] = -1;
  for (k = 0; k < c->counts.arcs; ++k) add_angle(s, c->arcs[k].ball, c->arcs[k].angle);
  for (k = 0; k < c->counts.circles; ++k) add_angle(s, c->circles[k].ball, 2 * acos(-1.0));
  if (status != HSP_OK) return "hsp_boundary_get_area_row: not HSP_OK";
  for (i = 0; i < n; ++i) {
    const hsp_area_derivative *row = s->rows.entries + i * n;
    if (s->rows.length[i] > n) return "a row longer than there are balls";
    for (k = 0; k < s->rows.length[i]; ++k) {
      if (row[k].ball >= n || (k > 0 && row[k - 1].ball >= row[k].ball)) return "a row: its balls do not ascend";
      s->find[i * n + row[k].ball] = row + k;
    }
  }
  return NULL;
}

static void row_set_release(row_set *s) {
  jacobian_release(&s->rows);
  free(s->angle);
  free((void *)s->find);
}

/* The entry for another ball. */
static const char *broken_entry(const row_set *s, uint32_t i, const hsp_area_derivative *entry) {
  const computed *c = s->c;
  const uint32_t j = entry->ball;
  const hsp_area_derivative *mirrored = s->find[(size_t)j * c->n + i];
  const double r = c->radius[i], other = c->radius[j];
  const double moved = c->rounding + 1e-16 * c->extent; /* how far the lattice's numbers are from the caller's */
  double off[3], distance, by_angle, tolerance;
  difference(c->xyz + 3 * j, c->xyz + 3 * i, off);
  distance = length(off);
  if (!(distance > 0)) return "a row: an entry for a concentric ball";
  by_angle = slope_of_arcs(c, i, j);
  tolerance = 1e-13 * by_angle + 8 * moved * (r + other + by_angle) / distance;
  if (mirrored == NULL) return "rows: an entry without its mirror image";
  if (!near(mirrored->radius, entry->radius, tolerance)) {
    return "hsp_boundary_get_area_row, property 2: dA_i/dr_j = dA_j/dr_i";
  }
  if (!near(entry->radius, -by_angle * entry->angle, tolerance * (1 + entry->angle))) {
    return "a row: the angle is not that of the derivative by the radius";
  }
  if (!near(mirrored->angle, entry->angle, 1e-13) || mirrored->flags != entry->flags) {
    return "rows: angles or flags are not symmetric";
  }
  if (entry->flags != (spheres_touch(c, i, j) ? HSP_GRADIENT_ONE_SIDED : 0)) {
    return "a row: flagged without touching, or not flagged";
  }
  /* where spheres touch, the angle that counts can be 0 */
  if (entry->flags == 0 && !near(entry->angle, s->angle[(size_t)i * c->n + j], 1e-13)) {
    return "a row: the angle is not that of the boundary's arcs";
  }
  return NULL;
}

static const char *broken_row(const row_set *s, uint32_t i) {
  const computed *c = s->c;
  const size_t n = c->n;
  const hsp_area_derivative *row = s->rows.entries + i * n, *own = s->find[i * n + i];
  double sum[3] = {0, 0, 0}, size = 0;
  uint32_t k, j, axis, one_sided = 0;
  if ((s->rows.length[i] == 0) != (c->balls[i].faces == 0))
    return "a row: empty, but not exactly for a ball without faces";
  if (s->rows.length[i] == 0) return NULL;
  if (own == NULL || own->angle != 0) return "a row: no entry for the ball itself, or one with an angle";
  for (k = 0; k < s->rows.length[i]; ++k) {
    const char *broken = row + k == own ? NULL : broken_entry(s, i, row + k);
    if (broken != NULL) return broken;
    for (axis = 0; axis < 3; ++axis) {
      sum[axis] += row[k].centre[axis];
      size += fabs(row[k].centre[axis]);
    }
    if (row + k == own) continue;
    one_sided |= row[k].flags;
    size += slope_of_arcs(c, i, row[k].ball);
  }
  if (own->flags != one_sided) return "a row: the ball's own flag is not that of its entries";
  for (axis = 0; axis < 3; ++axis) {
    if (!near(sum[axis], 0, 1e-13 * size)) {
      return "hsp_boundary_get_area_row, property 1: the derivatives by all centres add up to 0";
    }
  }
  for (j = 0; j < n; ++j) {
    if (j != i && (s->find[i * n + j] != NULL) != (s->angle[i * n + j] >= 0)) {
      return "a row: not an entry for every circle with a free piece, and for no other";
    }
  }
  return NULL;
}

/* Numbers 0 to 2: by the centre, 3: by the radius. */
static double number_of(const hsp_area_derivative *entry, uint32_t number) {
  return number < 3 ? entry->centre[number] : entry->radius;
}

/* The gradient of the areas, weighted by sigma, is the sum of the rows, weighted the same. */
static const char *broken_weighted_sum(const row_set *s, const double *sigma, uint32_t tangency) {
  const computed *c = s->c;
  const char *broken = NULL;
  const size_t n = c->n;
  double *centre = test_zeros(3 * n, sizeof *centre), *radius = test_zeros(n, sizeof *radius);
  uint32_t *flags = test_zeros(n, sizeof *flags);
  uint32_t i, j, k;
  if (hsp_boundary_get_gradient(
          c->boundary, SIZED(hsp_gradient_request, .sigma = sigma, .tension = 1, .tangency = tangency),
          SIZED(hsp_gradient_outputs, .d_centre = centre, .d_radius = radius, .flags = flags, .capacity = c->n)) !=
      HSP_OK) {
    broken = "hsp_boundary_get_gradient: not HSP_OK";
  }
  for (j = 0; j < n && broken == NULL; ++j) {
    double sum[4] = {0, 0, 0, 0}, size = c->radius[j];
    uint32_t one_sided = 0;
    for (i = 0; i < n; ++i) {
      const hsp_area_derivative *entry = s->find[i * n + j];
      const double weight = sigma == NULL ? 1 : sigma[i];
      double sizes = fabs(weight) * c->radius[i]; /* what parts of an entry may cancel to */
      if (entry == NULL) continue;
      if (i != j) sizes += fabs(weight) * slope_of_arcs(c, i, j);
      for (k = 0; k < 4; ++k) {
        sum[k] += weight * number_of(entry, k);
        sizes += fabs(weight * number_of(entry, k));
      }
      size += sizes;
      if (i == j) one_sided = entry->flags;
    }
    for (k = 0; k < 4; ++k) {
      if (!near(sum[k], k < 3 ? centre[3 * j + k] : radius[j], 1e-12 * size))
        broken = "rows do not add up to the gradient";
    }
    /* the ball's flags include the row's; they also mark balls that touch from inside */
    if ((one_sided & ~flags[j]) != 0) broken = "a flag of a row that the gradient lacks";
  }
  free(centre);
  free(radius);
  free(flags);
  return broken;
}

/* Each row on its own is the gradient of its ball's area: as above, with one weight of 1. For few balls, as that many
 * gradients are computed. */
static const char *broken_single_sums(const row_set *s, uint32_t tangency) {
  const char *broken = NULL;
  double *sigma = test_zeros(s->c->n, sizeof *sigma);
  uint32_t i;
  for (i = 0; i < s->c->n && s->c->n <= 40 && broken == NULL; ++i) {
    sigma[i] = 1;
    broken = broken_weighted_sum(s, sigma, tangency);
    sigma[i] = 0;
  }
  free(sigma);
  return broken;
}

const char *broken_area_rows(const computed *c, const double *sigma, uint32_t tangency) {
  row_set s;
  const char *broken = row_set_make(c, tangency, &s);
  uint32_t i;
  for (i = 0; i < c->n && broken == NULL; ++i) broken = broken_row(&s, i);
  if (broken == NULL) broken = broken_weighted_sum(&s, sigma, tangency);
  if (broken == NULL) broken = broken_single_sums(&s, tangency);
  row_set_release(&s);
  return broken;
}
