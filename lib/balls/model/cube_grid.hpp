// The balls of a set in the order of their cubes, and an index of these.
//
// As an example a plane, letters being balls; the block of the cube in the middle, which has D:
//    F  |  G  |          Rows are in the order of y, the lowest first, and so are the numbers of balls: A to G. So each
//   ----+-----+----      row of the block is one range, A to C, D to E and F to G, which two numbers tell. In space
//       |  D  |  E       there are nine rows.
//   ----+-----+----
//    A  | B C |
#pragma once

#include "model/cube_index.hpp"

namespace hsp {

// The balls of the up to 27 cubes around a position: one range per row of cubes, in ascending order; then as many of
// images, if there are such.
struct CubeBlock {
  BallRange range[18];
  uint32_t ranges = 0;
  const RadiusLevels *levels = nullptr;  // tell which of these meet a ball sooner, if there are such
};

class CubeGrid : public OrderedBalls {
 public:
  CubeGrid();  // out of line: it is large
  // Carves the arrays for at most n balls; with a measuring workspace it only counts.
  void carve(Workspace &workspace, uint32_t n);

  // Rounds and sorts the balls. On failure the grid is empty; first_bad names the ball. So is it once that is no longer
  // allowed.
  Status build(const BallInput &input, uint32_t &first_bad, Patience patience = Patience());
  // The same from balls that are on a lattice, in the caller's order. Those from number `own` on are images.
  void build(const BallSet &given, uint32_t own, Patience patience = Patience());
  // The same from balls that are on a lattice: the caller's ball i is balls.ball(slot[i]). Cubes get the given side,
  // twice the largest radius or more. There is room for so many balls.
  void build(const BallSet &balls, Span<const uint32_t> slot, int64_t side, Patience patience = Patience());

  const CubeSlots &slots() const { return index_.slots(); }
  const RowDirectory &rows() const { return index_.rows(); }
  const QueryGrid *queries() const { return index_.queries(); }
  // Null if there are none.
  const RadiusLevels *levels() const { return levels_.is_there() ? &levels_ : nullptr; }
  // The balls of the cubes (x_low .. x_high, y, z).
  BallRange balls_in_row(int64_t x_low, int64_t x_high, int64_t y, int64_t z) const;
  CubeBlock block_around(const CubeCoordinates &centre) const;

  // Of the kernels, and whether queries are in lanes.
  Target target() const { return target_; }
  bool in_lanes() const { return has_lanes && in_lanes_; }
  // For tests.
  void use(Target target, bool lanes) {
    target_ = target;
    in_lanes_ = lanes;
    levels_.use(target, lanes);
  }
  void use_no_levels();

  // Calls use(slots) for another grouping of the same balls, with as many slots as there may be cubes.
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
