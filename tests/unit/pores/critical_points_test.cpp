// All maxima and gates, held against all sets of three and four, and against Euler's sum: with the outside and the gaps
// of pairs, maxima + 1 - gates + gaps - balls is 0 if nothing is missing, ties or not.
#include "pores/critical_points.hpp"

#include <gtest/gtest.h>

#include "brute_pores.hpp"
#include "checked_pores.hpp"
#include "sweep_length.hpp"

namespace {

using checked_pores::FoundPoints;
using hsp::no_id;

TEST(CriticalPoints, AllSetsOfThreeAndFour) {
  oracle::RandomSource random(1);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::sets(60); ++turn) {
    const auto n = static_cast<size_t>(random.in(3, 14));
    const int kind = turn / 2;
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(
        turn % 2 == 0 ? pore_sets::general_set(random, n, kind % pore_sets::general_kinds)
                      : pore_sets::tied_set(random, n, kind % pore_sets::tied_kinds),
        seen));
  }
  EXPECT_GT(seen.points, 100 / oracle::sets_for_one);
  EXPECT_GT(seen.pairs, 20 / oracle::sets_for_one);
}

TEST(CriticalPoints, EulerSumsOfTiedSets) {
  oracle::RandomSource random(2);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::sets(100); ++turn) {
    const oracle::Balls balls =
        pore_sets::tied_set(random, static_cast<size_t>(random.in(1, 14)), turn % pore_sets::tied_kinds);
    ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(balls, seen));
  }
  EXPECT_GT(seen.tied, 4 / oracle::sets_for_one);
}

TEST(CriticalPoints, EulerSumsOfCages) {
  oracle::RandomSource random(3);
  checked_pores::Seen seen;
  for (int kind = 0; kind < pore_sets::cage_kinds - 1; ++kind) {
    for (const double unit : {1e8, 1e5}) {
      ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(pore_sets::cage(random, kind, unit), seen));
    }
  }
  EXPECT_GT(seen.points, 100);
}

// A cube of eight balls: one maximum in the middle, of eight, and a gate in each side, of four.
TEST(CriticalPoints, ACubeThatTies) {
  oracle::Balls balls;
  for (int k = 0; k < 8; ++k) balls.push_back({(k & 1) * 1000, (k >> 1 & 1) * 1000, (k >> 2) * 1000, 300});
  const FoundPoints found(balls, 0);
  ASSERT_EQ(found.status(), hsp::Status::ok);
  ASSERT_EQ(found.points().maxima().size(), 1U);
  const hsp::CriticalPoint &middle = found.points().maxima()[0].point;
  EXPECT_EQ(middle.tied, 8U);
  EXPECT_NEAR(middle.level, 500.0 * std::sqrt(3.0) - 300.0, 1e-6);
  EXPECT_NEAR(middle.position.x, 500.0, 1e-9);
  EXPECT_EQ(found.points().tied().size(), 8U + 6 * 4);
  ASSERT_EQ(found.points().gates().size(), 6U);
  for (const hsp::PoreGate &gate : found.points().gates().items()) {
    EXPECT_EQ(gate.point.tied, 4U);
    EXPECT_EQ(gate.point.ball[3], no_id);
    EXPECT_NEAR(gate.point.level, 500.0 * std::sqrt(2.0) - 300.0, 1e-6);
  }
}

// As many as a cube can see at once, and nearly; and more.
// Two rectangles of four balls a small way apart: all eight tie at a maximum between them, which is in the plane of
// some three, too, and each four at a gate in their own.
TEST(CriticalPoints, TwoRectanglesSideBySide) {
  checked_pores::Seen seen;
  for (int64_t apart = 200000; apart <= 500000; apart += 25000) {
    oracle::Balls balls;
    for (const int64_t x : {0, 200000000}) {
      for (const int64_t z : {0, 100000000}) {
        for (const int64_t y : {int64_t{0}, apart}) balls.push_back({x, y, z, 100000000});
      }
    }
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(balls, seen)) << apart;
  }
}

TEST(CriticalPoints, ManyBallsThatTie) {
  for (const int64_t square : {26, 101}) {
    const oracle::Balls shell = pore_sets::shell(1000, 300, square);
    ASSERT_EQ(shell.size(), square == 26 ? 72U : 168U);
    for (const uint32_t n : {55U, 56U, 57U, 63U, 64U, 65U, 72U, 100U, 167U, 168U}) {
      if (n > shell.size() || (square == 101 && n < 100)) continue;
      const FoundPoints found({shell.begin(), shell.begin() + n}, 0);
      ASSERT_EQ(found.status(), hsp::Status::ok);
      ASSERT_GT(found.points().maxima().size(), 0U);
      const hsp::CriticalPoint &middle = found.points().maxima()[0].point;
      EXPECT_EQ(middle.tied, n);
      EXPECT_NEAR(middle.level, 1000.0 * std::sqrt(static_cast<double>(square)) - 300.0, 1e-6);
    }
  }
}

