// Which brick owns which ball, and which others its model has: slabs, bricks, bisections, oblique cuts, owners at
// random.
#pragma once

#include "brick_summaries.hpp"
#include "random_numbers.hpp"

// Sets owners; returns how many bricks there are.
uint32_t split_at_random(support::Random &random, support::OwnedBalls &balls);

// The balls of a brick and those of others in its model: the least, or with some by accident, or all that are near.
class Halos {
 public:
  // The model is of all balls.
  Halos(const support::OwnedBalls &balls, const hsp_model *model, int64_t largest_radius);

  [[nodiscard]] support::OwnedBalls model_of(uint32_t brick, uint32_t kind, support::Random &random) const;

 private:
  const support::OwnedBalls &balls_;
  const int64_t largest_radius_;
  std::vector<uint32_t> first_, pairs_;
};
