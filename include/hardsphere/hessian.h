/* hardsphere/hessian.h: second derivatives of areas and of the volume by centres.
 *
 * Guide: smooth_energies.md, questions.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * The second derivatives are those of the energy E = tension * sum_i sigma_i A_i + pressure * V (hardsphere/gradient.h)
 * as a function of all centres. Two balls have a block of 3x3 derivatives if their spheres share a free piece of a
 * circle; all other blocks are 0.
 *   - V has bounded second derivatives except where centres coincide: at most 2 pi r_i r_j / d for centres at distance
 *     d. They jump where two spheres begin to touch.
 *   - Second derivatives of the area are unbounded: just after an arc has appeared they grow as the inverse square root
 *     of the depth to which its circle is free; they jump where a fourth sphere comes through a vertex. A minimiser
 *     that needs bounded ones takes two volumes, (V(r + w sigma) - V(r - w sigma)) / (2 w). That is the mean of the
 *     weighted area over a window of radii, which is continuously differentiable with bounded second derivatives
 *     (guide: smooth_energies.md).
 * Radii include the probe. The lattice's rounding is not differentiated. To first order gradient + Hessian * (centres -
 * rounded centres) is the gradient at the centres as given, with the rounded centres of hsp_model_get_balls. */
#ifndef HARDSPHERE_HESSIAN_H
#define HARDSPHERE_HESSIAN_H

#include "gradient.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A vertex of the ball lies in the plane of the centres of its three balls: the area's second derivatives do not exist
 *  there, and the terms of this vertex are left out. Second derivatives of the volume are right. */
#define HSP_HESSIAN_SINGULAR UINT32_C(2)

/** The second derivatives of the energy E by the centres, as compressed rows of 3x3 blocks: the row of ball i has the
 *  entries first[i] to first[i + 1] - 1. ball [needed] holds the columns j, ascending in each row, i among them; block
 *  [needed][3][3] holds d2E/dc_i dc_j, rows by the components of c_i. A ball without a face has no entry. first and
 *  ball are those of hsp_boundary_get_area_rows. first [n + 1] begins with 0 and ends with the number of all entries;
 *  *needed becomes the same number. first is written on HSP_OK and on HSP_E_CAPACITY: with capacity 0 this function
 *  only counts. flags [n + 1] may be NULL; else each ball's entry becomes a sum of HSP_GRADIENT_ONE_SIDED, for balls
 *  that touch (hardsphere/gradient.h), and HSP_HESSIAN_SINGULAR, which needs a tension, or 0; flags[n] becomes the
 *  bitwise or of all. request may be NULL: all defaults, and all blocks are 0.
 *  - Property 1: block (j, i) is block (i, j) transposed, bit for bit.
 *  - Property 2: the blocks of a row sum to 0, and H (w x c) = w x g for every vector w and the gradient g, up to
 *    rounding: E does not change under motions. Rows of balls with HSP_HESSIAN_SINGULAR are excepted.
 *  - Property 3: of the volume alone H c = 2 dV/dc - (d/dc) sum_i r_i A_i, up to rounding: V is of degree 3 in centres
 *    and radii, and its mixed derivatives d2V/dr_i dc_j are dA_i/dc_j, the area rows.
 *  - Property 4: block and flags do not depend on the order of the balls, except of equal balls, nor on the executor,
 *    bit for bit.
 *
 *  Accuracy: about 1e-12 of the sum of the magnitudes of a row's terms, and mostly 1e-14, however near to a tie. Where
 *  a third ball cuts a circle of small radius rho, terms of the area are as large as (r / rho)^2, and may cancel.
 *  Cost: O(n + vertices + circles), times the logarithm of the arcs on a ball: about three gradients. With flags, also
 *  a look around each ball that lies in another.
 *  @retval HSP_OK            all rows are there; or there is no entry, also with capacity 0
 *  @retval HSP_E_ARGUMENT    boundary or first is NULL; ball or block is NULL with a capacity above 0; unknown
 *                            tangency; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than the number of entries: first and *needed are set, nothing else
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since; of selected balls
 *  @retval HSP_E_NOT_FINITE  a sigma, tension or pressure is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_get_hessian_rows(const hsp_boundary *boundary,
                                                       const hsp_gradient_request *request, uint32_t *first,
                                                       uint32_t *ball, double *block, uint32_t *flags,
                                                       uint32_t capacity, uint32_t *needed);

/** product [n][3] becomes the Hessian H of E times direction [n][3], without storing H. Each row comes from the arcs on
 *  its own ball alone. So for a boundary of selected balls the product has the selected balls' rows, and zeros in the
 *  others; direction holds all balls. flags [n] may be NULL and else becomes the flags of each ball as above. request
 *  may be NULL: all defaults, and the product is 0. *needed becomes n.
 *  - Property 1: it is the product with the rows of hsp_boundary_get_hessian_rows, up to rounding, except of balls with
 *    HSP_HESSIAN_SINGULAR.
 *  - Property 2: product and flags do not depend on the order of the balls, except of equal balls, nor on the executor,
 *    nor on which other balls are selected, bit for bit; but the flag of a selected ball that equals one that is not
 *    selected may be set although it need not be.
 *
 *  Cost: O(n + vertices + circles): about three and a half gradients.
 *  @retval HSP_E_ARGUMENT    boundary or direction is NULL, or product with a capacity above 0; unknown tangency; an
 *                            executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    capacity < n
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  a sigma, tension, pressure or component of direction is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_get_hessian_product(const hsp_boundary *boundary,
                                                          const hsp_gradient_request *request, const double *direction,
                                                          double *product, uint32_t *flags, uint32_t capacity,
                                                          uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
