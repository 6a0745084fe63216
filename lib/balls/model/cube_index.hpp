// Cubes of a grid by their coordinates: a hash table, whose size depends on the number of cubes that hold balls alone,
// not on the extent of the set; for sets that fill the box around them a directory of rows, too, and what whole queries
// in lanes ask.
#pragma once

#include "model/ordered_balls.hpp"
#include "model/query_hits.hpp"
#include "model/radius_levels.hpp"
#include "model/row_directory.hpp"

namespace hsp {

// No memory where there are no lanes.
template <class T, bool lanes = has_lanes>
class InLanes {
 public:
  T *get() { return &value_; }
  const T *get() const { return &value_; }

 private:
  T value_;
};
template <class T>
class InLanes<T, false> {
 public:
  static T *get() { return nullptr; }
};

class CubeIndex {
 public:
  // For at most n balls.
  void carve(Workspace &workspace, uint32_t n);
  // The index is over. Until it is built again others may have memory of it: for two numbers of each ball, or for four.
  Span<uint32_t> end() const;

  // rounds: whether queries are in lanes.
  void build(const OrderedBalls &order, bool rounds);
  // All but the table is over until build_rows().
  IndexMemory end_rows() {
    rows_.clear();
    if (QueryGrid *const grid = queries_.get()) *grid = {};
    return {cells_, rounded_};
  }
  // All but the table, whose memory the others do not share.
  void build_rows(const OrderedBalls &order, bool rounds);

  // The number of a cube, of which the linear form is given; no_id if there is none.
  uint32_t find(const OrderedBalls &order, const CubeCoordinates &cube, uint64_t linear) const {
    return slots_.find(cube, linear, order.cube_list().cube_of());
  }
  const Span<uint32_t> &cells() const { return cells_; }
  const CubeSlots &slots() const { return slots_; }
  // The directory of rows, if this set has one.
  const RowDirectory &rows() const { return rows_; }
  // For whole queries in lanes; null without lanes.
  const QueryGrid *queries() const { return queries_.get(); }

 private:
  static constexpr bool rounds_balls = has_row_directories;

  CubeSlots slots_;
  RowDirectory rows_;
  Span<uint32_t> cells_;  // [at least 2 n] of the directory
  Span<float> rounded_;   // [4 n and behind]
  InLanes<QueryGrid> queries_;
};

}  // namespace hsp
