// Balls that are hidden behind others as a whole, found without an exact question.
//
// A ball is found hidden if the floor of depths that all balls together make lies above its front. So what is found
// does not depend on the order in which balls are looked at: whatever is hidden by part of the floor is hidden by all
// of it, and does not raise it. The order is for speed: cubes of balls with the highest tops first, so that most of
// what lies deep is left out cube by cube, without a look at its balls.
#pragma once

#include "core/patience.hpp"
#include "model/cube_grid.hpp"
#include "view/depth_buffer.hpp"

namespace hsp {

class OcclusionCuller {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  // Sets visible[i] to 0 for the balls that are found hidden. Balls with visible[i] = 0 before are left out. The
  // result does not depend on the order of the balls.
  // False if that is stopped.
  bool hide(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible, Patience &patience);
  // The part covered by the balls that are left.
  DepthBuffer &floor() { return floor_; }

 private:
  // The extent of the balls in question of a cube, rounded outwards. Without such a ball the height is minus infinity.
  struct CubeExtent {
    float left, right, bottom, top;  // in the view plane
    float height;                    // of the highest front
  };

  bool prepare(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible, Patience &patience);
  void order_cubes(uint32_t cubes);

  DepthBuffer floor_;
  Span<CubeExtent> extent_;  // [balls] of cubes
  Span<uint32_t> bucket_;
  Span<uint32_t> order_;  // [balls] cubes, those with the highest fronts first, up to the width of a bucket
  uint32_t ordered_ = 0;
  double lowest_top_ = 0.0, highest_top_ = 0.0;
};

}  // namespace hsp
