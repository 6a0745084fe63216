#include "hessian_invariants.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gradient_invariants.h"
#include "random_numbers.h"
#include "vectors.h"

int32_t hessian_make(const computed *c, const hsp_gradient_request *request, hessian *result) {
  int32_t status;
  result->n = c->n;
  result->entries = 0;
  result->first = test_zeros(c->n + 1, sizeof *result->first);
  result->ball = NULL;
  result->block = NULL;
  result->flags = test_zeros(c->n + 1, sizeof *result->flags);
  status = hsp_boundary_get_hessian_rows(c->boundary, request, result->first, NULL, NULL, NULL, 0, &result->entries);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return status;
  result->ball = test_zeros(result->entries + 1, sizeof *result->ball);
  result->block = test_zeros(9 * ((size_t)result->entries + 1), sizeof *result->block);
  return hsp_boundary_get_hessian_rows(c->boundary, request, result->first, result->ball, result->block, result->flags,
                                       result->entries, &result->entries);
}

void hessian_release(hessian *result) {
  free(result->first);
  free(result->ball);
  free(result->block);
  free(result->flags);
}

const double *hessian_block(const hessian *h, uint32_t i, uint32_t j) {
  uint32_t k;
  for (k = h->first[i]; k < h->first[i + 1]; ++k)
    if (h->ball[k] == j) return h->block + 9 * (size_t)k;
  return NULL;
}

/* Centres as they are on the lattice, which is where derivatives are taken. */
static double *rounded_centres(const computed *c) {
  double *xyz = test_zeros(3 * (size_t)c->n + 1, sizeof *xyz);
  CHECK_EQUAL(hsp_model_get_balls(c->model, xyz, NULL, c->n, NULL), HSP_OK);
  return xyz;
}

static const char *broken_pattern(const computed *c, const hsp_gradient_request *request, const hessian *h) {
  const hsp_derivatives_request areas = {
      .struct_size = sizeof areas, .tangency = request->tangency, .sigma = request->sigma};
  uint32_t *first = test_zeros(c->n + 1, sizeof *first), *ball = test_zeros(h->entries + 1, sizeof *ball);
  double *centre = test_zeros(3 * ((size_t)h->entries + 1), sizeof *centre);
  const char *broken = NULL;
  if (hsp_boundary_get_area_rows(c->boundary, &areas, first, ball, centre, NULL, h->entries, NULL) != HSP_OK)
    broken = "hsp_boundary_get_area_rows: not HSP_OK with room for as many entries";
  else if (memcmp(first, h->first, (c->n + 1) * sizeof *first) != 0 ||
           memcmp(ball, h->ball, h->entries * sizeof *ball) != 0)
    broken = "hsp_boundary_get_hessian_rows: other entries than area rows";
  free(first);
  free(ball);
  free(centre);
  return broken;
}

static const char *broken_symmetry(const hessian *h) {
  uint32_t i, k, p, q;
  for (i = 0; i < h->n; ++i) {
    for (k = h->first[i]; k < h->first[i + 1]; ++k) {
      const double *const there = h->block + 9 * (size_t)k, *const back = hessian_block(h, h->ball[k], i);
      if (back == NULL) return "a block without its transpose";
      for (p = 0; p < 3; ++p)
        for (q = 0; q < 3; ++q)
          if (there[3 * p + q] != back[3 * q + p]) return "hsp_boundary_get_hessian_rows, property 1: symmetry";
    }
  }
  return NULL;
}

/* Whether row i times x [n][3] is `expected`, to 1e-12 of the sizes of all terms and of `size`, which bounds terms that
 * cancel within a block. */
static int row_gives(const hessian *h, uint32_t i, const double *x, const double expected[3], double size) {
  double sum[3] = {-expected[0], -expected[1], -expected[2]};
  uint32_t k, p, q;
  for (k = h->first[i]; k < h->first[i + 1]; ++k) {
    for (p = 0; p < 3; ++p) {
      for (q = 0; q < 3; ++q) {
        const double term = h->block[9 * (size_t)k + 3 * p + q] * x[3 * h->ball[k] + q];
        sum[p] += term;
        size += fabs(term);
      }
    }
  }
  return near(sum[0], 0, 1e-12 * size) && near(sum[1], 0, 1e-12 * size) && near(sum[2], 0, 1e-12 * size);
}

/* A bound for the terms that cancel within the block of balls i and j at distance d. The volume has terms of 2 pi r_i
 * r_j / d, for which 7 (r_i + r_j)^2 / d is taken, as terms remain that cancel if a radius is 0. The area has the
 * change of these terms as radii grow by their weights: the ends of arcs on a circle of small radius rho move by (r /
 * rho)^2. If a vertex is near the plane of its centres there are larger terms, but the block's own entries show
 * them. */
