#include "periodic/periodic_hessian.hpp"

#include "measure/sums_in_parts.hpp"
#include "model/neighbour_lists.hpp"
#include "periodic/periodic_measures.hpp"

namespace hsp {
namespace {

// The balls that share free pieces of circles with one ball in the box, themselves or by images.
class BallsOfRow {
 public:
  explicit BallsOfRow(const PeriodicUnion &periodic)
      : images_(periodic.images()),
        grid_(periodic.grid()),
        in_grid_(grid_, images_),
        boundary_(periodic.boundary()),
        frame_(images_.box().frame()) {}

  // The ball of the input that a ball or image of the grid belongs to.
  uint32_t owner(uint32_t grid_ball) const { return images_.ball_of(grid_.balls().caller[grid_ball]); }
  // Calls sink(j) once for every ball j of the input but i that, itself or by an image, has a circle on ball i. In the
  // order of the first such circle on the ball.
  template <class Sink>
  void visit_others(uint32_t i, Sink sink) const {
    const uint32_t place = grid_.grid_index(i);
    visit_balls_of_area_row(boundary_, place, [&](uint32_t, uint32_t other) {
      const uint32_t j = owner(other);
      if (j != i && is_first_of(j, grid_.balls().caller[other], place)) sink(j);
    });
  }
  bool is_empty(uint32_t i) const { return !boundary_.is_exposed(grid_.grid_index(i)); }

 protected:
  const PeriodicImages &images_;
  const CubeGrid &grid_;
  const ImagesInGrid in_grid_;
  const Boundary &boundary_;
  const BoxFrame &frame_;

 private:
  // Whether `number` is the first of ball j and its images that has a circle on a ball.
  bool is_first_of(uint32_t j, uint32_t number, uint32_t place) const {
    if (number == j) return true;
    if (has_circle_of(place, grid_.grid_index(j))) return false;
    for (uint32_t k = images_.first_image(j); k < number; ++k) {
      if (has_circle_of(place, grid_.grid_index(k))) return false;
    }
    return true;
  }
  bool has_circle_of(uint32_t place, uint32_t other) const {
    // The other ball has the same circle in the box. One with many is met by balls with few each.
    const Span<const ClosedHalfEdge> own = boundary_.circles(place),
                                     others = boundary_.circles(in_grid_.ball_of(other));
    const bool from_place = own.size() <= others.size();
    const uint32_t wanted = from_place ? other : in_grid_.moved_back(place, other);
    for (const ClosedHalfEdge e : from_place ? own : others) {
      if (boundary_.neighbour(e) == wanted) return true;
    }
    // Half-edges of a ball are in the order of the ranks of its neighbours.
    const IdRange all = boundary_.half_edges(place);
    const uint32_t first = first_index(all.first, all.last, [&](uint32_t e) {
      return !grid_.balls().ranks_before(boundary_.half_edge(e).circle, other);
    });
    return first < all.last && boundary_.half_edge(first).circle == other;
  }
};

class RowsInBox : private BallsOfRow {
 public:
  RowsInBox(const PeriodicUnion &periodic, const EnergyTerms &terms, const HessianRows &rows)
      : BallsOfRow(periodic), terms_(terms), rows_(rows) {}

  // Finds the columns of row i, and the parts of its blocks that are computed on its own arcs.
  void find_parts(uint32_t i) const {
    if (rows_.flags != nullptr) rows_.flags[i] = 0;
    if (rows_.length(i) == 0) return;
    uint32_t *column = rows_.ball + rows_.first[i];
    *column++ = i;
    visit_others(i, [&](uint32_t j) { *column++ = j; });
    rows_.begin(i);
    const uint32_t place = grid_.grid_index(i);
    HessianArcs arcs(grid_.balls(), boundary_, terms_, place);
    while (arcs.next()) {
      const uint32_t j = owner(arcs.other());
      if (j == i || !decides_block(grid_.balls(), place, arcs.other())) continue;
      double *const sum = rows_.block_of(i, j);
      const HessianBlock part = arcs.block();
      for (uint32_t k = 0; k < 9; ++k) sum[k] += part.entry[k];
    }
    if (rows_.flags != nullptr) rows_.flags[i] = arcs.flags();
  }

