#include "curvature/hessian_rows.hpp"

#include "core/sorting.hpp"
#include "measure/input_order.hpp"
#include "measure/sums_in_parts.hpp"
#include "measure/tangency.hpp"

namespace hsp {

void HessianRows::begin(uint32_t row) const {
  sort_ascending(Span<uint32_t>(ball + first[row], length(row)));
  double *const entry = block + 9 * size_t{first[row]};
  for (size_t k = 0; k < 9 * size_t{length(row)}; ++k) entry[k] = 0.0;
}

void HessianRows::balance(uint32_t row, const double sum[9]) const {
  double *const diagonal = block_of(row, row);
  for (uint32_t k = 0; k < 9; ++k) diagonal[k] = 0.5 * (sum[k] + sum[transposed(k)]);
}

void HessianRows::join_flags(uint32_t n) const {
  if (flags == nullptr) return;
  flags[n] = 0;
  for (uint32_t i = 0; i < n; ++i) flags[n] |= flags[i];
}

namespace {

class RowBuilder {
 public:
  RowBuilder(const CubeGrid &grid, const Boundary &boundary, const EnergyTerms &terms, const HessianRows &rows)
      : balls_(grid.balls()), boundary_(boundary), terms_(terms), rows_(rows) {}

  // Finds the columns of row i, and the blocks of pairs that are computed on this ball. place: the grid's index of i.
  void find_blocks(uint32_t i, uint32_t place) const {
    if (rows_.flags != nullptr) rows_.flags[i] = 0;
    if (rows_.length(i) == 0) return;
    uint32_t *const columns = rows_.ball + rows_.first[i];
    visit_balls_of_area_row(boundary_, place, [&](uint32_t k, uint32_t j) { columns[k] = balls_.caller[j]; });
    rows_.begin(i);
    HessianArcs arcs(balls_, boundary_, terms_, place);
    while (arcs.next()) {
      if (!decides_block(balls_, place, arcs.other())) continue;
      double *const sum = rows_.block_of(i, balls_.caller[arcs.other()]);
      const HessianBlock part = arcs.block();
      for (uint32_t k = 0; k < 9; ++k) sum[k] += part.entry[k];
    }
    if (rows_.flags != nullptr) rows_.flags[i] = arcs.flags();
  }

  // Fills the other blocks of row i, and the diagonal. Sums run in the order of the circles on the ball, which is the
  // grid's: so the caller's order of balls does not change their last bits.
  void complete(uint32_t i, uint32_t place) const {
    if (rows_.length(i) == 0) return;
    double sum[9] = {};
    visit_balls_of_area_row(boundary_, place, [&](uint32_t, uint32_t other) {
      if (other == place) return;
      const uint32_t j = balls_.caller[other];
      double *const own = rows_.block_of(i, j);
      if (decides_block(balls_, other, place)) {
        const double *const found = rows_.block_of(j, i);
        for (uint32_t k = 0; k < 9; ++k) own[k] = found[HessianRows::transposed(k)];
      }
      for (uint32_t k = 0; k < 9; ++k) sum[k] -= own[k];
    });
    rows_.balance(i, sum);
  }

 private:
  const BallSet &balls_;
  const Boundary &boundary_;
  const EnergyTerms &terms_;
  const HessianRows &rows_;
};

// Calls visit(i, place) for each ball i of the caller, from the tasks of the executor.
template <class Visit>
bool for_each_ball(const Executor &executor, const CubeGrid &grid, const Boundary &boundary, Visit visit) {
  return for_each_range(executor, grid.balls().n,
                        [&](IdRange range) { visit_in_input_order(grid, boundary, range, visit); });
}

}  // namespace

bool find_hessian_rows(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                       const EnergyTerms &terms, const HessianRows &rows) {
  const RowBuilder builder(grid, boundary, terms, rows);
  const bool each =
      for_each_ball(executor, grid, boundary, [&](uint32_t i, uint32_t place) { builder.find_blocks(i, place); }) &&
      for_each_ball(executor, grid, boundary, [&](uint32_t i, uint32_t place) { builder.complete(i, place); });
  if (!each || rows.flags == nullptr) return each;
  flag_free_inner_contacts(grid, boundary, one_sided_flag, rows.flags);
  rows.join_flags(grid.balls().n);
  return true;
}

bool multiply_by_hessian(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                         const EnergyTerms &terms, const double *direction, double *product, uint32_t *flags) {
  const BallSet &balls = grid.balls();
  const auto vector = [direction](uint32_t i) {
    const double *const x = direction + 3 * size_t{i};
    return Vec3{x[0], x[1], x[2]};
  };
  const bool each = for_each_ball(executor, grid, boundary, [&](uint32_t i, uint32_t place) {
    double sum[3] = {};
    uint32_t found = 0;
    if (boundary.is_exposed(place)) {
      const Vec3 own = vector(i);
      HessianArcs arcs(balls, boundary, terms, place);
      while (arcs.next()) {
        const HessianBlock part = arcs.block();
        const Vec3 moved = combine(1.0, vector(balls.caller[arcs.other()]), -1.0, own);
        for (uint32_t k = 0; k < 3; ++k) {
          const double *const row = part.entry + 3 * k;
          sum[k] += row[0] * moved.x + row[1] * moved.y + row[2] * moved.z;
        }
      }
      found = arcs.flags();
    }
    for (uint32_t k = 0; k < 3; ++k) product[3 * size_t{i} + k] = sum[k];
    if (flags != nullptr) flags[i] = found;
  });
  if (each && flags != nullptr) flag_free_inner_contacts(grid, boundary, one_sided_flag, flags);
  return each;
}

}  // namespace hsp
