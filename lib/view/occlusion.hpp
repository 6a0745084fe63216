// Balls that are hidden behind others as a whole, found without an exact question.
#pragma once

#include "model/cube_grid.hpp"
#include "view/depth_buffer.hpp"

namespace hsp {

class OcclusionCuller {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  // Sets visible[i] to 0 for the balls that are found hidden. Balls with visible[i] = 0 before are left out. What is
  // found does not depend on the order of the balls.
  void hide(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible);
  // What the balls that are left cover.
  DepthBuffer &floor() { return floor_; }

 private:
  struct CubeExtent;

  bool prepare(const BallSet &balls, const ViewFrame &frame, Span<uint8_t> visible);
  void order_cubes(const CubeGrid &grid, Span<uint8_t> visible);
  void ask_about_cube(const BallRange &own, Span<uint8_t> visible);

  DepthBuffer floor_;
  Span<ProjectedBall> disc_;  // [balls]
  Span<uint32_t> bucket_;     // [balls + 1]
  Span<uint32_t> order_;      // [balls] cubes, the one with the highest top first, up to the width of a bucket
  uint32_t ordered_ = 0;
  double lowest_top_ = 0.0, highest_top_ = 0.0;
};

}  // namespace hsp
