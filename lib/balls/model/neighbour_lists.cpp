// Counts all neighbours of all balls, or lists them in rows.
//
// As an example balls 0, 1 and 2, of which 0 meets 2 and 1 meets 2. `first` has the beginnings of the rows and, at its
// end, the end of the last one:
//   rows of the smaller index     first   0 1 2 2       ids   2 | 2 |
//   rows of both                  first   0 1 2 4       ids   2 | 2 | 0 1
// The first walk over all pairs counts; sums of the counts are the ends of rows. The second walk fills each row from
// its end on, and counts `first` down, so that each end becomes the beginning of its row.
#include "model/neighbour_lists.hpp"

#include "core/ahead.hpp"
#include "core/sorting.hpp"
#include "model/meeting.hpp"
#include "model/pair_block.hpp"
#include "model/queries.hpp"
#include "model/rounded_block.hpp"

namespace hsp {
namespace {

// The balls of up to three cubes of one row, and the offset of this row from the cube in the middle along y and z: -1,
// 0 or 1.
struct NearbyRow {
  BallRange range;
  int y, z;
};

// The distances, in steps, from a coordinate to the cubes below its own, to its own, which is 0, and to those above.
struct Gaps {
  Gaps(double value, double low_wall, double side) : gap{value - low_wall, 0.0, low_wall + side - value} {}
  double gap[3];
};

// Calls visit(cube) for all cubes. False if `patience` allows no more work.
template <class Visit>
bool for_each_cube(const CubeGrid &grid, Patience &patience, Visit visit) {
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const BallRange own = grid.balls_in(cube);
    if (!patience.allows(1000 * uint64_t{own.last - own.first})) return false;
    visit(cube);
  }
  return patience.allows(0);
}

// Goes once over all pairs of balls that meet. If `ids` is empty, it counts them in `first`, for both balls or for the
// smaller index alone. Else, with all ids 0 before, it stores the larger index in the row of the smaller one, from the
// row's end on, which `first` has.
class PairWalk {
 public:
  PairWalk(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Span<uint32_t> ids)
      : first_(first),
        ids_(ids),
        both_rows_(rows == PairRows::both),
        grid_(grid),
        balls_(grid.balls()),
        side_(static_cast<double>(grid.side())),
        largest_(static_cast<double>(grid.balls().largest_radius)) {}

  // False if `patience` allows no more work.
  bool run(Patience &patience) {
    if (const RadiusLevels *const levels = grid_.levels())
      return for_each_cube(grid_, patience, [&](uint32_t cube) { walk_cube_by_levels(cube, *levels); });
    if constexpr (has_lanes) {
      if (grid_.in_lanes()) return for_each_cube(grid_, patience, [&](uint32_t cube) { walk_cube_in_blocks(cube); });
    }
    return for_each_cube(grid_, patience, [&](uint32_t cube) { walk_cube(cube); });
  }

 private:
  // All balls of a cube have the same rows of cubes around them. A pair is found at the ball that is earlier in grid
  // order.
  void walk_cube(uint32_t cube) {
    const CubeCoordinates &at = grid_.cube_list().coordinates(cube);
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
      // The margin is larger than the rounding of the squares and of their sum.
      const double reach = balls_.r[i] + largest_;
      const double too_far = reach * reach * certainly_above;
      for (uint32_t k = 0; k < count; ++k) {
        const double gap_y = y.gap[nearby[k].y + 1];
        const double gap_z = z.gap[nearby[k].z + 1];
        if (gap_y * gap_y + gap_z * gap_z <= too_far) look_at(i, nearby[k].range);
      }
      visit(i, met_, hits_);
      hits_ = 0;
    }
  }

