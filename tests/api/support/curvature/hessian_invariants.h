/* The second derivatives of any computed set as the interface gives them, and their invariants. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct hessian {
  uint32_t n, entries;
  uint32_t *first; /* [n + 1] */
  uint32_t *ball;
  double *block;
  uint32_t *flags;
} hessian;

/* Counts, then lists. The status; ends the program if there is no memory. To be followed by hessian_release. */
int32_t hessian_make(const computed *c, const hsp_gradient_request *request, hessian *result);
void hessian_release(hessian *result);

/* The block of two balls, or NULL if it is not there. */
const double *hessian_block(const hessian *h, uint32_t i, uint32_t j);

/* Checks properties 1 to 3 of hsp_boundary_get_hessian_rows, that there are blocks for just the entries of the area
 * rows, that flags agree with those of the gradient, and that hsp_boundary_get_hessian_product is the product with the
 * rows. sigma: [n], or NULL for all ones. Returns NULL, or a sentence about the first check that does not hold. */
const char *broken_hessian(const computed *c, const double *sigma, double tension, double pressure, uint32_t tangency);

/* Property 4, for weights of one: ball i of c is ball place[i] of `other`, and the derivatives are the same. */
const char *hessian_difference_after_permutation(const computed *c, const computed *other, const uint32_t *place,
                                                 uint32_t tangency);

#ifdef __cplusplus
}
#endif
