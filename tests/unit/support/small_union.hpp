// A few balls with their grid and boundary in memory of fixed size, for cases that run without a heap.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "cases.hpp"
#include "sphere/cap_clusters.hpp"
#include "sphere/great_circles.hpp"

namespace cases {

struct SmallBall {
  int32_t x, y, z, r;  // lattice steps
};

class SmallUnion {
 public:
  static constexpr uint32_t most_balls = 12;

  // False if something does not fit or fails. The radii are without the probe.
  bool build(const SmallBall *balls, uint32_t n, int32_t probe = 0) {
    double xyz[3 * most_balls], radius[most_balls];
    if (n > most_balls) return false;
    for (uint32_t i = 0; i < n; ++i) {
      xyz[3 * i] = balls[i].x;
      xyz[3 * i + 1] = balls[i].y;
      xyz[3 * i + 2] = balls[i].z;
      radius[i] = balls[i].r;
    }
    const auto carve = [&](hsp::Workspace &workspace) {
      grid_.carve(workspace, most_balls);
      builder_.carve(workspace, {most_balls, most_balls, 60, 30});
      gathered_.carve(workspace, most_balls);
      clusters_.carve(workspace, most_balls);
    };
    hsp::Workspace measured;
    carve(measured);
    if (measured.bytes() > sizeof memory_) return false;
    hsp::Workspace workspace(memory_, sizeof memory_);
    carve(workspace);
    uint32_t first_bad = 0;
    return grid_.build({n, xyz, radius, static_cast<double>(probe), 1.0}, first_bad) == hsp::Status::ok &&
           builder_.build(grid_) == hsp::Status::ok;
  }

  const hsp::CubeGrid &grid() const { return grid_; }
  const hsp::BallSet &balls() const { return grid_.balls(); }
  const hsp::Boundary &boundary() const { return builder_.boundary(); }
  hsp::BoundaryBuilder &builder() { return builder_; }
  // The caps of the ball that was given as number `input`.
  hsp::GatheredBall &gathered(uint32_t input) {
    gathered_.gather(grid_, grid_.grid_index(input));
    return gathered_;
  }
  hsp::CapClusters &clusters() { return clusters_; }

 private:
  hsp::CubeGrid grid_;
  hsp::BoundaryBuilder builder_;
  hsp::GatheredBall gathered_;
  hsp::CapClusters clusters_;
  alignas(64) unsigned char memory_[48 * 1024];
};

// One for all cases, as it is large for a stack.
inline SmallUnion &small_union() {
  static SmallUnion one;
  return one;
}

}  // namespace cases
