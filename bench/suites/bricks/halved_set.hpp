// A set of balls in two bricks of as many balls each, cut across its longest extent, for the benchmarks.
#pragma once

#include "bricks/brick_summaries.hpp"
#include "paper_molecules.hpp"

namespace bench {

class HalvedSet {
 public:
  HalvedSet(const Balls &balls, double probe);

  // Model and boundary of the first half with the balls around it.
  void compute_first() { maker_.compute(half_[0], largest_radius_); }
  // Its summary, after that.
  void summarise_first() { summary_[0] = maker_.summarise(half_[0], 0, 2, 0); }
  // Both summaries to one.
  void merge();

  // Balls that the first half owns; those around it in their part of these; bytes of its summary.
  [[nodiscard]] uint32_t owned() const { return owned_; }
  [[nodiscard]] double halo_share() const { return static_cast<double>(half_[0].size()) / owned_ - 1; }
  [[nodiscard]] double bytes() const { return static_cast<double>(summary_[0].size()); }

 private:
  support::OwnedBalls half_[2];
  double largest_radius_ = 0;
  uint32_t owned_ = 0;
  support::BrickMaker maker_;
  support::Summary summary_[2], whole_;
};

}  // namespace bench