  // Adds both parts of the blocks of row i above the diagonal, turned to the caller's frame. Here and in complete()
  // rows read from each other only blocks that no task writes meanwhile.
  void add_up(uint32_t i) const {
    for_each_column(i, [&](uint32_t j, double *own) {
      if (j <= i) return;
      const double *const part = rows_.block_of(j, i);
      Strain sum;
      for (uint32_t k = 0; k < 9; ++k) sum.by[k] = own[k] + part[HessianRows::transposed(k)];
      const Strain turned = frame_.strain_turned_back(sum);
      for (uint32_t k = 0; k < 9; ++k) own[k] = turned.by[k];
    });
  }

  // Fills the blocks of row i below the diagonal, and the diagonal.
  void complete(uint32_t i) const {
    if (rows_.length(i) == 0) return;
    for_each_column(i, [&](uint32_t j, double *own) {
      if (j >= i) return;
      const double *const found = rows_.block_of(j, i);
      for (uint32_t k = 0; k < 9; ++k) own[k] = found[HessianRows::transposed(k)];
    });
    double sum[9] = {};
    visit_others(i, [&](uint32_t j) {
      const double *const own = rows_.block_of(i, j);
      for (uint32_t k = 0; k < 9; ++k) sum[k] -= own[k];
    });
    rows_.balance(i, sum);
  }

 private:
  template <class Visit>
  void for_each_column(uint32_t i, Visit visit) const {
    for (uint32_t entry = rows_.first[i]; entry < rows_.first[i + 1]; ++entry) {
      visit(rows_.ball[entry], rows_.block + 9 * size_t{entry});
    }
  }

  const EnergyTerms &terms_;
  const HessianRows &rows_;
};

// Calls visit(i) for each ball i of the input, from the tasks of the executor.
template <class Visit>
bool for_each_ball(const Executor &executor, uint32_t n, Visit visit) {
  return for_each_range(executor, n, [&](IdRange range) {
    for (uint32_t i = range.first; i < range.last; ++i) visit(i);
  });
}

}  // namespace

bool find_hessian_row_starts_in_box(const Executor &executor, const PeriodicUnion &periodic, uint32_t *first) {
  const BallsOfRow balls(periodic);
  const uint32_t n = periodic.images().balls();
  const bool each = for_each_ball(executor, n, [&](uint32_t i) {
    first[i] = 0;
    if (balls.is_empty(i)) return;
    ++first[i];
    balls.visit_others(i, [&](uint32_t) { ++first[i]; });
  });
  first[n] = 0;
  return each && sum_up(Span<uint32_t>(first, n + 1));
}

bool find_hessian_rows_in_box(const Executor &executor, const PeriodicUnion &periodic, const EnergyTerms &terms,
                              const HessianRows &rows) {
  const uint32_t n = periodic.images().balls();
  // Lengths of the set are in steps.
  EnergyTerms in_steps = terms;
  in_steps.pressure = periodic.images().lattice().length(terms.pressure);
  const RowsInBox builder(periodic, in_steps, rows);
  if (!for_each_ball(executor, n, [&](uint32_t i) { builder.find_parts(i); }) ||
      !for_each_ball(executor, n, [&](uint32_t i) { builder.add_up(i); }) ||
      !for_each_ball(executor, n, [&](uint32_t i) { builder.complete(i); }))
    return false;
  if (rows.flags == nullptr) return true;
  flag_free_inner_contacts_in_box(periodic, one_sided_flag, rows.flags);
  rows.join_flags(n);
  return true;
}

}  // namespace hsp
