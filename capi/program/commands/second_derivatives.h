/* Second derivatives of an energy by all centres, as rows of blocks. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/geometry.h"

/* Compressed as hsp_boundary_get_hessian_rows has them; all NULL at first, and then there is no block. */
struct second_derivatives {
  uint32_t *first; /* [atoms + 1] */
  uint32_t *ball;  /* [first[atoms]], ascending in each row */
  double *block;   /* [first[atoms]][9] */
  uint32_t *flags; /* [atoms + 1]: of each ball, and of all together */
};

/* Add those of an energy of a boundary, which the request states but for the executor. */
bool second_derivatives_add(struct second_derivatives *sum, const struct geometry *geometry, uint32_t atoms,
                            const hsp_gradient_request *request, struct failure *failure);

void second_derivatives_free(struct second_derivatives *sum);