  // The same with copies of the cube's balls and all later balls around it, in as many blocks as needed.
  void walk_cube_in_blocks(uint32_t cube) {
    const CubeCoordinates &at = grid_.cube_list().coordinates(cube);
    const BallRange own = grid_.balls_in(cube);
    const CubeBlock around = grid_.block_around(at);
    const QueryArrays balls = query_arrays(balls_);
    PairBlock block;
    block.count = 0;
    block.doubt = static_cast<float>(doubt_nearby(side_));
    block.centre[0] = (static_cast<double>(at.x) + 0.5) * side_;
    block.centre[1] = (static_cast<double>(at.y) + 0.5) * side_;
    block.centre[2] = (static_cast<double>(at.z) + 0.5) * side_;
    // The ranges ascend: the first one that does not end before the cube is the range of the cube's own row.
    uint32_t in_earlier_blocks = 0;
    for (uint32_t k = 0; k < around.ranges; ++k) {
      BallRange range = around.range[k];
      if (range.first < own.first) range.first = own.first;
      while (range.first < range.last) {
        range.first = add_to_block(grid_.target(), block, balls, range);
        if (block.count < PairBlock::room) break;
        look_into(block, balls, own, in_earlier_blocks);
        in_earlier_blocks += block.count;
        block.count = 0;
      }
    }
    look_into(block, balls, own, in_earlier_blocks);
  }

  // The same with the index of levels. Only a ball with more neighbours than there is room for is tested against all
  // balls around its cube.
  void walk_cube_by_levels(uint32_t cube, const RadiusLevels &levels) {
    const BallRange own = grid_.balls_in(cube);
    for (uint32_t i = own.first; i < own.last; ++i) {
      uint32_t met[QueryHits::room];
      const uint32_t count = levels.find_neighbours(balls_, i, met, QueryHits::room);
      if (count <= QueryHits::room) {
        uint32_t later = 0;
        for (uint32_t k = 0; k < count; ++k) {
          const uint32_t j = met[k];
          met[later] = balls_.caller[j];
          later += static_cast<uint32_t>(j > i);
        }
        visit(i, met, later);
        continue;
      }
      const CubeBlock around = grid_.block_around(grid_.cube_list().coordinates(cube));
      for (uint32_t k = 0; k < around.ranges; ++k) {
        if (around.range[k].last > own.first) look_at(i, around.range[k]);
      }
      visit(i, met_, hits_);
      hits_ = 0;
    }
  }

  // Finds the pairs of the cube's balls with those of a block. The cube's own balls are the first in the blocks.
  void look_into(const PairBlock &block, const QueryArrays &balls, const BallRange &own, uint32_t in_earlier_blocks) {
    uint32_t met[PairBlock::room + PairBlock::lanes];
    for (uint32_t i = own.first; i < own.last; ++i) {
      const uint32_t later = i + 1 - own.first;
      const uint32_t from = later > in_earlier_blocks ? later - in_earlier_blocks : 0;
      if (from < block.count) visit(i, met, met_in_block(grid_.target(), block, balls, i, from, met));
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
      if (j < range.last) {
        visit(i, met_, hits_);
        hits_ = 0;
      }
    }
  }

  // Counts or stores the pairs of ball i with each of the others, which are the caller's indices.
  void visit(uint32_t i, const uint32_t *others, uint32_t count) {
    const uint32_t own = balls_.caller[i];
    const bool counting = ids_.empty();
    if (counting && both_rows_) first_[own] += count;
    for (uint32_t k = 0; k < count; ++k) {
      const uint32_t other = others[k];
      uint32_t &slot = first_[both_rows_ && counting ? other : other < own ? other : own];
      if (counting) {
        ++slot;
      } else {
        ids_[--slot] |= other < own ? own : other;
      }
    }
  }

  static constexpr uint32_t at_once = 64;

  const Span<uint32_t> first_, ids_;
  const bool both_rows_;
  const CubeGrid &grid_;
  const BallSet &balls_;
  const double side_, largest_;
  uint32_t met_[at_once];
  uint32_t hits_ = 0;
};

