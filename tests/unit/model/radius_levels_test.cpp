// Of balls of very unequal radii those that meet one, and that a query meets, are found as by a look at every ball; and
// of many small ones around a large one few are looked at.
#include "model/radius_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "brute_queries.hpp"
#include "built_grid.hpp"
#include "carved_memory.hpp"
#include "lattice_lengths.hpp"
#include "model/neighbour_lists.hpp"
#include "model/queries.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"

namespace {

// Small ones that fill a box, and larger ones among them.
oracle::Balls small_and_large(oracle::RandomSource &random, size_t small, size_t large, int64_t radius) {
  oracle::Balls balls = oracle::balls_in_box(random, small, 30000, radius / 2, radius);
  const oracle::Balls others = oracle::balls_in_box(random, large, 30000, 12000, 15000);
  balls.insert(balls.end(), others.begin(), others.end());
  return balls;
}

// Few large ones; more than are looked at by everybody; points; radii of every size; copies and nested balls; tiny ones
// close together; the same far from the origin.
std::vector<oracle::Balls> unequal_sets() {
  oracle::RandomSource random(51);
  std::vector<oracle::Balls> sets = {small_and_large(random, 1500, 1, 1500), small_and_large(random, 1500, 40, 1200),
                                     small_and_large(random, 1500, 5, 0)};
  oracle::Balls every_size = small_and_large(random, 1000, 20, 800);
  for (int64_t radius = 1; radius < 12000; radius += 1 + radius / 50) {
    every_size.push_back(oracle::ball_in_box(random, 30000, radius, radius));
  }
  sets.push_back(every_size);
  oracle::Balls nested = small_and_large(random, 700, 2, 1500);
  for (size_t k = 0; k < 700; ++k) {
    nested.push_back(nested[k]);
    if (k % 3 == 0) nested.back().radius /= 2;
  }
  sets.push_back(nested);
  oracle::Balls close = oracle::balls_in_box(random, 1400, 2000, 10, 90);
  close.push_back({15000, 0, 0, 15000});
  sets.push_back(close);
  sets.push_back(oracle::moved(close, {100000000, -300000000, 200000000}));
  return sets;
}

std::vector<uint32_t> found_by(const hsp::CubeGrid &grid, const oracle::LatticeBall &query) {
  std::vector<uint32_t> ids(grid.balls().n);
  hsp::QueryResult result{ids.data(), grid.balls().n, 0};
  hsp::find_balls_at_ball(grid, {{query.x, query.y, query.z}, query.radius}, result);
  ids.resize(result.hits);
  return ids;
}

TEST(RadiusLevels, AnswerAsALookAtEveryBall) {
  oracle::RandomSource random(52);
  size_t answered = 0, seemed_too_little = 0;
  for (const oracle::Balls &balls : unequal_sets()) {
    BuiltGrid built(oracle::in_lengths(balls, 1));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    for (const bool in_lanes : {hsp::has_lanes, false}) {
      built.grid().use(in_lanes ? built.grid().target() : hsp::Target::baseline, in_lanes);
      const hsp::CubeGrid &grid = built.grid();
      const hsp::RadiusLevels *const levels = grid.levels();
      ASSERT_NE(levels, nullptr);
      std::vector<uint32_t> rows(balls.size() + 1), ids;
      const hsp::Span<uint32_t> begins(rows.data(), static_cast<uint32_t>(rows.size()));
      ASSERT_TRUE(hsp::count_neighbours(grid, hsp::PairRows::both, begins));
      ids.resize(rows.back());
      hsp::list_neighbours(grid, hsp::PairRows::both, begins, {ids.data(), rows.back()});
      for (size_t i = 0; i < balls.size(); ++i) {
        std::vector<uint32_t> expected = oracle::neighbours(balls, static_cast<uint32_t>(i));
        EXPECT_EQ(std::vector<uint32_t>(ids.begin() + rows[i], ids.begin() + rows[i + 1]), expected);
        for (uint32_t &ball : expected) ball = grid.grid_index(ball);
        std::sort(expected.begin(), expected.end());
        // With room to spare, just enough, and too little. Enough may seem too little where buckets are asked twice,
        // or very many cubes.
        for (const size_t room : {balls.size(), expected.size(), expected.size() / 2}) {
          std::vector<uint32_t> found(room);
          const uint32_t count = levels->find_neighbours(grid.balls(), grid.grid_index(static_cast<uint32_t>(i)),
                                                         found.data(), static_cast<uint32_t>(room));
          if (count > room) {
            EXPECT_TRUE(room <= expected.size() || count == hsp::no_id) << "ball " << i;
            seemed_too_little += room >= expected.size();
            continue;
          }
          found.resize(count);
          EXPECT_EQ(found, expected) << "ball " << i << " room " << room;
          ++answered;
        }
      }
      for (int k = 0; k < 300; ++k) {
        const int64_t most = k % 3 == 0 ? 0 : k % 3 == 1 ? 2000 : 90000;
        const oracle::LatticeBall query = oracle::ball_in_box(random, 50000, 0, most);
        const std::vector<uint32_t> expected = oracle::balls_meeting(balls, query);
        EXPECT_EQ(found_by(grid, query), expected);
        EXPECT_EQ(hsp::any_ball_meets(grid, {{query.x, query.y, query.z}, query.radius}), !expected.empty());
      }
    }
  }
  EXPECT_LT(4 * seemed_too_little, answered);
}

// The last third of them are images that surround the others, as in a box with a colloid in its solvent.
TEST(RadiusLevels, AnswerForImages) {
  oracle::RandomSource random(55);
  const oracle::Balls balls = small_and_large(random, 3000, 6, 1500);
  const auto n = static_cast<uint32_t>(balls.size());
  CarvedMemory memory, grid_memory;
  hsp::BallSet given;
  memory.carve(given, n);
  given.n = n;
  given.lattice = hsp::exact::Lattice::with_step(1.0);
  for (uint32_t k = 0; k < n; ++k) {
    const oracle::LatticeBall &ball = balls[k];
    given.store(k, {{ball.x, ball.y, ball.z}, ball.radius, k});
    given.largest_radius = std::max(given.largest_radius, ball.radius);
  }
  hsp::CubeGrid grid;
  grid_memory.carve(grid, n);
  grid.build(given, n - n / 3);
  ASSERT_NE(grid.levels(), nullptr);
  for (uint32_t i = 0; i < n; ++i) {
    std::vector<uint32_t> expected = oracle::neighbours(balls, i), found(n);
    for (uint32_t &ball : expected) ball = grid.grid_index(ball);
    std::sort(expected.begin(), expected.end());
    const uint32_t count = grid.levels()->find_neighbours(grid.balls(), grid.grid_index(i), found.data(), n);
    if (count == hsp::no_id) {
      EXPECT_GE(balls[i].radius, 12000);  // reaches very many cubes
      continue;
    }
    found.resize(count);
    EXPECT_EQ(found, expected) << "ball " << i;
  }
}

// Not where cubes are no wider than balls need, nor where all balls are of one size.
TEST(RadiusLevels, AreThereWhereTheySaveWork) {
  oracle::RandomSource random(53);
  const auto has_levels = [](const oracle::Balls &balls) {
    const BuiltGrid built(oracle::in_lengths(balls, 1));
    return built.grid().levels() != nullptr;
  };
  EXPECT_FALSE(has_levels(oracle::balls_in_box(random, 3000, 30000, 1200, 1500)));
  EXPECT_FALSE(has_levels(oracle::balls_in_box(random, 3000, 3000, 1200, 1500)));
  EXPECT_FALSE(has_levels(oracle::balls_in_box(random, 3000, 300, 1, 1500)));
  EXPECT_FALSE(has_levels(small_and_large(random, 100, 5, 1500)));
  EXPECT_FALSE(has_levels(small_and_large(random, 20, 1500, 1500)));
  EXPECT_TRUE(has_levels(small_and_large(random, 3000, 5, 1500)));
}

// 8,000 balls around one that is twelve times as large, about as many neighbours as atoms have.
TEST(RadiusLevels, LookAtFewBalls) {
  oracle::RandomSource random(54);
  oracle::Balls balls;
  for (int64_t x = 0; x < 20; ++x) {
    for (int64_t y = 0; y < 20; ++y) {
      for (int64_t z = 0; z < 20; ++z) {
        balls.push_back(
            {3000 * x + random.in(-900, 900), 3000 * y + random.in(-900, 900), 3000 * z + random.in(-900, 900), 1600});
      }
    }
  }
  balls.push_back({30000, 30000, 30000, 20000});
  const BuiltGrid built(oracle::in_lengths(balls, 1));
  const hsp::RadiusLevels *const levels = built.grid().levels();
  ASSERT_NE(levels, nullptr);
  uint64_t seen = 0;
  for (uint32_t i = 0; i < balls.size(); ++i) {
    const hsp::exact::LatticeBall ball = built.grid().balls().ball(i);
    if (ball.radius > 1600) continue;
    levels->visit_buckets({static_cast<double>(ball.centre.x), static_cast<double>(ball.centre.y),
                           static_cast<double>(ball.centre.z), 1600.0, hsp::no_id},
                          [&](uint32_t first, uint32_t last) {
                            seen += levels->balls_in(first, last).last - levels->balls_in(first, last).first;
                          });
  }
  EXPECT_LT(seen, 120 * balls.size());
}

}  // namespace
