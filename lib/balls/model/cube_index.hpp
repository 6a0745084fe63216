// Finds cubes of a grid by their coordinates, in a hash table. Its size depends only on the number of cubes that hold
// balls, not on the extent of the set. Sets that fill the box around them also have a directory of rows, and the data
// for whole queries in lanes.
#pragma once

#include "model/ordered_balls.hpp"
#include "model/query_hits.hpp"
#include "model/radius_levels.hpp"
#include "model/row_directory.hpp"

namespace hsp {

// A T where there are lanes, else nothing.
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
  // Ends the index. Until it is built again the caller may use the returned memory: two numbers for each ball, or four.
  Span<uint32_t> end() const;

  // rounds: whether balls are rounded to floats, for queries in lanes.
  void build(const OrderedBalls &order, bool rounds);
  // Ends all but the hash table, until build_rows(). Returns the memory that this sets free.
  IndexMemory end_rows() {
    rows_.clear();
    if (QueryGrid *const grid = queries_.get()) *grid = {};
    return {cells_, rounded_};
  }
  // Builds all but the hash table, with which the rest shares no memory.
  void build_rows(const OrderedBalls &order, bool rounds);

  // The number of a cube; no_id if it holds no balls. linear: linear_hash(cube).
  uint32_t find(const OrderedBalls &order, const CubeCoordinates &cube, uint64_t linear) const {
    return slots_.find(cube, linear, order.cube_list().cube_of());
  }
  const Span<uint32_t> &cells() const { return cells_; }
  const CubeSlots &slots() const { return slots_; }
  // The directory of rows, which is_there() if this set has one.
  const RowDirectory &rows() const { return rows_; }
  // The data for whole queries in lanes; null without lanes.
  const QueryGrid *queries() const { return queries_.get(); }

 private:
  static constexpr bool rounds_balls = has_row_directories;

  CubeSlots slots_;
  RowDirectory rows_;
  Span<uint32_t> cells_;  // [at least 2 n] for the directory of rows
  Span<float> rounded_;   // [4 (n + read_behind)]
  InLanes<QueryGrid> queries_;
};

}  // namespace hsp
