/* Invariants of the derivatives of areas and volume of any computed set. Each function returns NULL, or a sentence
 * about the first of them that does not hold. sigma: weights as for hsp_boundary_get_gradient, NULL for all ones. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Properties 1 and 2 of hsp_boundary_get_gradient, its energies against hsp_boundary_measure, and that it is linear in
 * tension and pressure. */
const char *broken_gradients(const computed *c, const double *sigma, double tension, double pressure,
                             uint32_t tangency);

/* A ball has a flag only if its sphere touches another; without flags there is one gradient, whatever the tangency. */
const char *broken_gradient_flags(const computed *c, const double *sigma);

/* Properties 1 and 2 of hsp_boundary_get_area_row, which entries there are, their angles and flags, and that rows add
 * up to gradients. Memory is quadratic in the number of balls, and so is time for each ball. */
const char *broken_area_rows(const computed *c, const double *sigma, uint32_t tangency);

/* Property 3 of hsp_boundary_get_gradient: the balls of `other` are those of c in another order, with their weights.
 * Equal balls may change places: which one of them has the derivatives is left open. */
const char *gradient_difference_after_permutation(const computed *c, const double *sigma, const computed *other,
                                                  const double *other_sigma, uint32_t tangency);

/* r_i r_j / d of two balls with an arc or circle, by which its angle is multiplied: large where balls are nearly
 * concentric, so that terms cancel. */
double slope_of_arcs(const computed *c, uint32_t i, uint32_t j);

/* Whether the spheres of two balls touch, from outside or inside: decided in whole lattice steps. */
int spheres_touch(const computed *c, uint32_t i, uint32_t j);

#ifdef __cplusplus
}
#endif
