// A set of balls cut across its longest extent into two bricks with equally many balls, for the benchmarks.
#pragma once

#include "bricks/brick_summaries.hpp"
#include "paper_molecules.hpp"

namespace bench {

class HalvedSet {
 public:
  HalvedSet(const Balls &balls, double probe);

  // Model and boundary of the first half with the balls around it.
  void compute_first() { maker_.compute(half_[0], largest_radius_); }
  // The summary of the first half, after compute_first.
  void summarise_first() { summary_[0] = maker_.summarise(half_[0], 0, 2, 0); }
  // Merges the summaries of both halves.
  void merge();

  // The number of balls that the first half owns; the balls around it as a share of these; the bytes of its summary.
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
