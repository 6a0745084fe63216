/* Second derivatives of an energy with respect to all centres, as rows of blocks. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/geometry.h"

/* Compressed rows, as from hsp_boundary_get_hessian_rows; all NULL at first: no block. */
struct second_derivatives {
  uint32_t *first; /* [atoms + 1] */
  uint32_t *ball;  /* [first[atoms]], ascending in each row */
  double *block;   /* [first[atoms]][9] */
  uint32_t *flags; /* [atoms + 1]: those of each ball, and of all together */
};

/* Add the derivatives of an energy of a boundary. The request states the energy; its executor is ignored. */
bool second_derivatives_add(struct second_derivatives *sum, const struct geometry *geometry, uint32_t atoms,
                            const hsp_gradient_request *request, struct failure *failure);

void second_derivatives_free(struct second_derivatives *sum);