// Parts of such shells: bowls whose middle is no critical point, rings whose middle is a gate. Moved by a step they tie
// nearly.
TEST(CriticalPoints, PartsOfShellsByAllSets) {
  oracle::RandomSource random(6);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::sets(60); ++turn) {
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(
        pore_sets::part_of_shell(random, turn % pore_sets::shell_kinds, static_cast<size_t>(random.in(6, 16)),
                                 turn % 4 < 2 ? 25 : 26, random.in(0, 3) / 2),
        seen));
  }
  EXPECT_GT(seen.tied, 4 / oracle::sets_for_one);
}
TEST(CriticalPoints, EulerSumsOfPartsOfShells) {
  oracle::RandomSource random(7);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::sets(16); ++turn) {
    const int64_t square = turn % 4 == 0 ? 101 : turn % 4 == 1 ? 50 : 41;
    ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(
        pore_sets::part_of_shell(random, turn % pore_sets::shell_kinds, static_cast<size_t>(random.in(40, 168)), square,
                                 random.in(0, 2)),
        seen));
  }
  EXPECT_GT(seen.tied, 4 / oracle::sets_for_one);
}

// Rings whose coordinates have so many decimals tie exactly in parts, and nearly as a whole.
TEST(CriticalPoints, RingsByAllSets) {
  checked_pores::Seen seen;
  for (int kind = 0; kind < pore_sets::ring_kinds; ++kind) {
    for (const size_t n : {6U, 7U, 8U, 12U}) {
      if (pore_sets::ring_set(kind, n, 8).size() > 16) continue;
      for (int decimals = 3 + kind % 3; decimals <= 8; decimals += 3) {
        ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(pore_sets::ring_set(kind, n, decimals), seen));
      }
    }
  }
  EXPECT_GT(seen.tied, 20);
}

// Questions for the exact stage grow as the balls do, and so do the cubes; whatever ties.
TEST(CriticalPoints, RingsTakeFewQuestions) {
  checked_pores::Seen seen;
  for (int kind = 0; kind < pore_sets::ring_kinds; ++kind) {
    for (const size_t n : {16U, 20U, 60U, 200U, 1000U}) {
      for (int decimals = n >= 200 ? 8 : 3; decimals <= 8; ++decimals) {
        const oracle::Balls balls = pore_sets::ring_set(kind, n, decimals);
        const FoundPoints found(balls, 0);
        ASSERT_EQ(found.status(), hsp::Status::ok);
        const auto size = static_cast<double>(balls.size());
        EXPECT_LT(static_cast<double>(found.points().lines().questions()), 500.0 + 12.0 * size * std::log2(size))
            << kind << ' ' << n << ' ' << decimals;
        EXPECT_LT(static_cast<double>(found.points().work().cubes), 4000.0 + 250.0 * size)
            << kind << ' ' << n << ' ' << decimals;
        if (n < 30 && decimals == 3 + kind % 6) {
          ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(balls, seen));
        }
      }
    }
  }
}

// Points of a lattice on a circle tie exactly, alone and with balls on the axis.
TEST(CriticalPoints, ExactCirclesTakeFewQuestions) {
  checked_pores::Seen seen;
  for (const int64_t root : {25, 65, 325, 1105}) {
    for (int poles = 0; poles < 3; ++poles) {
      const oracle::Balls balls = pore_sets::exact_circle(root, 100000, 1000, poles);
      const FoundPoints found(balls, 0);
      ASSERT_EQ(found.status(), hsp::Status::ok);
      const auto size = static_cast<double>(balls.size());
      EXPECT_LT(static_cast<double>(found.points().lines().questions()), 500.0 + 12.0 * size * std::log2(size))
          << root << ' ' << poles;
      EXPECT_EQ(found.points().maxima().size(), poles == 2 ? 1U : 0U);
      const auto on_axis = static_cast<uint32_t>(poles), around = static_cast<uint32_t>(balls.size()) - on_axis;
      EXPECT_EQ(found.points().gates().size(), poles == 0 ? 1 : on_axis * around);
      if (poles == 2) {
        EXPECT_EQ(found.points().maxima()[0].point.tied, balls.size());
      }
      if (root < 1105) {
        ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(balls, seen));
      }
    }
  }
}

// Crowns that are some steps high: all tie in the middle, and sets that are nearly flat do so again beside it.
TEST(CriticalPoints, LowCrownsByAllSets) {
  oracle::RandomSource random(8);
  checked_pores::Seen seen;
  for (int turn = 0; turn < 8; ++turn) {
    const int64_t most = turn % 4 + 1;
    oracle::Balls balls = pore_sets::exact_circle(5, 50000000, 100000000, turn % 3);
    for (auto &ball : balls) {
      if (ball.z == 0) ball.z = turn % 2 == 0 ? most * (random.one_in(2) ? 1 : -1) : random.in(-most, most);
    }
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(balls, seen));
  }
  EXPECT_GT(seen.tied, 4);
}