static double size_of_terms(const computed *c, const hsp_gradient_request *request, uint32_t i, uint32_t j) {
  const double own = c->radius[i], other = c->radius[j], sum = own + other;
  const double growth = request->sigma == NULL ? sum : own * fabs(request->sigma[i]) + other * fabs(request->sigma[j]);
  double off[3], distance, square, ends;
  difference(c->xyz + 3 * j, c->xyz + 3 * i, off);
  distance = length(off);
  square = (sum - distance) * (sum + distance) * (distance - own + other) * (distance + own - other) /
           (4 * distance * distance);
  ends = square > 0 ? own * other / square : 0;
  return 7 * fabs(request->pressure) * sum * sum / distance +
         7 * fabs(request->tension) * growth / distance * (1 + sum / distance + ends);
}

static double size_of_row(const computed *c, const hessian *h, const hsp_gradient_request *request, uint32_t i) {
  double size = 0;
  uint32_t k, p;
  for (k = h->first[i]; k < h->first[i + 1]; ++k) {
    for (p = 0; p < 9; ++p) size += fabs(h->block[9 * (size_t)k + p]);
    if (h->ball[k] != i) size += size_of_terms(c, request, i, h->ball[k]);
  }
  return size;
}

typedef struct laws {
  const computed *c;
  const hsp_gradient_request *request;
  const hessian *h;
  double *centre;   /* [n][3] */
  double *gradient; /* [n][3] of E */
  double *vector;   /* [n][3] */
} laws;

static const char *broken_motions(const laws *l) {
  uint32_t axis, i;
  for (axis = 0; axis < 3; ++axis) {
    const double turn[3] = {axis == 0, axis == 1, axis == 2}, none[3] = {0, 0, 0};
    for (i = 0; i < l->c->n; ++i) memcpy(l->vector + 3 * i, turn, sizeof turn);
    for (i = 0; i < l->c->n; ++i) {
      if ((l->h->flags[i] & HSP_HESSIAN_SINGULAR) == 0 &&
          !row_gives(l->h, i, l->vector, none, size_of_row(l->c, l->h, l->request, i)))
        return "hsp_boundary_get_hessian_rows, property 2: sums of rows";
    }
    for (i = 0; i < l->c->n; ++i) cross(turn, l->centre + 3 * i, l->vector + 3 * i);
    for (i = 0; i < l->c->n; ++i) {
      const double size = (1 + l->c->extent) *
                          (size_of_row(l->c, l->h, l->request, i) + l->c->radius[i] * (fabs(l->request->tension) + 1));
      double turned[3];
      cross(turn, l->gradient + 3 * i, turned);
      if ((l->h->flags[i] & HSP_HESSIAN_SINGULAR) == 0 && !row_gives(l->h, i, l->vector, turned, size))
        return "hsp_boundary_get_hessian_rows, property 2: rotations";
    }
  }
  return NULL;
}

/* V is of degree 3 in centres and radii, so its gradient is of degree 2: H c + (d/dc) sum r_i A_i = 2 dV/dc. */
static const char *broken_dilation(const laws *l) {
  const computed *c = l->c;
  double *by_radii = test_zeros(3 * (size_t)c->n + 1, sizeof *by_radii);
  double *radius = test_zeros(c->n + 1, sizeof *radius);
  const hsp_gradient_request areas = {
      .struct_size = sizeof areas, .tangency = l->request->tangency, .tension = l->request->pressure, .sigma = radius};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = c->n, .d_centre = by_radii};
  const char *broken = NULL;
  uint32_t i, axis;
  CHECK_EQUAL(hsp_model_get_balls(c->model, NULL, radius, c->n, NULL), HSP_OK);
  if (hsp_boundary_get_gradient(c->boundary, &areas, &outputs) != HSP_OK)
    broken = "hsp_boundary_get_gradient: not HSP_OK";
  for (i = 0; i < c->n && broken == NULL; ++i) {
    const double size = (1 + c->extent) * (size_of_row(c, l->h, l->request, i) +
                                           fabs(l->request->pressure) * c->radius[i] * (1 + c->radius[i]));
    double expected[3];
    for (axis = 0; axis < 3; ++axis) expected[axis] = 2 * l->gradient[3 * i + axis] - by_radii[3 * i + axis];
    if (!row_gives(l->h, i, l->centre, expected, size))
      broken = "hsp_boundary_get_hessian_rows, property 3: the volume is of degree 3";
  }
  free(by_radii);
  free(radius);
  return broken;
}

