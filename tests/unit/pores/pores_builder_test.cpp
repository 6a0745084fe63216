// Classes of free space: components at every level against regions of grown balls, merges in their order, and the same
// whatever order the balls have.
#include "pores/pores_builder.hpp"

#include <gtest/gtest.h>

#include "checked_pores.hpp"
#include "pore_widths.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::no_id;
using hsp::pore_outside;

TEST(PoresBuilder, ComponentsAtAllLevels) {
  oracle::RandomSource random(1);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::sets(36); ++turn) {
    const auto n = static_cast<size_t>(random.in(1, 16));
    ASSERT_NO_FATAL_FAILURE(
        checked_pores::compare_with_regions(pore_sets::general_set(random, n, turn % pore_sets::general_kinds), seen));
  }
  EXPECT_GT(seen.regions, seen.levels);
  seen = {};
  for (int turn = 0; turn < oracle::sets(40); ++turn) {
    const auto n = static_cast<size_t>(random.in(1, 16));
    ASSERT_NO_FATAL_FAILURE(
        checked_pores::compare_with_regions(pore_sets::tied_set(random, n, turn % pore_sets::tied_kinds), seen));
  }
  EXPECT_GT(seen.regions, seen.levels);
}

TEST(PoresBuilder, ComponentsOfCages) {
  oracle::RandomSource random(2);
  checked_pores::Seen seen;
  for (int kind = 0; kind < pore_sets::cage_kinds - 1; ++kind) {
    for (const double unit : {1e8, 1e7, 1e5}) {
      ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_regions(pore_sets::cage(random, kind, unit), seen));
    }
  }
  EXPECT_GT(seen.levels, 15);
}

TEST(PoresBuilder, WidestProbesBetweenPlaces) {
  oracle::RandomSource random(3);
  pore_widths::Seen seen;
  for (int turn = 0; turn < oracle::sets(12); ++turn) {
    ASSERT_NO_FATAL_FAILURE(pore_widths::compare_with_gates(random, turn % pore_sets::general_kinds, 4, seen));
  }
  EXPECT_GT(seen.pairs, 20);
  EXPECT_GT(seen.gates, 0);
}

// Each class dies at a gate below its birth, into an older one; merging gates and classes are the same; older first.
TEST(PoresBuilder, ClassesMergeIntoOlderOnes) {
  oracle::RandomSource random(4);
  for (int turn = 0; turn < oracle::sets(24); ++turn) {
    const bool tied = turn % 2 == 0;
    const oracle::Balls balls = tied ? pore_sets::tied_set(random, 14, turn / 2 % pore_sets::tied_kinds)
                                     : pore_sets::general_set(random, 24, turn / 2 % pore_sets::general_kinds);
    const BuiltPores pores(balls);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    uint32_t deaths = 0;
    for (uint32_t k = 0; k < pores.maxima().size(); ++k) {
      const hsp::PoreMaximum &maximum = pores.maxima()[k];
      // Down to -r_max one class is left, the outside.
      ASSERT_NE(maximum.gate, no_id);
      ++deaths;
      const hsp::PoreGate &gate = pores.gates()[maximum.gate];
      ASSERT_TRUE(gate.merges);
      ASSERT_LT(gate.point.level, maximum.point.level);
      ASSERT_TRUE(maximum.into == pore_outside || maximum.into < k);
      ASSERT_GE(pores.maxima()[k > 0 ? k - 1 : 0].point.level, maximum.point.level - 1e-6);
    }
    for (const hsp::PoreGate &gate : pores.gates()) deaths -= gate.merges ? 1 : 0;
    ASSERT_EQ(deaths, 0U);
  }
}