// Clusters of balls that are some steps wide and very far apart: in the middle between two of them the directions to
// the balls are opposite but for what the distance leaves of some steps.
TEST(CriticalPoints, ClustersFarApart) {
  oracle::RandomSource random(9);
  checked_pores::Seen seen;
  for (int turn = 0; turn < 24; ++turn) {
    oracle::Balls balls;
    for (int k = 0; k < 8; ++k) {
      const int64_t away = k % 2 == 0 ? 0 : INT64_C(1) << 43;
      const auto near = [&] { return random.in(-3, 3); };
      balls.push_back({near() + away, near() + (turn % 3 > 0 ? away / (turn + 1) : 0), near() + away / 7 * (turn % 4),
                       turn % 2 == 0 ? 1 : random.in(0, 2)});
    }
    const FoundPoints found(oracle::outer_balls(balls), -3);
    EXPECT_LT(found.points().work().cubes, 1000U) << turn;
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(balls, seen));
  }
  EXPECT_GT(seen.points, 24);
}

// Two plates, three posts: balls in planes, or on lines, that are far apart beside the distances of the balls. Between
// them all distances differ by less than rounding.
TEST(CriticalPoints, PlatesAndPostsFarApart) {
  oracle::RandomSource random(10);
  checked_pores::Seen seen;
  for (int turn = 0; turn < 40; ++turn) {
    const int64_t away = turn % 4 == 0 ? 10000000 : turn % 4 == 1 ? 300000000 : INT64_C(1) << (33 + turn % 7);
    const int64_t wide = turn % 3 == 0 ? 3 : 40;
    oracle::Balls balls;
    for (int k = 0; k < (turn % 4 == 0 ? 16 : 12); ++k) {
      const bool is_post = turn % 5 == 4;
      const int64_t x = is_post ? away * random.in(0, 2) / 2 : random.in(-wide, wide);
      const int64_t y = is_post ? away * random.in(0, 1) : random.in(-wide, wide);
      balls.push_back({x, y, is_post ? random.in(-wide, wide) : away * (k % 2), 0});
    }
    const FoundPoints found(oracle::outer_balls(balls), -1);
    EXPECT_LT(found.points().work().cubes, 20000U) << turn;
    EXPECT_LT(found.points().work().quadruples, 20000U) << turn;
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(balls, seen));
  }
  EXPECT_GT(seen.points, 40);
}

// Rings and shells so wide that doubles do not tell distances from them to 2^-8 of a step. n balls have n^4 / 24 sets
// of four.
TEST(CriticalPoints, WideRingsTakeFewQuestions) {
  oracle::RandomSource random(11);
  for (const uint32_t n : {16U, 40U}) {
    for (const bool is_shell : {false, true}) {
      oracle::Balls balls;
      for (uint32_t k = 0; k < n; ++k) {
        const double turn = 6.283185307179586 * k / n,
                     up = is_shell ? 0.01 * static_cast<double>(random.in(-90, 90)) : 0.0;
        const double across = 1e13 * std::sqrt(1.0 - up * up);
        balls.push_back(
            {std::llround(across * std::cos(turn)), std::llround(across * std::sin(turn)), std::llround(1e13 * up), 0});
      }
      const FoundPoints found(balls, -1);
      ASSERT_EQ(found.status(), hsp::Status::ok);
      EXPECT_LT(found.points().lines().questions(), 150U * n) << n << ' ' << is_shell;
    }
  }
}

// Points of the floor's own level are not above it.
TEST(CriticalPoints, FloorsAreStrict) {
  // A ring of four around the origin, at 500 from it, and two on the axis at 500: an octahedron of level 400.
  const oracle::Balls balls{{500, 0, 0, 100},  {-500, 0, 0, 100}, {0, 500, 0, 100},
                            {0, -500, 0, 100}, {0, 0, 500, 100},  {0, 0, -500, 100}};
  EXPECT_EQ(FoundPoints(balls, 399).points().maxima().size(), 1U);
  EXPECT_EQ(FoundPoints(balls, 400).points().maxima().size(), 0U);
}

TEST(CriticalPoints, FewBallsHaveNone) {
  for (size_t n = 0; n < 3; ++n) {
    oracle::Balls balls;
    for (size_t k = 0; k < n; ++k) balls.push_back({static_cast<int64_t>(1000 * k), 0, 0, 10});
    const FoundPoints found(balls, -11);
    EXPECT_EQ(found.status(), hsp::Status::ok);
    EXPECT_EQ(found.points().maxima().size() + found.points().gates().size(), 0U);
  }
}

TEST(CriticalPoints, EveryLimitIsReported) {
  oracle::RandomSource random(4);
  const oracle::Balls balls = pore_sets::general_set(random, 40, 0);
  const FoundPoints whole(balls, -200000000);
  ASSERT_EQ(whole.status(), hsp::Status::ok);
  const hsp::PoreLimits needed = whole.points().needed();
  for (uint32_t hsp::PoreLimits::*limit :
       {&hsp::PoreLimits::maxima, &hsp::PoreLimits::gates, &hsp::PoreLimits::candidates}) {
    for (const uint32_t value : {0U, 1U, needed.*limit - 1}) {
      hsp::PoreLimits limits = FoundPoints::roomy(balls);
      limits.*limit = value;
      const FoundPoints found(balls, -200000000, limits);
      EXPECT_EQ(found.status(), hsp::Status::capacity);
      EXPECT_GT(found.points().needed().*limit, value);
    }
  }
}

}  // namespace
