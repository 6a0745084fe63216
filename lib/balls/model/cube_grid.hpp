// The balls of a set in the order of their cubes, and an index of the cubes.
//
// As an example a plane with balls A to G, and the block of the cube in the middle, which has D:
//    F  |  G  |          Rows are in the order of y, the lowest first, and balls are numbered in this order, A to G. So
//   ----+-----+----      each row of the block is one range of balls, A to C, D to E and F to G: two numbers. In space
//       |  D  |  E       a block has nine rows.
//   ----+-----+----
//    A  | B C |
#pragma once

#include "model/cube_index.hpp"

namespace hsp {

// The balls of the up to 27 cubes around a position: one range for each row of cubes that has balls, in ascending
// order, nine at most. If the grid has images, up to nine ranges of images follow.
struct CubeBlock {
  BallRange range[18];
  uint32_t ranges = 0;
  const RadiusLevels *levels = nullptr;  // null, or an index that finds the balls that meet a ball in less time
};

class CubeGrid : public OrderedBalls {
 public:
  CubeGrid();  // out of line: it is large
  // Carves the arrays for at most n balls; with a measuring workspace it only counts.
  void carve(Workspace &workspace, uint32_t n);

  // Rounds and sorts the balls. On failure the grid is empty, and first_bad names the ball. The grid is empty also if
  // `patience` allows no more work.
  Status build(const BallInput &input, uint32_t &first_bad, Patience patience = Patience());
  // The same from balls that are on a lattice, in the caller's order. The balls from number `own` on are images.
  void build(const BallSet &given, uint32_t own, Patience patience = Patience());
  // The same from balls that are on a lattice: the caller's ball i is balls.ball(slot[i]). Cubes get the given side,
  // which is twice the largest radius or more. There must be room for the balls.
  void build(const BallSet &balls, Span<const uint32_t> slot, int64_t side, Patience patience = Patience());

  const CubeSlots &slots() const { return index_.slots(); }
  const RowDirectory &rows() const { return index_.rows(); }
  const QueryGrid *queries() const { return index_.queries(); }
  // The index by levels of radii, or null.
  const RadiusLevels *levels() const { return levels_.is_there() ? &levels_ : nullptr; }
  // The balls of the cubes (x_low .. x_high, y, z).
  BallRange balls_in_row(int64_t x_low, int64_t x_high, int64_t y, int64_t z) const;
  CubeBlock block_around(const CubeCoordinates &centre) const;

  // The target of the kernels, and whether queries use them.
  Target target() const { return target_; }
  bool in_lanes() const { return has_lanes && in_lanes_; }
  // For tests.
  void use(Target target, bool lanes) {
    target_ = target;
    in_lanes_ = lanes;
    levels_.use(target, lanes);
  }
  void use_no_levels();

  // Calls use(slots) with the memory of the index, for another grouping of the same balls: as many slots as a hash
  // table of that many cubes needs. Then the index is built again.
  template <class Use>
  void lend_slots(Use use) {
    use(index_.cells());
    index_.build_rows(*this, in_lanes());
    build_levels();
  }

 private:
  void build_index();
  void build_levels();
  void add_rows(const CubeCoordinates &low, const CubeCoordinates &high, CubeBlock &block) const;

  CubeIndex index_;
  RadiusLevels levels_;
  Target target_ = Target::baseline;
  bool in_lanes_ = has_lanes;
};

}  // namespace hsp
