// Ways up end at maxima that are higher than where they begin, and where they are known to lead.
#include "pores/way_up.hpp"

#include <gtest/gtest.h>

#include "checked_pores.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::no_id;
using hsp::pore_outside;

// A tetrahedron of balls: from each of four gates one side leads to the middle, the other one out.
TEST(WayUp, IntoATetrahedronAndOut) {
  const oracle::Balls balls{
      {1000, 1000, 1000, 900}, {1000, -1000, -1000, 910}, {-1000, 1000, -1000, 920}, {-1000, -1000, 1000, 930}};
  const BuiltPores pores(balls);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  ASSERT_EQ(pores.maxima().size(), 1U);
  ASSERT_EQ(pores.gates().size(), 4U);
  for (const auto &gate : pores.gates()) {
    // On the side where its three turn counter-clockwise seen from, that is of (b - a) x (c - a).
    const auto at = [&](uint32_t k) { return balls[gate.point.ball[k]]; };
    const oracle::Vector normal = oracle::cross(centre_difference(at(0), at(1)), centre_difference(at(0), at(2)));
    const oracle::Vector inward{-at(0).x, -at(0).y, -at(0).z};
    const bool first_inward = oracle::dot(normal, inward) > 0;
    EXPECT_EQ(gate.end[first_inward ? 0 : 1], 0U);
    EXPECT_EQ(gate.end[first_inward ? 1 : 0], pore_outside);
  }
}

// Three balls, the middle one small: the curve of the three is an ellipse, at whose top no further ball is.
TEST(WayUp, OverTheTopOfAnEllipse) {
  const oracle::Balls balls{{-1000, 0, 0, 800}, {1000, 0, 0, 800}, {0, 250, 0, 20}};
  const BuiltPores pores(balls);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  EXPECT_EQ(pores.maxima().size(), 0U);
  for (const auto &gate : pores.gates()) {
    EXPECT_EQ(gate.end[0], pore_outside);
    EXPECT_EQ(gate.end[1], pore_outside);
    EXPECT_FALSE(gate.merges);
  }
  EXPECT_EQ(pores.gates().size(), 1U);
}

// The same between walls: beyond the top the way goes on between two balls, to where others are.
TEST(WayUp, ManyTopsAmongUnequalBalls) {
  oracle::RandomSource random(1);
  checked_pores::Seen seen;
  for (int turn = 0; turn < oracle::sets(60); ++turn) {
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_regions(pore_sets::general_set(random, 14, 2), seen));
  }
  EXPECT_GT(seen.levels, 100);
}

void check_ways(const BuiltPores &pores) {
  for (const auto &gate : pores.gates()) {
    for (const uint32_t end : gate.end) {
      ASSERT_NE(end, no_id);
      if (end == pore_outside) continue;
      ASSERT_GE(pores.maxima()[end].point.level, gate.point.level);
    }
  }
}

TEST(WayUp, EndsAreHigher) {
  oracle::RandomSource random(2);
  for (int turn = 0; turn < oracle::sets(20); ++turn) {
    const BuiltPores pores(pore_sets::general_set(random, 30, turn % pore_sets::general_kinds));
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    ASSERT_NO_FATAL_FAILURE(check_ways(pores));
  }
}