TEST(PoresBuilder, TheOrderOfTheBallsChangesNothing) {
  oracle::RandomSource random(5);
  for (int turn = 0; turn < oracle::sets(20); ++turn) {
    const oracle::Balls balls = turn % 2 == 0 ? pore_sets::tied_set(random, 14, turn / 2 % 4)
                                              : pore_sets::general_set(random, 24, turn / 2 % pore_sets::general_kinds);
    const std::vector<uint32_t> order = random.permutation(balls.size());
    const BuiltPores first(balls), second(oracle::permuted(balls, order));
    ASSERT_EQ(first.maxima().size(), second.maxima().size());
    ASSERT_EQ(first.gates().size(), second.gates().size());
    const auto same = [&](const hsp::CriticalPoint &a, const hsp::CriticalPoint &b) {
      ASSERT_EQ(a.level, b.level);
      ASSERT_EQ(a.position.x, b.position.x);
      ASSERT_EQ(a.position.y, b.position.y);
      ASSERT_EQ(a.position.z, b.position.z);
      ASSERT_EQ(a.tied, b.tied);
      for (uint32_t k = 0; k < a.tied; ++k) {
        // Of equal balls the one with the lower index is taken.
        ASSERT_EQ(balls[first.builder().tied(a)[k]], balls[order[second.builder().tied(b)[k]]]);
      }
    };
    for (uint32_t k = 0; k < first.maxima().size(); ++k) {
      ASSERT_NO_FATAL_FAILURE(same(first.maxima()[k].point, second.maxima()[k].point));
      ASSERT_EQ(first.maxima()[k].gate, second.maxima()[k].gate);
      ASSERT_EQ(first.maxima()[k].into, second.maxima()[k].into);
    }
    for (uint32_t k = 0; k < first.gates().size(); ++k) {
      ASSERT_NO_FATAL_FAILURE(same(first.gates()[k].point, second.gates()[k].point));
      for (const uint32_t side : {0U, 1U}) ASSERT_EQ(first.gates()[k].end[side], second.gates()[k].end[side]);
      ASSERT_EQ(first.gates()[k].merges, second.gates()[k].merges);
    }
  }
}

// A closed room: twelve balls around a hollow, which overlap so much that nothing gets out above level 0.
TEST(PoresBuilder, AClosedCavityLivesToTheFloor) {
  oracle::RandomSource random(6);
  oracle::Balls balls = pore_sets::cage(random, 1, 1e6);
  for (auto &ball : balls) ball.radius = 1300000;
  const BuiltPores closed(balls, 0);
  ASSERT_EQ(closed.status(), hsp::Status::ok);
  ASSERT_GE(closed.maxima().size(), 1U);
  EXPECT_EQ(closed.maxima()[0].gate, no_id);
  EXPECT_EQ(closed.maxima()[0].into, no_id);
  EXPECT_EQ(closed.components(0.0), 2);
  EXPECT_NEAR(closed.maxima()[0].point.level, std::sqrt(1.0 + 0.25 * std::pow(1.0 + std::sqrt(5.0), 2)) * 1e6 - 1.3e6,
              4.0);
  const BuiltPores open(balls);
  EXPECT_EQ(open.maxima()[0].into, pore_outside);
}

TEST(PoresBuilder, BallsInsideOthersAndEqualOnesCountOnce) {
  oracle::RandomSource random(7);
  const oracle::Balls balls = pore_sets::general_set(random, 20, 0);
  oracle::Balls more = balls;
  for (const auto &ball : balls) {
    more.push_back(ball);                                                                       // once more
    more.push_back({ball.x, ball.y, ball.z, ball.radius / 2});                                  // concentric
    more.push_back({ball.x + ball.radius / 2, ball.y, ball.z, ball.radius - ball.radius / 2});  // touching from within
  }
  const BuiltPores plain(balls), crowded(more);
  ASSERT_EQ(crowded.status(), hsp::Status::ok);
  EXPECT_EQ(crowded.builder().outer_balls(), plain.builder().outer_balls());
  ASSERT_EQ(crowded.gates().size(), plain.gates().size());
  for (uint32_t k = 0; k < plain.gates().size(); ++k) {
    ASSERT_EQ(crowded.gates()[k].point.level, plain.gates()[k].point.level);
    for (uint32_t b = 0; b < 3; ++b) ASSERT_EQ(crowded.gates()[k].point.ball[b], plain.gates()[k].point.ball[b]);
  }
}

// At some places many balls of all sizes, each a little beside it or not at all.
TEST(PoresBuilder, ManyBallsInsideOthers) {
  oracle::RandomSource random(8);
  for (int turn = 0; turn < 20; ++turn) {
    const int64_t shake = turn % 2 == 0 ? 0 : 3000000;
    oracle::Balls balls, places = oracle::balls_in_box(random, 6, 200000000, 1000000, 100000000);
    for (const auto &place : places) {
      for (int k = 0; k < 30; ++k) {
        const auto beside = [&](int64_t x) { return x + random.in(-shake, shake); };
        balls.push_back(
            {beside(place.x), beside(place.y), beside(place.z), place.radius - random.in(0, 3) * place.radius / 8});
      }
    }
    for (size_t k = balls.size(); k > 1; --k) {
      std::swap(balls[k - 1], balls[static_cast<size_t>(random.in(0, static_cast<int64_t>(k) - 1))]);
    }
    const oracle::Balls outer = oracle::outer_balls(balls);
    const BuiltPores pores(balls), alone(outer, BuiltPores::lowest(balls));
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    ASSERT_EQ(pores.builder().outer_balls(), outer.size());
    ASSERT_EQ(pores.maxima().size(), alone.maxima().size());
    ASSERT_EQ(pores.gates().size(), alone.gates().size());
    for (uint32_t k = 0; k < alone.gates().size(); ++k) {
      ASSERT_EQ(pores.gates()[k].point.level, alone.gates()[k].point.level);
      for (uint32_t b = 0; b < 3; ++b) {
        ASSERT_EQ(balls[pores.gates()[k].point.ball[b]], outer[alone.gates()[k].point.ball[b]]);
      }
    }
  }
}

