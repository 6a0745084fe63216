// Balls on the lattice of step 1 with their grid alone, in memory of fixed size.
#pragma once

#include "cases.hpp"
#include "model/cube_grid.hpp"

namespace cases {

struct LatticePoint {
  int64_t x, y, z, r;  // r: radius of a ball
};

class SmallGrid {
 public:
  static constexpr uint32_t most_balls = 200;

  // False if something does not fit or fails.
  bool build(const LatticePoint *balls, uint32_t n) {
    if (n > most_balls) return false;
    for (uint32_t i = 0; i < n; ++i) {
      xyz_[3 * i] = static_cast<double>(balls[i].x);
      xyz_[3 * i + 1] = static_cast<double>(balls[i].y);
      xyz_[3 * i + 2] = static_cast<double>(balls[i].z);
      radius_[i] = static_cast<double>(balls[i].r);
    }
    hsp::Workspace measured;
    grid_.carve(measured, n);
    if (measured.bytes() > sizeof memory_) return false;
    hsp::Workspace workspace(memory_, sizeof memory_);
    grid_.carve(workspace, n);
    if (!has_own_code_) grid_.use(target_, in_lanes_);
    uint32_t first_bad = 0;
    return grid_.build({n, xyz_, radius_, 0.0, 1.0}, first_bad) == hsp::Status::ok;
  }
  hsp::CubeGrid &grid() { return grid_; }
  // The code that the next grids run instead of what the processor has.
  void use(hsp::Target target, bool in_lanes) {
    has_own_code_ = false;
    target_ = target;
    in_lanes_ = in_lanes;
  }
  void use_own_code() { has_own_code_ = true; }

 private:
  hsp::CubeGrid grid_;
  bool has_own_code_ = true;
  hsp::Target target_ = hsp::Target::baseline;
  bool in_lanes_ = false;
  double xyz_[3 * most_balls], radius_[most_balls];
  alignas(64) unsigned char memory_[32 * 1024];
};

// One for all cases, as it is large for a stack.
inline SmallGrid &small_grid() {
  static SmallGrid one;
  return one;
}

}  // namespace cases