// Ways past three balls so close together that one sees them in nearly one direction from where they tie with a fourth.
TEST(WayUp, PastBallsThatAreCloseTogether) {
  checked_pores::Seen seen;
  const oracle::Balls sets[] = {{{9999999, 3, 1, 0},
                                 {-5000002, -8660253, -2, 1},
                                 {-1, -3, 10000002, 1},
                                 {-1, 1, 9999997, 1},
                                 {3, 1, 10000002, 1}},
                                {{134, -829, -9648634715, 653},
                                 {392, 922, -9648634722, 933},
                                 {-291, 581, -9648633966, 863},
                                 {2621744689, -148, -10000000279, 168},
                                 {-3893122742, -10000000623, 127, 813}}};
  for (const oracle::Balls &balls : sets) {
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(balls, seen));
  }
  oracle::RandomSource random(3);
  for (int turn = 0; turn < oracle::sets(200); ++turn) {
    const int64_t away = turn % 2 == 0 ? 10000000 : 1000000000, wide = turn % 3 == 0 ? 3 : 300;
    oracle::Balls balls;
    for (int k = 0; k < 7; ++k) {
      const auto near = [&] { return random.in(-wide, wide); };
      balls.push_back({near() + (k % 3 == 1 ? away : 0), near() + (k % 3 == 2 ? away : 0),
                       near() + (k % 3 == 0 ? away / 2 : 0), random.in(0, wide / 2)});
    }
    ASSERT_NO_FATAL_FAILURE(checked_pores::compare_with_all_sets(balls, seen));
  }
}

// From a ring of balls with others on its axis all ways lead through points where all tie, with the point in the plane
// of the ring or beside it: at each some questions a ball are asked.
TEST(WayUp, TiesTakeFewQuestions) {
  checked_pores::Seen seen;
  for (const int64_t root : {25, 65, 325}) {
    for (const int poles : {0, 1, 2}) {
      for (const int64_t up : {0, 1, -1, 1000, 30000000}) {
        oracle::Balls balls = pore_sets::exact_circle(root, 1250000000 / root, 500000000, poles);
        for (auto &ball : balls) ball.z += ball.z > 0 ? up : ball.z < 0 ? -up : 0;
        const BuiltPores pores(balls);
        ASSERT_EQ(pores.status(), hsp::Status::ok);
        const auto ring = static_cast<double>(balls.size()) - poles;
        const auto points = static_cast<double>(pores.maxima().size() + pores.gates().size());
        EXPECT_LT(static_cast<double>(pores.builder().questions()), 500.0 + points * 12.0 * ring) << root << ' ' << up;
        // Poles that are nearer to the middle than the ring leave maxima beside it.
        const uint32_t expected = poles == 0 ? 0 : poles == 1 ? (up > 0 ? 1 : 0) : up > 0 ? 2 : 1;
        EXPECT_EQ(pores.maxima().size(), poles == 2 && up < 0 ? static_cast<uint32_t>(ring) : expected)
            << root << ' ' << poles << ' ' << up;
        ASSERT_NO_FATAL_FAILURE(check_ways(pores));
        if (root == 25) {
          ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(balls, seen));
        }
      }
    }
  }
}

// Balls of four sizes that touch one circle from outside, between two large ones: off its plane the largest are the
// nearest.
TEST(WayUp, UnequalBallsThatTieOnACircle) {
  for (const int64_t root : {5, 25, 65}) {
    for (uint32_t turn = 0; turn < 4; ++turn) {
      const int64_t step = 1000000, size = root * step;
      oracle::Balls balls = pore_sets::exact_circle(root, step, step / 2, 0);
      uint32_t which = turn;
      for (auto &ball : balls) {
        const int64_t times = 1 + (which * 7 + which / 3) % 4;
        ball = {times * ball.x, times * ball.y, 0, ball.radius + (times - 1) * size};
        ++which;
      }
      for (const int64_t side : {1, -1}) balls.push_back({0, 0, 20 * side * size, 5 * size});
      checked_pores::Seen seen;
      ASSERT_NO_FATAL_FAILURE(checked_pores::check_euler_sum(oracle::outer_balls(balls), seen));
      const BuiltPores pores(balls, 0);
      ASSERT_EQ(pores.status(), hsp::Status::ok);
      ASSERT_GT(pores.gates().size(), 0U);
      ASSERT_NO_FATAL_FAILURE(check_ways(pores));
      for (const auto &gate : pores.gates()) {
        if (gate.point.tied > 8) {
          EXPECT_LT(pores.builder().questions(), 500.0 + 200.0 * static_cast<double>(balls.size()));
        }
      }
    }
  }
}

}  // namespace
