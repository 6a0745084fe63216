// Point, ball, yes-or-no and neighbour queries, and lists of all pairs, against looking at every ball.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "brute_queries.hpp"
#include "library_run.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::RandomSource;
using Ids = std::vector<uint32_t>;

// Ask with no, too little, exact and ample capacity; the answers must fit together.
template <class Query>
Ids ask(const Query &query) {
  constexpr uint32_t untouched = 0xABCDEF01U;
  uint32_t needed = untouched;
  const int32_t status = query(nullptr, 0, &needed);
  EXPECT_EQ(status, needed == 0 ? HSP_OK : HSP_E_CAPACITY);
  if (needed > 0) {
    Ids little(needed, untouched);
    uint32_t still_needed = 0;
    EXPECT_EQ(query(little.data(), needed - 1, &still_needed), HSP_E_CAPACITY);
    EXPECT_EQ(still_needed, needed);
    EXPECT_EQ(little, Ids(needed, untouched)) << "something was written";
  }
  Ids exact(needed + 1, untouched);
  uint32_t found = 0;
  EXPECT_EQ(query(exact.data(), needed, &found), HSP_OK);
  EXPECT_EQ(found, needed);
  EXPECT_EQ(exact[needed], untouched) << "one too many was written";
  exact.resize(needed);
  Ids ample(needed + 7, untouched);
  EXPECT_EQ(query(ample.data(), needed + 7, &found), HSP_OK);
  EXPECT_TRUE(std::equal(exact.begin(), exact.end(), ample.begin()));
  return exact;
}

void expect_queries(const LibraryModel &model, const Balls &balls, const LatticeBall &query, double step) {
  const std::array<double, 3> xyz = {static_cast<double>(query.x) * step, static_cast<double>(query.y) * step,
                                     static_cast<double>(query.z) * step};
  const double radius = static_cast<double>(query.radius) * step;
  const Ids point_hits = oracle::balls_meeting(balls, {query.x, query.y, query.z, 0});
  EXPECT_EQ(ask([&](uint32_t *ids, uint32_t capacity, uint32_t *needed) {
              return hsp_query_point(model.handle(), xyz.data(), ids, capacity, needed);
            }),
            point_hits)
      << oracle::to_text({query}) << " in " << oracle::to_text(balls);
  const Ids ball_hits = oracle::balls_meeting(balls, query);
  EXPECT_EQ(ask([&](uint32_t *ids, uint32_t capacity, uint32_t *needed) {
              return hsp_query_ball(model.handle(), xyz.data(), radius, ids, capacity, needed);
            }),
            ball_hits)
      << oracle::to_text({query}) << " in " << oracle::to_text(balls);
  uint32_t meets = 77;
  EXPECT_EQ(hsp_query_meets(model.handle(), xyz.data(), radius, &meets), HSP_OK);
  EXPECT_EQ(meets, ball_hits.empty() ? 0U : 1U);
}

// Row i of the lists begins at first[i].
void expect_pairs(const LibraryModel &model, const Balls &balls) {
  for (const uint32_t flags : {0U, HSP_PAIRS_ONCE}) {
    Ids first = {0};
    Ids ids;
    for (uint32_t i = 0; i < balls.size(); ++i) {
      for (const uint32_t j : oracle::neighbours(balls, i))
        if (flags == 0 || j > i) ids.push_back(j);
      first.push_back(static_cast<uint32_t>(ids.size()));
    }
    EXPECT_EQ(ask([&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
                constexpr uint32_t guard = 0xABCDEF01U;
                Ids begins(balls.size() + 2, guard);
                const int32_t status = hsp_query_pairs(model.handle(), flags, begins.data(), out, capacity, needed);
                EXPECT_EQ(begins.back(), guard) << "one too many was written";
                begins.pop_back();
                EXPECT_EQ(begins, first) << oracle::to_text(balls);
                return status;
              }),
              ids)
        << "flags " << flags << " of " << oracle::to_text(balls);
  }
}

void expect_neighbours(const LibraryModel &model, const Balls &balls) {
  for (uint32_t i = 0; i < balls.size(); ++i)
    EXPECT_EQ(ask([&](uint32_t *ids, uint32_t capacity, uint32_t *needed) {
                return hsp_query_neighbours(model.handle(), i, ids, capacity, needed);
              }),
              oracle::neighbours(balls, i))
        << i << " of " << oracle::to_text(balls);
  expect_pairs(model, balls);
}

// Query balls around the set: everywhere, at the balls, touching them, small, large, and larger than all.
std::vector<LatticeBall> query_balls(RandomSource &random, const Balls &balls, int count) {
  int64_t largest = 1;
  LatticeBall low = {0, 0, 0, 0};
  LatticeBall high = {0, 0, 0, 0};
  if (!balls.empty()) low = high = balls.front();
  for (const LatticeBall &ball : balls) {
    largest = std::max(largest, ball.radius);
    low = {std::min(low.x, ball.x), std::min(low.y, ball.y), std::min(low.z, ball.z), 0};
    high = {std::max(high.x, ball.x), std::max(high.y, ball.y), std::max(high.z, ball.z), 0};
  }
  const int64_t extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) + largest;
  std::vector<LatticeBall> queries;
  while (queries.size() < static_cast<size_t>(count)) {
    LatticeBall query = {random.in(low.x - 2 * largest, high.x + 2 * largest),
                         random.in(low.y - 2 * largest, high.y + 2 * largest),
                         random.in(low.z - 2 * largest, high.z + 2 * largest), 0};
    if (!balls.empty() && random.one_in(2)) {
      // On or just off a ball's surface along an axis or a diagonal of integer length.
      const LatticeBall &ball = balls[static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1))];
      query.radius = random.in(0, 2 * largest);
      const int64_t reach = ball.radius + query.radius + random.in(-1, 1);
      query = {ball.x, ball.y, ball.z, query.radius};
      switch (random.in(0, 4)) {
        case 0:
          query.x += reach;
          break;
        case 1:
          query.y -= reach;
          break;
        case 2:
          query.z += reach;
          break;
        case 3:
          query.x -= 2 * (reach / 3);
          query.y += reach / 3;
          query.z += 2 * (reach / 3);
          break;
        default:
          break;
      }
    } else {
      const std::array<int64_t, 6> radii = {0, 1, largest, 3 * largest, 100 * largest, 2 * extent};
      query.radius = radii[static_cast<size_t>(random.in(0, 5))];
    }
    queries.push_back(query);
  }
  return queries;
}

