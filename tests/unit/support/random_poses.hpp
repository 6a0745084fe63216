// Poses at random, and the trees of sets of balls.
#pragma once

#include <array>

#include "built_grid.hpp"
#include "lattice_lengths.hpp"
#include "poses/pose.hpp"
#include "poses/sphere_tree.hpp"
#include "random_balls.hpp"

class BuiltTree {
 public:
  explicit BuiltTree(const oracle::Balls &balls) : grid_(oracle::in_lengths(balls, 1.0)) {
    memory_.carve(tree_, static_cast<uint32_t>(balls.size()));
    status_ = tree_.build(grid_.grid().balls());
  }

  const hsp::SphereTree &tree() const { return tree_; }
  void use(hsp::Target target) { tree_.use(target); }
  hsp::Status status() const { return status_; }

 private:
  BuiltGrid grid_;
  CarvedMemory memory_;
  hsp::SphereTree tree_;
  hsp::Status status_ = hsp::Status::state;
};

struct PoseNumbers {
  std::array<double, 4> quaternion{1, 0, 0, 0};
  std::array<double, 3> translation{};
};

inline hsp::Pose pose_of(const PoseNumbers &numbers) {
  hsp::Pose pose;
  static_cast<void>(hsp::Pose::make(numbers.quaternion.data(), numbers.translation.data(),
                                    hsp::exact::Lattice::with_step(1.0), pose));
  return pose;
}

// Any rotation, one of those that map the axes onto each other, or none.
inline PoseNumbers random_pose(oracle::RandomSource &random, int64_t largest_shift) {
  PoseNumbers numbers;
  const int64_t kind = random.in(0, 3);
  for (double &component : numbers.quaternion)
    component = kind > 1 ? 2 * random.fraction() - 1 : static_cast<double>(random.in(0, 1));
  if (kind == 0 || numbers.quaternion == std::array<double, 4>{}) numbers.quaternion = {1, 0, 0, 0};
  for (double &component : numbers.translation)
    component = static_cast<double>(random.in(-largest_shift, largest_shift));
  return numbers;
}
