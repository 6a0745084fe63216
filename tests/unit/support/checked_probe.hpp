// The widest probe, held against the cells of the complement of balls grown by a little less and a little more, which
// the topology finds by shells and rays; the gate, by taking its balls back a little.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "built_grid.hpp"
#include "built_topology.hpp"
#include "carved_memory.hpp"
#include "lattice_lengths.hpp"
#include "paths/widest_probe.hpp"
#include "random_balls.hpp"
#include "topology/regions.hpp"

namespace checked_probe {

using hsp::no_id;
using hsp::exact::Vector;
using oracle::Balls;

class BuiltProbe {
 public:
  BuiltProbe(const Balls &balls, const Vector &from, const Vector *to) : grid_(oracle::in_lengths(balls, 1)) {
    hsp::ProbeLimits limits{{}, static_cast<uint32_t>(balls.size())};
    static_cast<void>(hsp::default_limits(limits.balls, limits.cells));
    do {
      memory_.carve(finder_, limits);
      status_ = finder_.find(grid_.grid().balls(), from, to, widest_);
      limits = finder_.retry_limits();
    } while (status_ == hsp::Status::capacity && ++retries_ < 40);
  }
  hsp::Status status() const { return status_; }
  const hsp::WidestProbe &widest() const { return widest_; }
  uint32_t builds() const { return finder_.builds(); }
  // Whether what it says it needed suffices for the same once more.
  bool suffices_again(const Vector &from, const Vector *to) {
    const hsp::ProbeLimits needed = finder_.needed();
    CarvedMemory memory;
    hsp::WidestProbeFinder again;
    hsp::WidestProbe widest{};
    memory.carve(again, needed);
    return again.find(grid_.grid().balls(), from, to, widest) == hsp::Status::ok && widest.radius == widest_.radius;
  }

 private:
  BuiltGrid grid_;
  CarvedMemory memory_;
  hsp::WidestProbeFinder finder_;
  hsp::WidestProbe widest_{};
  hsp::Status status_ = hsp::Status::ok;
  uint32_t retries_ = 0;
};

inline double distance(const oracle::LatticeBall &ball, const Vector &point) {
  return std::hypot(static_cast<double>(ball.x - point.x), static_cast<double>(ball.y - point.y),
                    static_cast<double>(ball.z - point.z));
}

inline double room(const Balls &balls, const Vector &point) {
  double least = INFINITY;
  for (const auto &ball : balls) least = std::min(least, distance(ball, point) - static_cast<double>(ball.radius));
  return least;
}

inline Balls grown(Balls balls, int64_t by) {
  for (auto &ball : balls) ball.radius += by;
  return balls;
}

inline uint32_t cell_of(BuiltTopology &topology, const Vector &point) {
  return hsp::region_of_point(topology.grid(), topology.boundary(), topology.structure(), point);
}

// Of free points; null is the outside.
inline bool joined(const Balls &balls, const Vector &from, const Vector *to) {
  BuiltTopology topology(balls);
  return cell_of(topology, from) == (to == nullptr ? 0 : cell_of(topology, *to));
}

// The cases that a test has met: passages between three balls, and points that are tighter than all of them.
struct Seen {
  uint32_t gates = 0, touches = 0;
};

inline void check_among_random_balls(oracle::RandomSource &random, int sets, Seen &seen) {
  for (int k = 0; k < sets; ++k) {
    const int64_t size = 1000000;
    // A hollow whose wall has gaps, or a heap.
    const bool hollow = random.one_in(2);
    Balls balls = oracle::balls_in_box(random, static_cast<size_t>(random.in(40, 80)), 3 * size, size / 2, size);
    for (auto &ball : balls) {
      if (!hollow) continue;
      const double scale = 3e6 / std::max(1.0, distance(ball, {0, 0, 0}));
      for (int64_t *value : {&ball.x, &ball.y, &ball.z}) {
        *value = static_cast<int64_t>(scale * static_cast<double>(*value));
      }
    }
    const auto draw = [&](int64_t reach) {
      Vector point{};
      for (int attempt = 0; attempt == 0 || (attempt < 60 && room(balls, point) <= 0.0); ++attempt) {
        point.x = random.in(-reach, reach);
        point.y = random.in(-reach, reach);
        point.z = random.in(-reach, reach);
      }
      return point;
    };
    const Vector from = draw(hollow ? size / 2 : 2 * size);
    const Vector other = draw(2 * size);
    const Vector *const to = random.one_in(2) ? nullptr : &other;
    const double at_ends = std::min(room(balls, from), to == nullptr ? INFINITY : room(balls, *to));
    BuiltProbe built(balls, from, to);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_LE(built.builds(), 40U);
    EXPECT_TRUE(built.suffices_again(from, to));
    const hsp::WidestProbe &widest = built.widest();
    if (!widest.passes) {
      ASSERT_TRUE(at_ends <= 0.0 || !joined(balls, from, to)) << oracle::to_text(balls);
      continue;
    }
    ASSERT_LE(widest.radius, at_ends + 1e-6);
    const auto below = static_cast<int64_t>(std::floor(widest.radius)) - 1;
    if (below >= 0) {
      ASSERT_TRUE(joined(grown(balls, below), from, to)) << oracle::to_text(balls);
    }
    if (widest.gate[1] == no_id) {
      ASSERT_LT(widest.gate[0], balls.size());
      const auto &ball = balls[widest.gate[0]];
      const double there = to == nullptr ? INFINITY : distance(ball, *to);
      ASSERT_NEAR(std::min(distance(ball, from), there) - static_cast<double>(ball.radius), widest.radius, 1e-6);
      ASSERT_NEAR(widest.radius, at_ends, 1e-6);
      ++seen.touches;
      continue;
    }
    ASSERT_LT(widest.gate[0], widest.gate[1]);
    ASSERT_LT(widest.gate[1], widest.gate[2]);
    ASSERT_LT(widest.gate[2], balls.size());
    if (widest.radius + 4.0 > at_ends) continue;
    Balls closed = grown(balls, below + 3);
    ASSERT_FALSE(joined(closed, from, to)) << oracle::to_text(balls);
    for (const uint32_t ball : widest.gate) closed[ball].radius -= 5;
    ASSERT_TRUE(joined(closed, from, to)) << oracle::to_text(balls);
    ++seen.gates;
  }
}

}  // namespace checked_probe
