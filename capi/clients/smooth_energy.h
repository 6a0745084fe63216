/* A smooth surface energy for minimisers and frequencies: the mean of S = sum of sigma_i A_i over a window of radii
 * R + s sigma, -w <= s <= w, which is W = (V(R + w sigma) - V(R - w sigma)) / 2w, with its gradient and second
 * derivatives. It is continuously differentiable with bounded second derivatives (capi/guide/smooth_energies.md).
 * Without a window it is S itself. The lattice's rounding is undone to second order. C99 and C++. */
#ifndef SMOOTH_ENERGY_H
#define SMOOTH_ENERGY_H

#include <hardsphere_workspace.h>

/** All zeros at first but for the first four, which the caller sets. */
typedef struct smooth_energy {
  double window;         /**< w, length, for weights of about 1; 0 for S itself */
  const double *sigma;   /**< [n], or NULL for all ones: constant weights */
  double step;           /**< of the lattice, the same for both sets: 1e-8 does for molecules in angstroms */
  double largest_radius; /**< at least the largest of R + w |sigma| */
  uint32_t n, sets;      /**< of the last smooth_energy_set; one set without a window, else two */
  hsp_workspace set[2];
  double *radius;               /**< [n] of one set */
  double *off, *product, *part; /**< [n][3]: the caller's centres less the rounded ones; scratch */
} smooth_energy;

static inline void smooth_energy_free(smooth_energy *s) {
  hsp_workspace_free(&s->set[0]);
  hsp_workspace_free(&s->set[1]);
  free(s->radius);
  s->radius = s->off = s->product = s->part = NULL;
  s->n = 0;
}

/** The question of one of the sets: their sum is the energy. */
static inline hsp_gradient_request smooth_energy_request(const smooth_energy *s, uint32_t which) {
  hsp_gradient_request request;
  hsp_gradient_request_init(&request, sizeof request);
  if (s->sets == 1) {
    request.tension = 1;
    request.sigma = s->sigma;
  } else {
    request.pressure = (which == 0 ? 0.5 : -0.5) / s->window;
  }
  return request;
}

/** Computes the boundaries of balls with centres xyz [n][3] and radii [n], probe included. */
static inline int32_t smooth_energy_set(smooth_energy *s, uint32_t n, const double *xyz, const double *radius) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  uint32_t which, i;
  if (n != s->n || s->radius == NULL) {
    free(s->radius);
    s->radius = (double *)malloc(10 * ((size_t)n + 1) * sizeof(double));
    if (s->radius == NULL) {
      smooth_energy_free(s);
      return HSP_E_MEMORY;
    }
    s->n = n;
    s->off = s->radius + n;
    s->product = s->off + 3 * (size_t)n;
    s->part = s->product + 3 * (size_t)n;
  }
  s->sets = s->window > 0 ? 2 : 1;
  options.step = s->step;
  options.largest_radius = s->largest_radius;
  for (which = 0; which < s->sets && status == HSP_OK; ++which) {
    for (i = 0; i < n; ++i) {
      const double grown = radius[i] + (which == 0 ? s->window : -s->window) * (s->sigma == NULL ? 1 : s->sigma[i]);
      if (radius[i] < 0 || s->window < 0) return HSP_E_NEGATIVE;
      s->radius[i] = grown < 0 ? 0 : grown; /* NaN stays, and is refused */
    }
    status = hsp_workspace_set(&s->set[which], n, xyz, s->radius, &options, NULL);
    if (status == HSP_OK) status = hsp_workspace_boundary(&s->set[which]);
  }
  if (status == HSP_OK) status = hsp_model_get_balls(s->set[0].model, s->off, NULL, n, NULL);
  for (i = 0; i < 3 * n && status == HSP_OK; ++i) s->off[i] = xyz[i] - s->off[i];
  return status;
}

/** product [n][3] becomes the second derivatives times direction [n][3]. */
static inline int32_t smooth_energy_product(smooth_energy *s, const double *direction, double *product) {
  int32_t status = HSP_OK;
  uint32_t which, k;
  for (k = 0; k < 3 * s->n; ++k) product[k] = 0;
  for (which = 0; which < s->sets && status == HSP_OK; ++which) {
    const hsp_gradient_request request = smooth_energy_request(s, which);
    status = hsp_boundary_get_hessian_product(s->set[which].boundary, &request, direction, s->part, NULL, s->n, NULL);
    for (k = 0; k < 3 * s->n && status == HSP_OK; ++k) product[k] += s->part[k];
  }
  return status;
}

/** *value and gradient [n][3] at the caller's centres. */
static inline int32_t smooth_energy_gradient(smooth_energy *s, double *value, double *gradient) {
  int32_t status = smooth_energy_product(s, s->off, s->product);
  uint32_t which, k;
  *value = 0;
  for (k = 0; k < 3 * s->n; ++k) gradient[k] = 0;
  for (which = 0; which < s->sets && status == HSP_OK; ++which) {
    const hsp_gradient_request request = smooth_energy_request(s, which);
    hsp_gradient_outputs outputs;
    hsp_energy energy;
    memset(&outputs, 0, sizeof outputs);
    outputs.struct_size = sizeof outputs;
    outputs.capacity = s->n;
    outputs.energy = &energy;
    outputs.d_centre = s->part;
    status = hsp_boundary_get_gradient(s->set[which].boundary, &request, &outputs);
    if (status == HSP_OK) *value += energy.value;
    for (k = 0; k < 3 * s->n && status == HSP_OK; ++k) gradient[k] += s->part[k];
  }
  for (k = 0; k < 3 * s->n; ++k) {
    *value += s->off[k] * (gradient[k] + s->product[k] / 2);
    gradient[k] += s->product[k];
  }
  return status;
}

/** The second derivatives as a symmetric matrix [3n][3n], added to what is there. */
static inline int32_t smooth_energy_add_matrix(const smooth_energy *s, double factor, double *matrix) {
  const size_t row = 3 * (size_t)s->n;
  int32_t status = HSP_OK;
  uint32_t which;
  for (which = 0; which < s->sets && status == HSP_OK; ++which) {
    const hsp_gradient_request request = smooth_energy_request(s, which);
    const hsp_boundary *const boundary = s->set[which].boundary;
    uint32_t *const first = (uint32_t *)malloc(((size_t)s->n + 1) * sizeof *first);
    uint32_t *ball = NULL, entries = 0, i, k, p, q;
    double *block = NULL;
    if (first == NULL) return HSP_E_MEMORY;
    hsp_boundary_get_hessian_rows(boundary, &request, first, NULL, NULL, NULL, 0, &entries);
    ball = (uint32_t *)malloc(((size_t)entries + 1) * sizeof *ball);
    block = (double *)malloc((9 * (size_t)entries + 1) * sizeof *block);
    status = ball == NULL || block == NULL
                 ? HSP_E_MEMORY
                 : hsp_boundary_get_hessian_rows(boundary, &request, first, ball, block, NULL, entries, &entries);
    for (i = 0; i < s->n && status == HSP_OK; ++i)
      for (k = first[i]; k < first[i + 1]; ++k)
        for (p = 0; p < 3; ++p)
          for (q = 0; q < 3; ++q)
            matrix[(3 * (size_t)i + p) * row + 3 * ball[k] + q] += factor * block[9 * (size_t)k + 3 * p + q];
    free(first);
    free(ball);
    free(block);
  }
  return status;
}

#endif
