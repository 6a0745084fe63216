#include "model/neighbour_lists.hpp"

#include "core/sorting.hpp"
#include "model/query_hits.hpp"

namespace hsp {
namespace {

// The balls of up to three cubes of one row, and where that row lies beside the cube in the middle: -1, 0 or 1.
struct NearbyRow {
  BallRange range;
  int y, z;
};

// From a coordinate to the cubes below its own, to its own, which is 0, and to those above, in steps.
struct Gaps {
  Gaps(double value, double low_wall, double side) : gap{value - low_wall, 0.0, low_wall + side - value} {}
  double gap[3];
};

// Goes once over all pairs of balls that meet. Without ids it counts them in first, for both balls or for the one of
// the smaller index. With ids, which are all 0 before, it stores the larger index in the row of the smaller one, from
// the row's end on, which first tells.
class PairWalk {
 public:
  PairWalk(const CubeGrid &grid, Span<uint32_t> first, uint32_t count_of_larger, Span<uint32_t> ids)
      : first_(first),
        ids_(ids),
        count_of_larger_(count_of_larger),
        grid_(grid),
        balls_(grid.balls()),
        side_(static_cast<double>(grid.side())),
        largest_(static_cast<double>(grid.balls().largest_radius)) {}

  void run() {
    for (uint32_t cube = 0; cube < grid_.cubes(); ++cube) walk_cube(cube);
  }

 private:
  // All balls of a cube have the same rows of cubes around them. The second ball of a pair is the one that comes later
  // in the grid's order.
  void walk_cube(uint32_t cube) {
    const CubeCoordinates &at = grid_.table().coordinates(cube);
    const BallRange own = grid_.balls_in(cube);
    NearbyRow nearby[9];
    uint32_t count = 0;
    for (int z = -1; z <= 1; ++z) {
      for (int y = -1; y <= 1; ++y) {
        const BallRange range = grid_.balls_in_row(at.x - 1, at.x + 1, at.y + y, at.z + z);
        if (range.last > own.first) nearby[count++] = {range, y, z};
      }
    }
    const double low_y = static_cast<double>(at.y) * side_;
    const double low_z = static_cast<double>(at.z) * side_;
    for (uint32_t i = own.first; i < own.last; ++i) {
      const Gaps y(balls_.y[i], low_y, side_);
      const Gaps z(balls_.z[i], low_z, side_);
      // Squares and sum are rounded by less than this leaves out.
      const double reach = balls_.r[i] + largest_;
      const double too_far = reach * reach * (1.0 + 8 * unit_roundoff);
      for (uint32_t k = 0; k < count; ++k) {
        const double gap_y = y.gap[nearby[k].y + 1];
        const double gap_z = z.gap[nearby[k].z + 1];
        if (gap_y * gap_y + gap_z * gap_z <= too_far) look_at(i, nearby[k].range);
      }
      visit_hits(i);
    }
  }

  void look_at(uint32_t i, const BallRange &range) {
    const double x = balls_.x[i], y = balls_.y[i], z = balls_.z[i], r = balls_.r[i];
    uint32_t j = range.first > i ? range.first : i + 1;
    while (j < range.last) {
      const uint32_t room = at_once - hits_;
      const uint32_t end = range.last - j > room ? j + room : range.last;
      uint32_t hits = hits_;
      for (; j < end; ++j) {
        // Always stored, but kept only if it is a hit: a branch here could not be predicted.
        met_[hits] = balls_.caller[j];
        hits += static_cast<uint32_t>(meet(balls_.x[j] - x, balls_.y[j] - y, balls_.z[j] - z, balls_.r[j] + r));
      }
      hits_ = hits;
      if (j < range.last) visit_hits(i);
    }
  }

  void visit_hits(uint32_t i) {
    const uint32_t own = balls_.caller[i];
    for (uint32_t k = 0; k < hits_; ++k) {
      const uint32_t other = met_[k];
      pair(other < own ? other : own, other < own ? own : other);
    }
    hits_ = 0;
  }

