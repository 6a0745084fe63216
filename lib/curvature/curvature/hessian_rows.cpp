#include "curvature/hessian_rows.hpp"

#include "measure/input_order.hpp"
#include "measure/sums_in_parts.hpp"
#include "measure/tangency.hpp"

namespace hsp {

namespace {

class RowBuilder {
 public:
  RowBuilder(const CubeGrid &grid, const Boundary &boundary, const EnergyTerms &terms, const HessianRows &rows)
      : balls_(grid.balls()), boundary_(boundary), terms_(terms), rows_(rows) {}

  // The columns of row i, and blocks of pairs that ball `place`, the grid's index of i, decides.
  void find_blocks(uint32_t i, uint32_t place) const {
    if (rows_.flags != nullptr) rows_.flags[i] = 0;
    const uint32_t length = rows_.first[i + 1] - rows_.first[i];
    if (length == 0) return;
    uint32_t *const columns = rows_.ball + rows_.first[i];
    visit_balls_of_area_row(boundary_, place, [&](uint32_t k, uint32_t j) { columns[k] = balls_.caller[j]; });
    sort_in_place(Span<uint32_t>(columns, length), [](uint32_t a, uint32_t b) { return a < b; });
    for (uint32_t k = 0; k < 9 * length; ++k) block(rows_.first[i])[k] = 0.0;
    HessianArcs arcs(balls_, boundary_, terms_, place);
    while (arcs.next()) {
      if (!decides(place, arcs.other())) continue;
      double *const sum = block(entry(i, balls_.caller[arcs.other()]));
      const HessianBlock part = arcs.block();
      for (uint32_t k = 0; k < 9; ++k) sum[k] += part.entry[k];
    }
    if (rows_.flags != nullptr) rows_.flags[i] = arcs.flags();
  }

  // The other blocks of row i, and the diagonal. Sums run in the order of the circles on the ball, which is that of the
  // grid: the caller's order of the balls does not change their last bits.
  void complete(uint32_t i, uint32_t place) const {
    if (rows_.first[i] == rows_.first[i + 1]) return;
    double sum[9] = {};
    visit_balls_of_area_row(boundary_, place, [&](uint32_t, uint32_t other) {
      if (other == place) return;
      const uint32_t j = balls_.caller[other];
      double *const own = block(entry(i, j));
      if (decides(other, place)) {
        const double *const found = block(entry(j, i));
        for (uint32_t k = 0; k < 9; ++k) own[k] = found[transposed(k)];
      }
      for (uint32_t k = 0; k < 9; ++k) sum[k] -= own[k];
    });
    double *const diagonal = block(entry(i, i));
    for (uint32_t k = 0; k < 9; ++k) diagonal[k] = 0.5 * (sum[k] + sum[transposed(k)]);
  }

 private:
  // Whether a block comes from the arcs on this ball. That is the smaller one, on which vectors are shorter and lose
  // less, or of equal ones that of lower rank.
  bool decides(uint32_t ball, uint32_t other) const {
    const double r = balls_.r[ball], other_r = balls_.r[other];
    return r != other_r ? r < other_r : balls_.ranks_before(ball, other);
  }
  static constexpr uint32_t transposed(uint32_t k) { return 3 * (k % 3) + k / 3; }
  double *block(uint32_t entry) const { return rows_.block + 9 * size_t{entry}; }
  uint32_t entry(uint32_t row, uint32_t column) const {
    const uint32_t *const first = rows_.first + row;
    return first[0] +
           first_index(0, first[1] - first[0], [&](uint32_t k) { return rows_.ball[first[0] + k] >= column; });
  }

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
  const uint32_t n = grid.balls().n;
  rows.flags[n] = 0;
  for (uint32_t i = 0; i < n; ++i) rows.flags[n] |= rows.flags[i];
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
