// The balls of a set, sorted by cubes of side 2 r_max (Section 3), in the order of grid_order.hpp. Each ball is stored
// once, in the cube of its centre: the centres of two balls that meet are in the same cube or in neighbouring ones, so
// 27 cubes hold all neighbours of a ball.
//
// A set may end with images that only surround the others, as in a periodic box. They come behind all others in the
// grid's order, in the cubes of a halo.
#pragma once

#include "core/workspace.hpp"
#include "model/ball_range.hpp"
#include "model/ball_set.hpp"
#include "model/cube_table.hpp"
#include "model/halo.hpp"
#include "model/query_hits.hpp"
#include "model/row_directory.hpp"

namespace hsp {

class CubeAxis;
struct GridOrder;

// The balls of the up to 27 cubes around a position: one range per row of cubes, in ascending order; then as many of
// images, if there are such.
struct CubeBlock {
  BallRange range[18];
  uint32_t ranges = 0;
};

class CubeGrid {
 public:
  // Carves the arrays for at most n balls; with a measuring workspace it only counts.
  void carve(Workspace &workspace, uint32_t n);

  // Rounds and sorts the balls. On failure the grid is empty; first_bad names the ball.
  Status build(const BallInput &input, uint32_t &first_bad);
  // The same from balls that are on a lattice, in the caller's order. Those from number `own` on are images.
  void build(const BallSet &given, uint32_t own);
  // The same from balls that are on a lattice: the caller's ball i is balls.ball(slot[i]). Cubes get the given side,
  // twice the largest radius or more. There is room for so many balls.
  void build(const BallSet &balls, Span<const uint32_t> slot, int64_t side);

  const BallSet &balls() const { return balls_; }
  uint32_t capacity() const { return capacity_; }
  int64_t side() const { return side_; }
  const CubeTable &table() const { return table_; }
  // Position of the caller's ball in the grid's order.
  uint32_t grid_index(uint32_t caller) const { return grid_index_[caller]; }

  uint32_t cubes() const { return table_.count(); }
  // Without images: the first balls, in the first cubes.
  uint32_t own_balls() const { return own_balls_; }
  uint32_t own_cubes() const { return own_cubes_; }
  bool has_images() const { return own_balls_ < balls_.n; }
  BallRange balls_in(uint32_t cube) const { return balls_of(cube, cube + 1); }
  // Of cubes first .. last - 1.
  BallRange balls_of(uint32_t first, uint32_t last) const { return {first_ball_[first], first_ball_[last]}; }
  CubeCoordinates cube_at(const exact::Vector &point) const { return cube_at(point, side_); }
  static CubeCoordinates cube_at(const exact::Vector &point, int64_t side);
  // The balls of the cubes (x_low .. x_high, y, z).
  BallRange balls_in_row(int64_t x_low, int64_t x_high, int64_t y, int64_t z) const;
  // The directory of rows, if this set has one.
  const RowDirectory &rows() const { return rows_; }
  CubeBlock block_around(const CubeCoordinates &centre) const;

  // Of the kernels, and whether queries are in lanes.
  Target target() const { return target_; }
  bool in_lanes() const { return has_lanes && in_lanes_; }
  // For tests.
  void use(Target target, bool lanes) {
    target_ = target;
    in_lanes_ = lanes;
  }

  // Memory of O(n) slots and links for other groupings of the same balls (packing_statistics.cpp). The slots hold the
  // directory of rows, which is to be made again after that.
  Span<uint32_t> scratch_slots() { return scratch_slots_; }
  Span<uint32_t> scratch_links() { return scratch_links_; }
  void make_row_directory();

  // The directory for whole queries in lanes.
  const QueryGrid &query_grid() const { return query_grid_; }

 private:
  void clear();
  void round_balls();
  Status store_all(const BallRounding &rounding, uint32_t n, uint32_t &first_bad, int64_t &largest);
  template <class Source>
  void sort(const Source &source, const BallSet &given, const LatticeBox &box, uint32_t own);
  template <class Source>
  GridOrder order_of(const Source &source, const BallSet &given, const LatticeBox &box, const CubeAxis &axis,
                     BallRange part);
  template <class Source>
  void put(const Source &source, const CubeAxis &axis, BallRange part, const GridOrder &order);
  void add_rows(const CubeCoordinates &low, const CubeCoordinates &high, CubeBlock &block) const;

  BallSet balls_;
  CubeTable table_;
  RowDirectory rows_;
  QueryGrid query_grid_;
  Span<float> rounded_;        // [4 n and behind] for the directory of rows; before, the order of balls is found in it
  Span<uint32_t> first_ball_;  // [cubes + 1, and at least 4]
  Span<uint32_t> grid_index_;  // [n] caller -> grid order
  Span<uint32_t> scratch_slots_, scratch_links_;
  uint32_t capacity_ = 0;
  uint32_t own_balls_ = 0, own_cubes_ = 0;
  Halo halo_;
  int64_t side_ = 1;
  Target target_ = Target::baseline;
  bool in_lanes_ = has_lanes;
};

}  // namespace hsp