  void pair(uint32_t smaller, uint32_t larger) {
    if (ids_.empty()) {
      ++first_[smaller];
      first_[larger] += count_of_larger_;
    } else {
      ids_[--first_[smaller]] |= larger;
    }
  }

  static constexpr uint32_t at_once = 64;

  const Span<uint32_t> first_, ids_;
  const uint32_t count_of_larger_;
  const CubeGrid &grid_;
  const BallSet &balls_;
  const double side_, largest_;
  uint32_t met_[at_once];
  uint32_t hits_ = 0;
};

// Marks the last entry of a row while rows are filled. No ball has an index as large.
constexpr uint32_t last_of_row = UINT32_C(1) << 31;
static_assert(max_count < last_of_row);

// Instead of a place in ids, for a row without entries.
constexpr uint32_t no_place = no_id;

// From where rows begin to where they end.
void begins_to_ends(Span<uint32_t> first, uint32_t n) {
  for (uint32_t i = 0; i < n; ++i) first[i] = first[i + 1] > first[i] ? first[i + 1] : no_place;
}

// Both rows of each pair, in ascending order without sorting. First the larger neighbours of each ball, in any order,
// fill its row from the end on; the rest of the row is free for as many smaller ones. Then each ball, in ascending
// order, writes itself into the rows of its neighbours from their beginnings on. It reads its own row for that: what
// has been written there are its smaller neighbours, all of them and no others by now; behind them the larger ones
// still stand as they were, and once they have been read they may be overwritten.
void list_in_both_rows(const CubeGrid &grid, Span<uint32_t> first, Span<uint32_t> ids) {
  const uint32_t n = grid.balls().n;
  begins_to_ends(first, n);
  for (uint32_t i = 0; i < n; ++i) {
    if (first[i] != no_place) ids[first[i] - 1] = last_of_row;
  }
  PairWalk(grid, first, 0, ids).run();
  for (uint32_t i = 0, place = 0; i < n; ++i) {
    if (first[i] == no_place) continue;
    first[i] = place;
    while ((ids[place++] & last_of_row) == 0) {
    }
  }
  for (uint32_t i = 0, place = 0; i < n; ++i) {
    if (first[i] == no_place) continue;
    uint32_t entry;
    do {
      entry = ids[place++];
      uint32_t &other = ids[first[entry & ~last_of_row]++];
      other = i | (other & last_of_row);
    } while ((entry & last_of_row) == 0);
  }
  uint32_t begin = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t end = first[i] == no_place ? begin : first[i];
    if (end > begin) ids[end - 1] &= ~last_of_row;
    first[i] = begin;
    begin = end;
  }
}

void list_in_smaller_row(const CubeGrid &grid, Span<uint32_t> first, Span<uint32_t> ids) {
  const uint32_t n = grid.balls().n;
  for (uint32_t i = 0; i < n; ++i) first[i] = first[i + 1];
  PairWalk(grid, first, 0, ids).run();
  for (uint32_t i = 0; i < n; ++i) {
    sort_in_place(ids.part(first[i], first[i + 1]), [](uint32_t a, uint32_t b) { return a < b; });
  }
}

}  // namespace

bool sum_up(Span<uint32_t> first) {
  uint64_t sum = 0;
  for (uint32_t &begin : first) {
    const uint32_t length = begin;
    begin = static_cast<uint32_t>(sum);
    sum += length;
  }
  if (sum <= UINT32_MAX) return true;
  for (uint32_t &begin : first) begin = 0;
  return false;
}

bool count_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first) {
  for (uint32_t &length : first) length = 0;
  PairWalk(grid, first, rows == PairRows::both ? 1 : 0, {}).run();
  return sum_up(first);
}

void list_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Span<uint32_t> ids) {
  if (ids.empty()) return;
  for (uint32_t &id : ids) id = 0;
  if (rows == PairRows::both) {
    list_in_both_rows(grid, first, ids);
  } else {
    list_in_smaller_row(grid, first, ids);
  }
}

}  // namespace hsp
