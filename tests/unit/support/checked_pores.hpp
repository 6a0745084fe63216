// The library's pores against brute force over all sets of balls (tests/oracle/brute_pores.hpp), against Euler's
// relation between critical points, and against the number of free regions around grown balls, as the library's own
// cells have it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brute_pores.hpp"
#include "built_free_space.hpp"
#include "built_pores.hpp"
#include "pockets/class_tree.hpp"
#include "pore_sets.hpp"
#include "tied_sets.hpp"

namespace checked_pores {

struct Seen {
  int points = 0, tied = 0, pairs = 0, levels = 0, regions = 0, gates = 0;
};

// The library's critical points alone. No ball may lie inside another one.
class FoundPoints {
 public:
  FoundPoints(const oracle::Balls &outer, int64_t floor) : FoundPoints(outer, floor, roomy(outer)) {}
  FoundPoints(const oracle::Balls &outer, int64_t floor, const hsp::PoreLimits &limits)
      : grid_(BuiltPores::listed(outer)) {
    const auto n = static_cast<uint32_t>(outer.size());
    ball_memory_.carve(balls_, n, n);
    memory_.carve(points_, limits);
    hsp::Patience endless;
    status_ = balls_.take(grid_.grid(), endless);
    if (status_ == hsp::Status::ok) status_ = points_.find(balls_, floor, endless);
  }
  static hsp::PoreLimits roomy(const oracle::Balls &balls) {
    const auto n = static_cast<uint32_t>(balls.size());
    return {n, 40 * n + 200, 80 * n + 200, 4000, 200 * n + 4000, n + 8};
  }
  hsp::Status status() const { return status_; }
  const hsp::CriticalPoints &points() const { return points_; }

 private:
  BuiltGrid grid_;
  CarvedMemory ball_memory_, memory_;
  hsp::PoreBalls balls_;
  hsp::CriticalPoints points_;
  hsp::Status status_ = hsp::Status::ok;
};

inline void check_euler_sum(const oracle::Balls &balls, Seen &seen) {
  const oracle::Balls outer = oracle::outer_balls(balls);
  const FoundPoints found(outer, BuiltPores::lowest(outer));
  ASSERT_EQ(found.status(), hsp::Status::ok);
  const auto maxima = static_cast<int>(found.points().maxima().size());
  const auto gates = static_cast<int>(found.points().gates().size());
  ASSERT_EQ(maxima + 1 - gates + oracle::count_gaps(outer) - static_cast<int>(outer.size()), 0)
      << oracle::to_text(outer);
  seen.points += maxima + gates;
  seen.tied += found.points().tied().size() > 0 ? 1 : 0;
}

// All maxima and gates, their order, and where classes meet.
inline void compare_with_all_sets(const oracle::Balls &balls, Seen &seen) {
  const oracle::Balls outer = oracle::outer_balls(balls);
  const int64_t floor = BuiltPores::lowest(outer);
  const BuiltPores pores(outer, floor);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  oracle::ListedPores listed;
  const auto list = [&](const hsp::CriticalPoint &point, auto &lists) {
    const auto tied = pores.builder().tied(point);
    lists.emplace_back(tied.begin(), tied.end());
    std::sort(lists.back().begin(), lists.back().end());
    seen.tied += tied.size() > (point.ball[3] == hsp::no_id ? 3 : 4) ? 1 : 0;
    ++seen.points;
  };
  const uint32_t outside = pores.maxima().size();
  for (const auto &maximum : pores.maxima()) list(maximum.point, listed.maxima);
  for (const auto &gate : pores.gates()) {
    list(gate.point, listed.gates);
    listed.ends.push_back({std::min(gate.end[0], outside), std::min(gate.end[1], outside)});
  }
  const hsp::ClassTree tree(pores.builder());
  listed.gate_between = [&](size_t a, size_t b) {
    ++seen.pairs;
    const auto end = [&](size_t k) { return k == outside ? hsp::pore_outside : static_cast<uint32_t>(k); };
    return tree.gate_between(end(a), end(b));
  };
  ASSERT_EQ(oracle::first_difference(oracle::brute_pores(outer, floor), listed), "") << oracle::to_text(outer);
}

// The number of components at levels between two neighbouring critical points that are a few steps apart, against the
// regions of the library's cells around balls grown by the level.
inline void compare_with_regions(const oracle::Balls &balls, Seen &seen) {
  const BuiltPores pores(balls);
  ASSERT_EQ(pores.status(), hsp::Status::ok) << oracle::to_text(balls);
  std::vector<double> levels;
  for (const auto &maximum : pores.maxima()) levels.push_back(maximum.point.level);
  for (const auto &gate : pores.gates()) levels.push_back(gate.point.level);
  std::sort(levels.begin(), levels.end());
  int64_t least = INT64_MAX, largest = 0;
  for (const auto &ball : balls) {
    least = std::min(least, ball.radius);
    largest = std::max(largest, ball.radius);
  }
  for (size_t k = 0; k + 1 < levels.size(); ++k) {
    const auto level = static_cast<int64_t>(std::llround(0.5 * (levels[k] + levels[k + 1])));
    if (levels[k + 1] - levels[k] < 4.0 || least + level <= 0 || largest + level >= INT64_C(1) << 30) continue;
    oracle::Balls grown = balls;
    for (auto &ball : grown) ball.radius += level;
    const BuiltFreeSpace space(grown);
    ASSERT_EQ(space.status(), hsp::Status::ok);
    ASSERT_EQ(pores.components(static_cast<double>(level)), static_cast<int>(space.space().region_count()))
        << "at " << level << " of " << oracle::to_text(balls);
    ++seen.levels;
    seen.regions += static_cast<int>(space.space().region_count());
  }
  seen.points += static_cast<int>(pores.maxima().size() + pores.gates().size());
}

}  // namespace checked_pores
