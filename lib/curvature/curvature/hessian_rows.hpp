// All second derivatives of an energy by the centres (hessians.hpp), as compressed rows of blocks or times a direction.
//
//          0   1   2       Three balls in a chain, 0 - 1 - 2, of which 0 and 2 share no arc: the rows begin at entries
//      0 ( D0  A     )     0, 2, 5 and end at 7. A and B are computed from the arcs on the smaller of the two balls;
//      1 ( A^T D1  B )     A^T and B^T are copied. A diagonal block is symmetric, and makes the sum of its row 0.
//      2 (     B^T D2)
#pragma once

#include "core/executor.hpp"
#include "core/first_index.hpp"
#include "curvature/hessians.hpp"

namespace hsp {

// The arrays of a caller, with balls in the caller's order. Row i has the entries first[i] to first[i + 1] - 1, the
// same as in the Jacobian of areas (find_area_row_starts).
struct HessianRows {
  const uint32_t *first;  // [n + 1]
  uint32_t *ball;         // [first[n]]: the columns, ascending
  double *block;          // [first[n]][9]
  uint32_t *flags;        // [n + 1], or null: the flags of each ball, then those of all together

  static constexpr uint32_t transposed(uint32_t k) { return 3 * (k % 3) + k / 3; }
  uint32_t length(uint32_t row) const { return first[row + 1] - first[row]; }
  // The block of a row and column, which must be an entry; the columns of the row must be in order.
  double *block_of(uint32_t row, uint32_t column) const {
    const uint32_t *const columns = ball + first[row];
    const uint32_t k = first_index(0, length(row), [&](uint32_t at) { return columns[at] >= column; });
    return block + 9 * (size_t{first[row]} + k);
  }
  // Puts the columns of a row in order, and makes its blocks 0.
  void begin(uint32_t row) const;
  // Sets the diagonal block of a row to minus the sum of its other blocks, made symmetric.
  void balance(uint32_t row, const double sum[9]) const;
  // Sets the flags of all balls together.
  void join_flags(uint32_t n) const;
};

// Whether the block of two balls is computed from the arcs on `ball`. It is the smaller one, on which vectors are
// shorter and less rounded; of equal balls the one of lower rank.
inline bool decides_block(const BallSet &balls, uint32_t ball, uint32_t other) {
  const double r = balls.r[ball], other_r = balls.r[other];
  return r != other_r ? r < other_r : balls.ranks_before(ball, other);
}

// Fills the rows. False if the executor fails.
bool find_hessian_rows(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                       const EnergyTerms &terms, const HessianRows &rows);

// Sets product [n][3] to the Hessian times direction [n][3]; flags [n], or null. Each row is computed from the arcs on
// its own ball alone. So it is the same if the boundary was searched on some balls only; the other balls have zeros
// then. False if the executor fails.
bool multiply_by_hessian(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                         const EnergyTerms &terms, const double *direction, double *product, uint32_t *flags);

}  // namespace hsp
