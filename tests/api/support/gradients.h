/* The derivatives of one set of balls, as the interface has them. */
#pragma once

#include "ball_sets.h"
#include "computed.h"

typedef struct gradients {
  hsp_energy energy;
  double centre[3 * BALL_SET_MOST];
  double radius[BALL_SET_MOST];
  uint32_t flags[BALL_SET_MOST];
} gradients;

/* hsp_boundary_get_gradient with all outputs; the status. */
int32_t gradients_make(const computed *c, const double *sigma, double tension, double pressure, uint32_t tangency,
                       gradients *result);

/* All rows of the Jacobian, each with room for n entries: row i starts at entries + i * n and has length[i] of them.
 * Ends the program if there is no memory. To be followed by jacobian_release. */
typedef struct jacobian {
  uint32_t n;
  hsp_area_derivative *entries;
  uint32_t *length;
} jacobian;

/* The first status that is not HSP_OK, or HSP_OK. */
int32_t jacobian_make(const computed *c, uint32_t tangency, jacobian *result);

void jacobian_release(jacobian *result);

/* The entry for ball j in row i, or NULL: then all these derivatives are 0. */
const hsp_area_derivative *jacobian_entry(const jacobian *all, uint32_t i, uint32_t j);
