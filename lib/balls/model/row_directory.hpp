// A table with the first ball of each cube, for all cubes of the box around a set, row by row. The balls of a part of a
// row of cubes are found by two look-ups, whether its cubes hold balls or not. It is only for sets that fill their box
// well enough; others are left to the hash table, whose size depends only on the number of balls. Small code does
// without.
#pragma once

#include "core/small_code.hpp"
#include "model/ball_range.hpp"
#include "model/cube_list.hpp"
#include "model/query_hits.hpp"

namespace hsp {

inline constexpr bool has_row_directories = !small_code;

class RowDirectory {
 public:
  // Builds the directory in `cells`. The cubes are numbered by rows, and in each row in the order of x. There is no
  // directory if the box has more cubes than `cells` has room for.
  void build(const CubeList &cubes, Span<const uint32_t> first_ball, Span<uint32_t> cells);
  void clear() { width_ = 0; }

  bool is_there() const { return has_row_directories && width_ != 0; }
  // Writes the place and the size of the directory, for kernels.
  void describe(QueryGrid &grid) const;
  // Writes the balls of the cubes from `low` to `high`: a range for each row that has balls, in ascending order.
  // Returns how many ranges; `rows` must have room for all rows.
  uint32_t find(const CubeCoordinates &low, const CubeCoordinates &high, Span<BallRange> rows) const {
    const uint32_t *const cells = cells_.data();
    const int64_t from = clipped(low.x - low_.x, width_);
    const int64_t to = clipped(high.x - low_.x + 1, width_);
    const int64_t y_from = clipped(low.y - low_.y, rows_y_), y_to = clipped(high.y - low_.y + 1, rows_y_);
    const int64_t z_from = clipped(low.z - low_.z, rows_z_), z_to = clipped(high.z - low_.z + 1, rows_z_);
    uint32_t count = 0;
    for (int64_t z = z_from; z < z_to; ++z) {
      int64_t row = (z * rows_y_ + y_from) * (width_ + 1);
      for (int64_t y = y_from; y < y_to; ++y, row += width_ + 1) {
        const uint32_t first = cells[row + from], last = cells[row + to];
        rows[count] = {first, last};
        count += static_cast<uint32_t>(first != last);  // without a branch
      }
    }
    return count;
  }

 private:
  static int64_t clipped(int64_t at, int64_t end) {
    const int64_t not_before = at < 0 ? 0 : at;
    return not_before > end ? end : not_before;
  }

  Span<uint32_t> cells_;  // [rows_z][rows_y][width + 1]: the first ball in a cube or behind it; last, the row's end
  CubeCoordinates low_{};
  int64_t width_ = 0;  // cubes in a row
  int64_t rows_y_ = 0, rows_z_ = 0;
};

}  // namespace hsp
