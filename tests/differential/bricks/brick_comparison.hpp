// A set in one brick against the boundary and topology of the whole, and in many bricks against one.
#pragma once

#include "brick_families.hpp"
#include "brick_splits.hpp"

class BrickComparison {
 public:
  // The first difference, or nothing. splits: how many ways to cut the set.
  std::string complaint(const BrickSet &set, support::Random &random, int splits);

  struct Counters {
    uint64_t sets = 0, splits = 0, bricks = 0, merges = 0, voids = 0, tied = 0, refused = 0, bytes = 0;
  };
  [[nodiscard]] const Counters &counters() const { return counters_; }

 private:
  void take(const BrickSet &set, support::Random &random);
  std::string one_piece();
  std::string shells_differ();
  std::string split_differs(support::Random &random);
  std::string merges_differ(support::Random &random, std::vector<support::Summary> parts, bool kept);
  std::string damage_is_seen(support::Random &random, const support::Summary &summary);
  std::string faults_are_seen(const std::vector<support::Summary> &parts);

  support::BrickMaker maker_, whole_;
  support::OwnedBalls balls_;
  double largest_radius_ = 1;
  hsp_brick_totals totals_{};
  std::vector<hsp_brick_shell> shells_;
  Counters counters_;
};
