#include "gradients.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int32_t gradients_make(const computed *c, const double *sigma, double tension, double pressure, uint32_t tangency,
                       gradients *result) {
  memset(result, 0x5A, sizeof *result);
  return hsp_boundary_gradient(c->boundary, sigma, tension, pressure, tangency, &result->energy, result->centre,
                               result->radius, result->flags, c->n);
}

int32_t jacobian_make(const computed *c, uint32_t tangency, jacobian *result) {
  int32_t status = HSP_OK;
  uint32_t i;
  result->n = c->n;
  result->entries = calloc((size_t)c->n * c->n + 1, sizeof *result->entries);
  result->length = calloc((size_t)c->n + 1, sizeof *result->length);
  if (result->entries == NULL || result->length == NULL) exit(2);
  for (i = 0; i < c->n && status == HSP_OK; ++i) {
    status = hsp_boundary_get_area_row(c->boundary, i, tangency, result->entries + (size_t)i * c->n, c->n,
                                       &result->length[i]);
  }
  return status;
}

void jacobian_release(jacobian *result) {
  free(result->entries);
  free(result->length);
}

const hsp_area_derivative *jacobian_entry(const jacobian *all, uint32_t i, uint32_t j) {
  const hsp_area_derivative *row = all->entries + (size_t)i * all->n;
  uint32_t k;
  for (k = 0; k < all->length[i]; ++k) {
    if (row[k].ball == j) return row + k;
  }
  return NULL;
}

static long long steps(double value, double step) {
  return (long long)floor(value / step + 0.5);
}

int spheres_touch(const ball_set *set, uint32_t i, uint32_t j) {
  const long long r = steps(set->radius[i], set->step), s = steps(set->radius[j], set->step);
  /* Compared as distance^2 - (r - s)^2 = 4 r s or 0, modulo 2^64, which decides as both sides are far below that. */
  unsigned long long squared = 0, difference = (unsigned long long)(r - s) * (unsigned long long)(r - s);
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const long long d =
        steps(set->xyz[3 * i + (uint32_t)axis], set->step) - steps(set->xyz[3 * j + (uint32_t)axis], set->step);
    /* farther apart than any two radii reach */
    if (d > (1LL << 31) || d < -(1LL << 31)) return 0;
    squared += (unsigned long long)d * (unsigned long long)d;
  }
  return squared == difference || squared - difference == 4 * (unsigned long long)r * (unsigned long long)s;
}