// Tests each ball against all balls around it, and writes its row at once: twice as many tests as PairWalk, but no
// writes to other rows. That is faster if cubes hold few balls, or if rows do not fit the processor's caches.
class RowWalk {
 public:
  static bool suits_counting(const CubeGrid &grid) {
    return is_possible(grid) && grid.balls().n <= most_balls_in_a_cube * uint64_t{grid.cubes()};
  }
  static bool suits_listing(const CubeGrid &grid, bool in_cache) {
    return in_cache ? suits_counting(grid) : is_possible(grid);
  }

  explicit RowWalk(const CubeGrid &grid) : grid_(grid), balls_(query_arrays(grid.balls())) {}

  void count(Span<uint32_t> first, Patience &patience) {
    for_each_ball(patience, [&](uint32_t i, const RoundedBlock *around) {
      first[balls_.caller[i]] =
          around != nullptr ? count_in_block(grid_.target(), *around, balls_, i) - 1 : ask_grid(i, nullptr, 0);
    });
  }

  void list(Span<const uint32_t> first, Span<uint32_t> ids, Patience &patience) {
    QueryHits hits;
    const uint32_t last = grid_.balls().n - 1;
    for_each_ball(patience, [&](uint32_t i, const RoundedBlock *around) {
      const auto later = [&](uint32_t by) { return balls_.caller[i + by < last ? i + by : last]; };
      __builtin_prefetch(&first[later(2 * ahead::rows)]);
      prefetch_row(first, ids, later(ahead::rows));
      const uint32_t own = balls_.caller[i], length = first[own + 1] - first[own];
      if (length == 0) return;
      uint32_t *const row = ids.data() + first[own];
      if (around != nullptr && length <= QueryHits::room) {
        find_others_in_block(grid_.target(), *around, balls_, i, hits);
        write_ascending_in_lanes(grid_.target(), hits, row, ids.size() - first[own]);
      } else {
        ask_grid(i, row, length);
      }
    });
  }

 private:
  // Calls use(i, around) for each ball i. around: all balls around it, or null if a block has no room for them. Not
  // inlined, so that blocks of two kinds do not lie on the stack together.
  template <class Use>
  [[gnu::noinline]] void for_each_ball(Patience &patience, Use use) const {
    RoundedBlock block;
    for (uint32_t cube = 0; cube < grid_.cubes(); ++cube) {
      const CubeCoordinates &at = grid_.cube_list().coordinates(cube);
      BallRange rows[RoundedBlock::most_ranges];
      const uint32_t count = grid_.rows().find({at.x - 1, at.y - 1, at.z - 1}, {at.x + 1, at.y + 1, at.z + 1},
                                               {rows, RoundedBlock::most_ranges});
      const bool has_room = fill_block(grid_.target(), block, *grid_.queries(), balls_, rows, count);
      const BallRange own = grid_.balls_in(cube);
      if (!patience.allows(1000 * uint64_t{own.last - own.first})) return;
      for (uint32_t i = own.first; i < own.last; ++i) use(i, has_room ? &block : nullptr);
    }
  }

  // A hint to the processor that the front of this row will be written soon.
  static void prefetch_row(Span<const uint32_t> first, Span<uint32_t> ids, uint32_t own) {
    constexpr uint32_t ids_of_line = 16;
    const uint32_t length = first[own + 1] - first[own];
    const uint32_t front = length < QueryHits::room ? length : QueryHits::room;
    const uint32_t *const row = ids.data() + first[own];
    for (uint32_t k = 0; k < front; k += ids_of_line) __builtin_prefetch(row + k, 1);
  }

  uint32_t ask_grid(uint32_t i, uint32_t *row, uint32_t length) const {
    QueryResult result{row, length, 0};
    find_neighbours_by_cubes(grid_, i, result);
    return result.hits;
  }

  static bool is_possible(const CubeGrid &grid) { return grid.in_lanes() && grid.queries()->rounded != nullptr; }