void expect_all(const Balls &balls, RandomSource &random, int queries, double step = 1) {
  const LibraryModel model(balls, step);
  for (const LatticeBall &query : query_balls(random, balls, queries)) expect_queries(model, balls, query, step);
  expect_neighbours(model, balls);
}

TEST(Queries, OfNoBallAndOfOneBall) {
  RandomSource random(31);
  expect_all({}, random, 50);
  expect_all({{3, -4, 5, 7}}, random, 300);
  expect_all({{3, -4, 5, 0}}, random, 300);
}

TEST(Queries, OfRandomSets) {
  RandomSource random(32);
  for (int k = 0; k < 600; ++k) {
    const auto n = static_cast<size_t>(random.in(2, 200));
    expect_all(random.one_in(2) ? oracle::loose_balls(random, n) : oracle::clustered_balls(random, n), random, 60);
  }
}

TEST(Queries, OfCollidingCubes) {
  RandomSource random(36);
  for (int k = 0; k < 20; ++k) {
    expect_all(oracle::colliding_balls(random, static_cast<size_t>(random.in(200, 400))), random, 60);
  }
}

TEST(Queries, OfDegenerateSets) {
  RandomSource random(33);
  for (int k = 0; k < 2500; ++k)
    expect_all(oracle::degenerate_balls(random, static_cast<size_t>(random.in(1, 25))), random, 40);
}

TEST(Queries, OfSetsWhoseCoordinatesNoFloatHolds) {
  RandomSource random(38);
  for (int k = 0; k < 40; ++k) {
    Balls balls = oracle::loose_balls(random, 60);
    for (LatticeBall &ball : balls) {
      for (int64_t *number : {&ball.x, &ball.y, &ball.z, &ball.radius}) {
        *number = (*number << 18) + random.in(0, (1 << 18) - 1);
      }
    }
    expect_all(balls, random, 200);
  }
}

TEST(Queries, FarFromTheOriginAndAtNegativeCoordinates) {
  RandomSource random(34);
  constexpr int64_t limit = (int64_t{1} << 50) - 2000;
  for (const int64_t far : {int64_t{1000000}, int64_t{-1000000}, int64_t{1} << 40, limit, -limit})
    for (int k = 0; k < 40; ++k) {
      const Balls balls = oracle::loose_balls(random, 40);
      const LibraryModel model(moved(balls, {far, -far, far}), 0.25);
      for (const LatticeBall &query : query_balls(random, balls, 30)) {
        if (query.radius > 1000) continue;
        expect_queries(model, moved(balls, {far, -far, far}), moved(Balls{query}, {far, -far, far}).front(), 0.25);
      }
      expect_neighbours(model, moved(balls, {far, -far, far}));
    }
}

TEST(Queries, WithOneBallFarAway) {
  RandomSource random(35);
  for (const int64_t far : {int64_t{100000}, int64_t{1} << 45}) {
    Balls balls = oracle::loose_balls(random, 60);
    balls.push_back({far, far / 2, -far, 80});
    expect_all(balls, random, 300);
    const LibraryModel model(balls);
    // From far away over everything, and just up to the nearest ball.
    expect_queries(model, balls, {far, 0, 0, 4 * far}, 1);
    expect_queries(model, balls, {far, far / 2, -far, far}, 1);
  }
}

TEST(Queries, WithOneLargeBallAmongSmallOnes) {
  RandomSource random(36);
  for (int k = 0; k < 10; ++k) {
    const Balls balls = oracle::joined({{0, 0, 0, 1000}}, oracle::balls_in_box(random, 99, 1500, 0, 20));
    expect_all(oracle::permuted(balls, random.permutation(balls.size())), random, 100);
  }
}

TEST(Queries, AtTheBordersOfCubes) {
  // Centres and queries at multiples of r_max and one step beside them, on both sides of zero.
  RandomSource random(37);
  for (const int64_t r : {1, 2, 5, 64}) {
    Balls balls;
    for (int k = 0; k < 60; ++k)
      balls.push_back({r * random.in(-6, 6) + random.in(-1, 1), r * random.in(-6, 6),
                       r * random.in(-6, 6) + random.in(-1, 1), random.in(0, r)});
    balls.push_back({0, 0, 0, r});
    const LibraryModel model(balls);
    for (int k = 0; k < 400; ++k)
      expect_queries(model, balls,
                     {r * random.in(-8, 8) + random.in(-1, 1), r * random.in(-8, 8) + random.in(-1, 1),
                      r * random.in(-8, 8), r * random.in(0, 3) + random.in(0, 1)},
                     1);
    expect_neighbours(model, balls);
  }
}

}  // namespace
