#include "gradients.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"

int32_t gradients_make(const computed *c, const double *sigma, double tension, double pressure, uint32_t tangency,
                       gradients *result) {
  memset(result, 0x5A, sizeof *result);
  return hsp_boundary_get_gradient(
      c->boundary,
      SIZED(hsp_gradient_request, .sigma = sigma, .tension = tension, .pressure = pressure, .tangency = tangency),
      SIZED(hsp_gradient_outputs, .energy = &result->energy, .d_centre = result->centre, .d_radius = result->radius,
            .flags = result->flags, .capacity = c->n));
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