static const char *broken_product(const laws *l) {
  const computed *c = l->c;
  double *product = test_zeros(3 * (size_t)c->n + 1, sizeof *product);
  uint32_t *flags = test_zeros(c->n + 1, sizeof *flags);
  uint64_t seed = 7;
  const char *broken = NULL;
  uint32_t i, needed;
  for (i = 0; i < 3 * c->n; ++i) l->vector[i] = random_fraction(&seed) - 0.5;
  if (hsp_boundary_get_hessian_product(c->boundary, l->request, l->vector, product, flags, c->n, &needed) != HSP_OK ||
      needed != c->n)
    broken = "hsp_boundary_get_hessian_product: not HSP_OK";
  else if (memcmp(flags, l->h->flags, c->n * sizeof *flags) != 0)
    broken = "hsp_boundary_get_hessian_product: other flags than of rows";
  for (i = 0; i < c->n && broken == NULL; ++i) {
    if ((flags[i] & HSP_HESSIAN_SINGULAR) == 0 &&
        !row_gives(l->h, i, l->vector, product + 3 * i, size_of_row(c, l->h, l->request, i)))
      broken = "hsp_boundary_get_hessian_product, property 1: the product with rows";
  }
  free(product);
  free(flags);
  return broken;
}

const char *broken_hessian(const computed *c, const double *sigma, double tension, double pressure, uint32_t tangency) {
  const hsp_gradient_request request = {
      .struct_size = sizeof request, .tangency = tangency, .tension = tension, .pressure = pressure, .sigma = sigma};
  uint32_t *flags = test_zeros(c->n + 1, sizeof *flags), all = 0;
  laws l = {c, &request, NULL, rounded_centres(c), NULL, NULL};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = c->n, .flags = flags};
  const char *broken = NULL;
  hessian h;
  uint32_t i;
  l.h = &h;
  l.gradient = test_zeros(3 * (size_t)c->n + 1, sizeof *l.gradient);
  l.vector = test_zeros(3 * (size_t)c->n + 1, sizeof *l.vector);
  outputs.d_centre = l.gradient;
  if (hessian_make(c, &request, &h) != HSP_OK) broken = "hsp_boundary_get_hessian_rows: not HSP_OK";
  if (broken == NULL && hsp_boundary_get_gradient(c->boundary, &request, &outputs) != HSP_OK)
    broken = "hsp_boundary_get_gradient: not HSP_OK";
  for (i = 0; i < c->n && broken == NULL; ++i) {
    if ((h.flags[i] & ~(HSP_GRADIENT_ONE_SIDED | HSP_HESSIAN_SINGULAR)) != 0 ||
        (h.flags[i] & HSP_GRADIENT_ONE_SIDED) != flags[i])
      broken = "hsp_boundary_get_hessian_rows: flags that are not the gradient's";
    all |= h.flags[i];
  }
  if (broken == NULL && h.flags[c->n] != all) broken = "hsp_boundary_get_hessian_rows: flags of all balls together";
  if (broken == NULL) broken = broken_pattern(c, &request, &h);
  if (broken == NULL) broken = broken_symmetry(&h);
  if (broken == NULL) broken = broken_motions(&l);
  if (broken == NULL && tension == 0) broken = broken_dilation(&l);
  if (broken == NULL) broken = broken_product(&l);
  hessian_release(&h);
  free(flags);
  free(l.centre);
  free(l.gradient);
  free(l.vector);
  return broken;
}

const char *hessian_difference_after_permutation(const computed *c, const computed *other, const uint32_t *place,
                                                 uint32_t tangency) {
  const hsp_gradient_request request = {
      .struct_size = sizeof request, .tangency = tangency, .tension = 1.5, .pressure = -0.25};
  const char *broken = NULL;
  hessian here, there;
  uint32_t i, k;
  const int32_t status = hessian_make(c, &request, &here), other_status = hessian_make(other, &request, &there);
  if (status != HSP_OK || other_status != HSP_OK) broken = "hsp_boundary_get_hessian_rows: not HSP_OK";
  for (i = 0; i < c->n && broken == NULL; ++i) {
    if (here.flags[i] != there.flags[place[i]])
      broken = "hsp_boundary_get_hessian_rows, property 4: flags by the order";
    else if (here.first[i + 1] - here.first[i] != there.first[place[i] + 1] - there.first[place[i]])
      broken = "hsp_boundary_get_hessian_rows, property 4: the number of blocks by the order of the balls";
    for (k = here.first[i]; k < here.first[i + 1] && broken == NULL; ++k) {
      const double *const block = hessian_block(&there, place[i], place[here.ball[k]]);
      if (block == NULL || memcmp(block, here.block + 9 * (size_t)k, 9 * sizeof *block) != 0)
        broken = "hsp_boundary_get_hessian_rows, property 4: blocks by the order of the balls";
    }
  }
  hessian_release(&here);
  hessian_release(&there);
  return broken;
}
