// Finds balls that are hidden behind others as a whole, without an exact question.
//
// A ball counts as hidden if the floor of depths that all balls together make lies above its front. So the result does
// not depend on the order in which balls are looked at: a ball that is hidden by a part of the floor is hidden by all
// of it, and does not raise it. The order is for speed: cubes of balls with the highest tops come first, so that most
// deep balls are left out cube by cube, without a look at each.
#pragma once

#include "core/patience.hpp"
#include "model/cube_grid.hpp"
#include "view/depth_buffer.hpp"

namespace hsp {

class OcclusionCuller {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  // Sets visible[i] to 0 for the balls that are found hidden. Balls with visible[i] = 0 before are left out. The
  // result does not depend on the order of the balls. False if patience ends.
  bool hide(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible, Patience &patience);
  // The floor that the visible balls make.
  DepthBuffer &floor() { return floor_; }

 private:
  // The extent of the balls of a cube that are not left out, rounded outwards. Without any the height is minus
  // infinity.
  struct CubeExtent {
    float left, right, bottom, top;  // in the view plane
    float height;                    // of the highest front
  };

  bool prepare(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible, Patience &patience);
  void order_cubes(uint32_t cubes);

  DepthBuffer floor_;
  Span<CubeExtent> extent_;  // [balls], used for cubes
  Span<uint32_t> bucket_;
  Span<uint32_t> order_;  // [balls] cubes by their highest fronts, highest first; unsorted within a bucket
  uint32_t ordered_ = 0;
  double lowest_top_ = 0.0, highest_top_ = 0.0;
};

}  // namespace hsp
