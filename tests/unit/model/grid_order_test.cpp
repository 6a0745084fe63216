// The order of the balls in the grid, against a sort by cube and rank: sets with all sizes of gaps, with many balls in
// one cube and with ties, in every order of the input.
#include "model/grid_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

hsp::Span<uint32_t> span_of(std::vector<uint32_t> &entries) {
  return {entries.data(), static_cast<uint32_t>(entries.size())};
}

struct Set {
  explicit Set(const std::vector<hsp::exact::LatticeBall> &given) : n(static_cast<uint32_t>(given.size())) {
    memory.carve(balls, n);
    balls.n = n;
    for (uint32_t i = 0; i < n; ++i) balls.store(i, given[i]);
  }
  uint32_t n;
  CarvedMemory memory;
  hsp::BallSet balls;
};

struct SourceOf {
  const hsp::BallSet &balls;

  hsp::exact::LatticeBall ball(uint32_t i) const { return balls.ball(i); }
  hsp::exact::Vector centre(uint32_t i) const { return ball(i).centre; }
};

hsp::LatticeBox box_around(const std::vector<hsp::exact::LatticeBall> &balls) {
  hsp::LatticeBox box;
  if (!balls.empty()) box = {balls[0].centre, balls[0].centre};
  for (const hsp::exact::LatticeBall &ball : balls) {
    box.low = {std::min(box.low.x, ball.centre.x), std::min(box.low.y, ball.centre.y),
               std::min(box.low.z, ball.centre.z)};
    box.high = {std::max(box.high.x, ball.centre.x), std::max(box.high.y, ball.centre.y),
                std::max(box.high.z, ball.centre.z)};
  }
  return box;
}

std::vector<uint32_t> balls_of(const hsp::GridOrder &order) {
  std::vector<uint32_t> balls(order.size());
  for (uint32_t k = 0; k < order.size(); ++k) balls[k] = order.ball(k);
  return balls;
}

void expect_order(std::vector<hsp::exact::LatticeBall> given, int64_t side, uint32_t spare_counters) {
  for (uint32_t i = 0; i < given.size(); ++i) given[i].index = i;
  const Set set(given);
  const hsp::CubeAxis axis(side);
  std::vector<uint32_t> expected(set.n);
  std::iota(expected.begin(), expected.end(), 0U);
  const auto cube = [&](uint32_t i) {
    const hsp::CubeCoordinates at = axis.cube_at(given[i].centre);
    return std::tuple(at.z, at.y, at.x);
  };
  std::sort(expected.begin(), expected.end(), [&](uint32_t a, uint32_t b) {
    return cube(a) != cube(b) ? cube(a) < cube(b) : hsp::exact::ranks_before(given[a], given[b]);
  });
  std::vector<uint32_t> entries(2 * set.n), other_entries(2 * set.n), counters(4 + spare_counters);
  hsp::Patience patience;
  const hsp::GridOrder found = hsp::grid_order(SourceOf{set.balls}, box_around(given), axis,
                                               {span_of(entries), span_of(other_entries), span_of(counters)}, patience);
  const auto where = [&] {
    return std::to_string(set.n) + " balls, side " + std::to_string(side) + ", " + std::to_string(counters.size()) +
           " counters";
  };
  EXPECT_EQ(found.entries.data(), entries.data());
  for (uint32_t k = 0; found.keys_tell_cubes && k < set.n;) k = sort_slice(SourceOf{set.balls}, found, k).last;
  EXPECT_EQ(balls_of(found), expected) << where();
  const auto expect_keys = [&](const hsp::GridOrder &order) {
    for (uint32_t k = 1; order.keys_tell_cubes && k < set.n; ++k) {
      ASSERT_EQ(order.cube_key(k - 1) == order.cube_key(k), cube(expected[k - 1]) == cube(expected[k])) << where();
    }
  };
  expect_keys(found);
  const hsp::GridOrder compared = hsp::grid_order_by_comparing(set.balls, axis, span_of(entries));
  EXPECT_EQ(balls_of(compared), expected) << where() << ", by comparing";
  expect_keys(compared);
}

TEST(GridOrder, IsByCubeAndRank) {
  oracle::RandomSource random(21);
  for (int round = 0; round < 3000; ++round) {
    const int64_t side = random.in(1, int64_t{1} << random.in(0, 31));
    const int64_t limit = int64_t{1} << 50;
    std::vector<hsp::exact::LatticeBall> balls;
    int64_t width[3];
    for (int64_t &w : width) w = std::min(limit, side * (int64_t{1} << random.in(0, 20)) / (1 << random.in(0, 10)));
    const int64_t count = random.in(0, 120);
    for (int64_t k = 0; k < count; ++k) {
      hsp::exact::LatticeBall ball{
          {random.in(-width[0], width[0]), random.in(-width[1], width[1]), random.in(-width[2], width[2])},
          random.in(0, 3),
          0};
      // Ties of every kind with an earlier ball.
      if (k > 0 && random.in(0, 3) == 0) {
        const hsp::exact::LatticeBall &other = balls[static_cast<size_t>(random.in(0, k - 1))];
        const int64_t alike = random.in(1, 4);
        ball.centre.x = other.centre.x;
        if (alike > 1) ball.centre.y = other.centre.y;
        if (alike > 2) ball.centre.z = other.centre.z;
        if (alike > 3) ball.radius = other.radius;
      }
      balls.push_back(ball);
    }
    expect_order(balls, side, static_cast<uint32_t>(random.in(0, 200)));
  }
}

TEST(GridOrder, OfManyBalls) {
  oracle::RandomSource random(22);
  for (const int64_t width : {int64_t{9}, int64_t{300}, int64_t{5000}, int64_t{1} << 50}) {
    std::vector<hsp::exact::LatticeBall> balls;
    for (int k = 0; k < 20000; ++k) {
      balls.push_back({{random.in(-width, width), random.in(-width, width), random.in(-width, width)}, 1, 0});
    }
    for (const int64_t side : {int64_t{1}, int64_t{7}, int64_t{600}, int64_t{20000}}) expect_order(balls, side, 20000);
  }
}

TEST(GridOrder, AtTheEndsOfTheLattice) {
  constexpr int64_t end = int64_t{1} << 50;
  const std::vector<hsp::exact::LatticeBall> corners = {
      {{end, end, end}, 0, 0},  {{-end, end, end}, 0, 0},  {{end, -end, end}, 0, 0},  {{-end, -end, end}, 0, 0},
      {{end, end, -end}, 0, 0}, {{-end, end, -end}, 0, 0}, {{end, -end, -end}, 0, 0}, {{-end, -end, -end}, 0, 0},
      {{0, 0, 0}, 0, 0},        {{-1, 0, 0}, 0, 0}};
  for (const int64_t side : {int64_t{1}, int64_t{3}, (int64_t{1} << 31) - 2}) {
    for (uint32_t spare = 0; spare < 9; ++spare) expect_order(corners, side, spare);
  }
}

TEST(GridOrder, OfFewBalls) {
  expect_order({}, 1, 0);
  expect_order({{{5, -7, 9}, 3, 0}}, 6, 0);
  expect_order({{{5, -7, 9}, 3, 0}, {{5, -7, 9}, 3, 0}}, 6, 0);
}

}  // namespace