TEST(PoresBuilder, FewBalls) {
  oracle::Balls balls;
  for (int n = 0; n <= 2; ++n) {
    const BuiltPores pores(balls);
    EXPECT_EQ(pores.status(), hsp::Status::ok);
    EXPECT_EQ(pores.maxima().size() + pores.gates().size(), 0U);
    EXPECT_EQ(pores.components(0.0), 1);
    balls.push_back({n * 1000, n, 2 * n, 100});
  }
  const oracle::Balls three{{0, 0, 0, 100}, {1000, 0, 0, 100}, {0, 1000, 0, 100}};
  const BuiltPores pores(three);
  // The middle of the longest side ties with the third ball: a right angle, where f has neither gate nor maximum.
  EXPECT_EQ(pores.gates().size(), 0U);
  const oracle::Balls acute{{0, 0, 0, 100}, {1000, 0, 0, 100}, {500, 800, 0, 100}};
  EXPECT_EQ(BuiltPores(acute).gates().size(), 1U);
}

constexpr uint32_t hsp::PoreLimits::*all_limits[] = {&hsp::PoreLimits::balls,      &hsp::PoreLimits::maxima,
                                                     &hsp::PoreLimits::gates,      &hsp::PoreLimits::tied,
                                                     &hsp::PoreLimits::candidates, &hsp::PoreLimits::near};

TEST(PoresBuilder, EveryLimitIsReportedAndTakenBack) {
  oracle::Balls balls;
  for (int k = 0; k < 8; ++k) balls.push_back({(k & 1) * 1000, (k >> 1 & 1) * 1000, (k >> 2) * 1000, 300});
  BuiltPores whole(balls);
  ASSERT_EQ(whole.status(), hsp::Status::ok);
  const auto gates = whole.gates().size();
  for (uint32_t hsp::PoreLimits::*limit : all_limits) {
    hsp::PoreLimits limits = whole.limits();
    limits.*limit = 0;
    hsp::Status status = whole.build(limits, BuiltPores::lowest(balls));
    EXPECT_EQ(whole.gates().size(), 0U);
    EXPECT_EQ(status, hsp::Status::capacity);
    for (int retry = 0; retry < 40 && status == hsp::Status::capacity; ++retry) {
      limits = whole.builder().retry_limits();
      status = whole.build(limits, BuiltPores::lowest(balls));
    }
    EXPECT_EQ(status, hsp::Status::ok);
    EXPECT_EQ(whole.gates().size(), gates);
  }
}

// The needed limits suffice, and one less of any of them does not.
TEST(PoresBuilder, WhatWasNeededIsNoMoreThanThat) {
  oracle::RandomSource random(8);
  for (int turn = 0; turn < 6; ++turn) {
    const oracle::Balls balls = turn == 0       ? pore_sets::cage(random, 1, 1e6)
                                : turn % 2 == 0 ? pore_sets::tied_set(random, 14, turn / 2)
                                                : pore_sets::general_set(random, 60, turn);
    const int64_t floor = BuiltPores::lowest(balls);
    BuiltPores whole(balls);
    ASSERT_EQ(whole.status(), hsp::Status::ok);
    const hsp::PoreLimits needed = whole.builder().needed();
    ASSERT_EQ(whole.build(needed, floor), hsp::Status::ok);
    for (uint32_t hsp::PoreLimits::*limit : all_limits) {
      ASSERT_EQ(whole.builder().needed().*limit, needed.*limit);
    }
    for (uint32_t hsp::PoreLimits::*limit : all_limits) {
      if (needed.*limit == 0) continue;
      hsp::PoreLimits less = needed;
      --(less.*limit);
      ASSERT_EQ(whole.build(less, floor), hsp::Status::capacity);
      ASSERT_GT(whole.builder().retry_limits().*limit, less.*limit);
    }
  }
}

}  // namespace
