// All second derivatives of an energy by the centres (hessians.hpp), as compressed rows of blocks or times a direction.
//
//          0   1   2       Three balls in a chain, 0 - 1 - 2, of which 0 and 2 share no arc: the rows begin at entries
//      0 ( D0  A     )     0, 2, 5 and end at 7. A and B come from the arcs, in the row of the smaller ball of the
//      1 ( A^T D1  B )     two; A^T and B^T are copied, and a diagonal block is what makes the sum of its row 0,
//      2 (     B^T D2)     symmetric.
#pragma once

#include "core/executor.hpp"
#include "curvature/hessians.hpp"

namespace hsp {

// The arrays of a caller, balls in his order. Row i has the entries first[i] to first[i + 1] - 1, which are those of
// the Jacobian of areas (find_area_row_starts).
struct HessianRows {
  const uint32_t *first;  // [n + 1]
  uint32_t *ball;         // [first[n]]: the columns, ascending
  double *block;          // [first[n]][9]
  uint32_t *flags;        // [n + 1], or null: of each ball, and of all together
};

// False if the executor fails.
bool find_hessian_rows(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                       const EnergyTerms &terms, const HessianRows &rows);

// product [n][3] becomes the Hessian times direction [n][3]; flags [n], or null. Each row comes from the arcs on its
// own ball alone: it is the same if only some balls are searched; the others have zeros then. False if the executor
// fails.
bool multiply_by_hessian(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                         const EnergyTerms &terms, const double *direction, double *product, uint32_t *flags);

}  // namespace hsp