  static constexpr uint32_t most_balls_in_a_cube = 4;

  const CubeGrid &grid_;
  const QueryArrays balls_;
};

// Marks the last entry of a row while rows are filled. All indices of balls are smaller.
constexpr uint32_t last_of_row = UINT32_C(1) << 31;
static_assert(max_count < last_of_row);

// In `first`, for a row without entries.
constexpr uint32_t no_entry = no_id;

// Turns the beginnings of rows into their ends.
void begins_to_ends(Span<uint32_t> first, uint32_t n) {
  for (uint32_t i = 0; i < n; ++i) first[i] = first[i + 1] > first[i] ? first[i + 1] : no_entry;
}

// Lists each pair in both rows, in ascending order without sorting. First the larger neighbours of each ball, in any
// order, fill its row from the end on; the rest of the row is free for its smaller neighbours. Then each ball, in
// ascending order, writes itself into the rows of its neighbours, from their beginnings on. To do so it reads its own
// row: at the beginning are all its smaller neighbours, which have been written by now, and behind them are still the
// larger ones. Once these have been read they may be overwritten.
void list_in_both_rows(const CubeGrid &grid, Span<uint32_t> first, Span<uint32_t> ids, Patience &patience) {
  const uint32_t n = grid.balls().n;
  begins_to_ends(first, n);
  for (uint32_t i = 0; i < n; ++i) {
    if (first[i] != no_entry) ids[first[i] - 1] = last_of_row;
  }
  if (!PairWalk(grid, PairRows::both, first, ids).run(patience)) return;
  for (uint32_t i = 0, slot = 0; i < n; ++i) {
    if (first[i] == no_entry) continue;
    if (!patience.allows(200)) return;
    first[i] = slot;
    while ((ids[slot++] & last_of_row) == 0) {
    }
  }
  for (uint32_t i = 0, slot = 0; i < n; ++i) {
    if (first[i] == no_entry) continue;
    if (!patience.allows(500)) return;
    uint32_t entry;
    do {
      entry = ids[slot++];
      uint32_t &other = ids[first[entry & ~last_of_row]++];
      other = i | (other & last_of_row);
    } while ((entry & last_of_row) == 0);
  }
  uint32_t begin = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t end = first[i] == no_entry ? begin : first[i];
    if (end > begin) ids[end - 1] &= ~last_of_row;
    first[i] = begin;
    begin = end;
  }
}

void list_in_smaller_row(const CubeGrid &grid, Span<uint32_t> first, Span<uint32_t> ids, Patience &patience) {
  const uint32_t n = grid.balls().n;
  for (uint32_t i = 0; i < n; ++i) first[i] = first[i + 1];
  if (!PairWalk(grid, PairRows::smaller, first, ids).run(patience)) return;
  for (uint32_t i = 0; i < n && patience.allows(1000); ++i) {
    sort_ascending(ids.part(first[i], first[i + 1]));
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

bool count_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Patience patience) {
  for (uint32_t &length : first) length = 0;
  if constexpr (has_lanes) {
    if (rows == PairRows::both && RowWalk::suits_counting(grid)) {
      RowWalk(grid).count(first, patience);
      return sum_up(first);
    }
  }
  PairWalk(grid, rows, first, {}).run(patience);
  return sum_up(first);
}

void list_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Span<uint32_t> ids,
                     [[maybe_unused]] uint32_t most_cached, Patience patience) {
  if (ids.empty()) return;
  if constexpr (has_lanes) {
    const bool in_cache = ids.size() <= most_cached;
    if (rows == PairRows::both && RowWalk::suits_listing(grid, in_cache))
      return RowWalk(grid).list(first, ids, patience);
  }
  for (uint32_t &id : ids) id = 0;
  if (rows == PairRows::both) {
    list_in_both_rows(grid, first, ids, patience);
  } else {
    list_in_smaller_row(grid, first, ids, patience);
  }
}

}  // namespace hsp
