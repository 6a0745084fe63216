// The widest probe between two points, as the pores have it, against the regions of the complement of balls that are
// grown by a little less and a little more. The regions are those of the library's topology (hsp::region_of_point, by
// shells and rays): another way to the answer, but no independent oracle. The gate is checked by shrinking its three
// balls a little, which must let a wider probe through.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "built_pores.hpp"
#include "built_topology.hpp"
#include "pockets/class_tree.hpp"
#include "random_balls.hpp"
#include "topology/regions.hpp"

namespace checked_passage {

using hsp::no_id;
using hsp::exact::Vector;
using oracle::Balls;

class BuiltPassage {
 public:
  BuiltPassage(const Balls &balls, const Vector &from, const Vector *to) : pores_(balls, 0) {
    status_ = pores_.status();
    if (status_ == hsp::Status::ok) status_ = find_passage(pores_.builder(), pores_.grid(), from, to, 0, passage_);
    if (status_ != hsp::Status::ok || passage_.gate == no_id) return;
    for (uint32_t k = 0; k < 3; ++k) gate_[k] = pores_.gates()[passage_.gate].point.ball[k];
  }
  hsp::Status status() const { return status_; }
  bool passes() const { return passage_.passes; }
  double level() const { return passage_.level; }
  // The ball that stops wider probes at one of the two points, or no_id. gate(): the three balls that stop them at a
  // gate.
  uint32_t ball() const { return passage_.ball; }
  bool has_gate() const { return passage_.gate != no_id; }
  const std::array<uint32_t, 3> &gate() const { return gate_; }

 private:
  BuiltPores pores_;
  hsp::PorePassage passage_{};
  std::array<uint32_t, 3> gate_{};
  hsp::Status status_ = hsp::Status::ok;
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

// Whether two free points are in one region of the complement; null is the outside.
inline bool joined(const Balls &balls, const Vector &from, const Vector *to) {
  BuiltTopology topology(balls);
  EXPECT_EQ(topology.status(), hsp::Status::ok) << oracle::to_text(balls);
  return cell_of(topology, from) == (to == nullptr ? 0 : cell_of(topology, *to));
}

// How often a test has met each case: a gate between three balls is narrowest, or one of the two points is.
struct Seen {
  uint32_t gates = 0, touches = 0;
};

inline void check_among_random_balls(oracle::RandomSource &random, int sets, Seen &seen) {
  for (int k = 0; k < sets; ++k) {
    const int64_t size = 1000000;
    // A hollow whose wall has gaps, or balls at random in a box.
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
    const BuiltPassage built(balls, from, to);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    if (!built.passes()) {
      ASSERT_TRUE(at_ends <= 0.0 || !joined(balls, from, to)) << oracle::to_text(balls);
      ASSERT_TRUE(built.level() == 0.0 && !built.has_gate() && built.ball() == no_id);
      continue;
    }
    ASSERT_LE(built.level(), at_ends + 1e-6);
    const auto below = static_cast<int64_t>(std::floor(built.level())) - 1;
    if (below >= 0) {
      ASSERT_TRUE(joined(grown(balls, below), from, to)) << oracle::to_text(balls);
    }
    ASSERT_NE(built.has_gate(), built.ball() != no_id);
    if (!built.has_gate()) {
      ASSERT_LT(built.ball(), balls.size());
      const auto &ball = balls[built.ball()];
      const double there = to == nullptr ? INFINITY : distance(ball, *to);
      ASSERT_NEAR(std::min(distance(ball, from), there) - static_cast<double>(ball.radius), built.level(), 1e-6);
      ASSERT_NEAR(built.level(), at_ends, 1e-6);
      ++seen.touches;
      continue;
    }
    if (built.level() + 4.0 > at_ends) continue;
    Balls closed = grown(balls, below + 3);
    ASSERT_FALSE(joined(closed, from, to)) << oracle::to_text(balls);
    for (const uint32_t ball : built.gate()) closed[ball].radius -= 5;
    ASSERT_TRUE(joined(closed, from, to)) << oracle::to_text(balls);
    ++seen.gates;
  }
}

}  // namespace checked_passage
