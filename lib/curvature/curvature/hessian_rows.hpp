// All second derivatives of an energy by the centres (hessians.hpp), as compressed rows of blocks or times a direction.
//
//          0   1   2       Three balls in a chain, 0 - 1 - 2, of which 0 and 2 share no arc: the rows begin at entries
//      0 ( D0  A     )     0, 2, 5 and end at 7. A and B come from the arcs, in the row of the smaller ball of the
//      1 ( A^T D1  B )     two; A^T and B^T are copied, and a diagonal block is what makes the sum of its row 0,
//      2 (     B^T D2)     symmetric.
#pragma once

#include "core/executor.hpp"
#include "core/first_index.hpp"
#include "curvature/hessians.hpp"

namespace hsp {

// The arrays of a caller, balls in his order. Row i has the entries first[i] to first[i + 1] - 1, which are those of
// the Jacobian of areas (find_area_row_starts).
struct HessianRows {
  const uint32_t *first;  // [n + 1]
  uint32_t *ball;         // [first[n]]: the columns, ascending
  double *block;          // [first[n]][9]
  uint32_t *flags;        // [n + 1], or null: of each ball, and of all together

  static constexpr uint32_t transposed(uint32_t k) { return 3 * (k % 3) + k / 3; }
  uint32_t length(uint32_t row) const { return first[row + 1] - first[row]; }
  // Of the entry of a row and column, which is there once the columns of the row are in order.
  double *block_of(uint32_t row, uint32_t column) const {
    const uint32_t *const columns = ball + first[row];
    const uint32_t k = first_index(0, length(row), [&](uint32_t at) { return columns[at] >= column; });
    return block + 9 * (size_t{first[row]} + k);
  }
  // Puts the columns of a row in order, and makes its blocks 0.
  void begin(uint32_t row) const;
  // The diagonal block of a row, symmetric, from the sum of its others with the sign changed.
  void balance(uint32_t row, const double sum[9]) const;
  // Of all balls together.
  void join_flags(uint32_t n) const;
};

// Whether a block comes from the arcs on this ball. That is the smaller one, on which vectors are shorter and lose
// less, or of equal ones that of lower rank.
inline bool decides_block(const BallSet &balls, uint32_t ball, uint32_t other) {
  const double r = balls.r[ball], other_r = balls.r[other];
  return r != other_r ? r < other_r : balls.ranks_before(ball, other);
}

// False if the executor fails.
bool find_hessian_rows(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                       const EnergyTerms &terms, const HessianRows &rows);

// product [n][3] becomes the Hessian times direction [n][3]; flags [n], or null. Each row comes from the arcs on its
// own ball alone: it is the same if only some balls are searched; the others have zeros then. False if the executor
// fails.
bool multiply_by_hessian(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                         const EnergyTerms &terms, const double *direction, double *product, uint32_t *flags);

}  // namespace hsp
