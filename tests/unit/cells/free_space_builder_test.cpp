// Cells of free space, held against the cells of the complement that the topology finds by shells and rays, and against
// points: whether they are in a ball, by distance; in which cube and at which ball, by least power; what a short way
// through free space joins.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "built_free_space.hpp"
#include "built_topology.hpp"
#include "cells/cell_location.hpp"
#include "named_balls.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"

namespace {

using hsp::FreeCell;
using hsp::FreeSpace;
using hsp::no_id;
using oracle::Balls;
using oracle::LatticePoint;

struct Seen {
  uint32_t regions = 0, several_parts = 0, apart = 0, free_points = 0, ways = 0, multi_located = 0;
};

int64_t floor_divided(int64_t a, int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

oracle::Int128 power(const oracle::LatticeBall &ball, const LatticePoint &p) {
  const oracle::Int128 x = p[0] - ball.x, y = p[1] - ball.y, z = p[2] - ball.z;
  return x * x + y * y + z * z - oracle::Int128{ball.radius} * ball.radius;
}

bool is_free(const Balls &balls, const LatticePoint &p) {
  return std::all_of(balls.begin(), balls.end(), [&](const auto &ball) { return power(ball, p) > 0; });
}

// Whether the segment is outside all balls.
bool is_free_way(const Balls &balls, const LatticePoint &a, const LatticePoint &b) {
  const oracle::Vector d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  for (const auto &ball : balls) {
    const oracle::Vector p{ball.x - a[0], ball.y - a[1], ball.z - a[2]};
    const oracle::Int128 along = oracle::dot(d, p), length = oracle::dot(d, d);
    const oracle::Int128 w = oracle::Int128{ball.radius} * ball.radius;
    if (along <= 0 || along >= length) continue;  // the ends are free
    if (oracle::dot(p, p) * length - along * along <= w * length) return false;
  }
  return true;
}

bool adjacent(const FreeSpace &space, uint32_t a, uint32_t b) {
  const auto list = space.neighbours(a);
  return std::binary_search(list.begin(), list.end(), b);
}

void check_structure(const BuiltFreeSpace &built, Seen &seen) {
  const FreeSpace &space = built.space();
  ASSERT_GE(space.cell_count(), 1U);
  std::set<std::pair<uint32_t, uint32_t>> pairs;
  for (uint32_t c = 0; c < space.cell_count(); ++c) {
    const FreeCell &cell = space.cell(c);
    ASSERT_EQ(cell.kind == hsp::CellKind::run, c < space.run_count());
    seen.apart += cell.kind == hsp::CellKind::apart ? 1U : 0U;
    ASSERT_LT(cell.region, space.region_count());
    const auto list = space.neighbours(c);
    for (uint32_t k = 0; k < list.size(); ++k) {
      ASSERT_NE(list[k], c);
      ASSERT_TRUE(k == 0 || list[k - 1] < list[k]) << "twice";
      ASSERT_TRUE(adjacent(space, list[k], c)) << "not seen alike from both sides";
      ASSERT_EQ(space.cell(list[k]).region, cell.region);
      pairs.insert({std::min(c, list[k]), std::max(c, list[k])});
      // In one cube, or in two with a common side.
      const FreeCell &other = space.cell(list[k]);
      if (cell.cube == no_id || other.cube == no_id) continue;
      const auto &p = space.cover.cube(cell.cube), &q = space.cover.cube(other.cube);
      ASSERT_LE(std::abs(p.x - q.x) + std::abs(p.y - q.y) + std::abs(p.z - q.z), 1);
      ASSERT_TRUE(cell.cube != other.cube || cell.ball != other.ball);
    }
  }
  ASSERT_EQ(pairs.size(), space.adjacency_count());
  for (uint32_t entry = 0; entry < space.cover.entries(); ++entry) {
    seen.several_parts += space.parts_of(entry).size() > 1 ? 1U : 0U;
  }
}

// Which of the balls that meet its cube has the least power, of equal ones that of lower rank; all balls are given, so
// that this looks at those of the cover alone.
uint32_t least_power(const BuiltFreeSpace &built, uint32_t cube, const Balls &balls, const LatticePoint &p) {
  uint32_t best = no_id;
  for (const uint32_t ball : built.space().cover.balls(cube)) {
    if (best == no_id) {
      best = ball;
      continue;
    }
    const auto a = power(balls[built.balls().caller[ball]], p), b = power(balls[built.balls().caller[best]], p);
    if (a < b || (a == b && built.balls().ranks_before(ball, best))) best = ball;
  }
  return best;
}

void check(const Balls &balls, oracle::RandomSource &random, int points, Seen &seen) {
  BuiltTopology topology(balls);
  ASSERT_EQ(topology.status(), hsp::Status::ok);
  BuiltFreeSpace built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok) << oracle::to_text(balls);
  const FreeSpace &space = built.space();
  ASSERT_NO_FATAL_FAILURE(check_structure(built, seen)) << oracle::to_text(balls);
  const hsp::FreeSpaceViolation violation = hsp::check_free_space(built.balls(), space, built.builder().scratch());
  ASSERT_EQ(violation.invariant, hsp::FreeSpaceInvariant::none) << oracle::to_text(balls) << violation.id;
  ASSERT_EQ(space.region_count(), topology.structure().region_count) << oracle::to_text(balls);
  seen.regions += space.region_count();

  std::map<uint32_t, uint32_t> cell_of_region;
  const int64_t side = built.grid().side();
  LatticePoint low{0, 0, 0}, high{0, 0, 0};
  for (const auto &ball : balls) {
    for (size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], oracle::centre_of(ball)[k] - 2 * ball.radius - 2);
      high[k] = std::max(high[k], oracle::centre_of(ball)[k] + 2 * ball.radius + 2);
    }
  }
  const auto located = [&](const LatticePoint &p) { return hsp::cell_at(built.balls(), space, {p[0], p[1], p[2]}); };
  for (int n = 0; n < points; ++n) {
    LatticePoint p{};
    const bool on_cubes = random.one_in(4);
    for (size_t k = 0; k < 3; ++k) {
      p[k] = random.in(low[k], high[k]);
      if (on_cubes && random.one_in(2)) p[k] = floor_divided(p[k], side) * side;
    }
    const uint32_t cell = located(p);
    ASSERT_EQ(cell != no_id, is_free(balls, p)) << oracle::to_text(balls);
    if (cell == no_id) continue;
    ++seen.free_points;
    const uint32_t region = space.cell(cell).region;
    const uint32_t expected =
        hsp::region_of_point(topology.grid(), topology.boundary(), topology.structure(), {p[0], p[1], p[2]});
    const auto [entry, is_new] = cell_of_region.insert({region, expected});
    ASSERT_EQ(entry->second, expected) << oracle::to_text(balls) << p[0] << ' ' << p[1] << ' ' << p[2];
    ASSERT_EQ(region == 0, expected == 0) << oracle::to_text(balls);
    if (space.cell(cell).cube != no_id) {
      const auto &cube = space.cover.cube(space.cell(cell).cube);
      ASSERT_EQ(cube.x, floor_divided(p[0], side));
      ASSERT_EQ(cube.y, floor_divided(p[1], side));
      ASSERT_EQ(cube.z, floor_divided(p[2], side));
      ASSERT_EQ(space.cell(cell).ball, least_power(built, space.cell(cell).cube, balls, p));
      seen.multi_located += space.landmarks_of(cell).empty() ? 0U : 1U;
    }
    // A short way through free space.
    LatticePoint q = p;
    const int64_t reach = std::max<int64_t>(1, side / 8);
    for (size_t k = 0; k < 3; ++k) q[k] += random.in(-reach, reach);
    if (!is_free(balls, q) || !is_free_way(balls, p, q)) continue;
    ++seen.ways;
    ASSERT_EQ(space.cell(located(q)).region, region) << oracle::to_text(balls);
    // The smallest step there is crosses one facet, or is next to several.
    LatticePoint next = p;
    const size_t axis = static_cast<size_t>(random.in(0, 2));
    next[axis] += 1;
    if (side < 500 || !is_free(balls, next)) continue;
    const uint32_t other = located(next);
    const FreeCell &a = space.cell(cell), &b = space.cell(other);
    if (other == cell || !is_free_way(balls, p, next)) continue;
    if (a.cube == b.cube || a.ball == b.ball) {
      ASSERT_TRUE(adjacent(space, cell, other)) << oracle::to_text(balls);
    }
  }
}

TEST(FreeSpace, OfNoBallsAndOfOne) {
  BuiltFreeSpace none(Balls{});
  ASSERT_EQ(none.status(), hsp::Status::ok);
  EXPECT_EQ(none.space().cell_count(), 1U);
  EXPECT_EQ(none.space().region_count(), 1U);
  EXPECT_EQ(none.space().adjacency_count(), 0U);
  EXPECT_EQ(hsp::cell_at(none.balls(), none.space(), {5, -7, 1}), 0U);
  oracle::RandomSource random(1);
  Seen seen;
  for (const auto &ball :
       {oracle::LatticeBall{0, 0, 0, 1000}, {500, 500, 500, 1000}, {1000, 1000, 1000, 1000}, {3, 4, 5, 0}}) {
    ASSERT_NO_FATAL_FAILURE(check({ball}, random, 100, seen));
  }
}

TEST(FreeSpace, OfSetsOfAllKinds) {
  oracle::RandomSource random(2);
  Seen seen;
  for (int k = 0; k < 300; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 30)));
    ASSERT_NO_FATAL_FAILURE(check(balls, random, 40, seen)) << k;
  }
  EXPECT_GT(seen.free_points, 5000U);
  EXPECT_GT(seen.ways, 3000U);
  EXPECT_GT(seen.several_parts, 400U);
  EXPECT_GT(seen.apart, 200U);
  EXPECT_GT(seen.multi_located, 30U);
}

// Smaller numbers than any lattice would be given: nearly everything is tied.
TEST(FreeSpace, OfVerySmallIntegers) {
  oracle::RandomSource random(3);
  Seen seen;
  for (int k = 0; k < 600; ++k) {
    Balls balls;
    const int64_t n = random.in(1, 14), most = random.in(1, 4);
    for (int64_t i = 0; i < n; ++i) {
      const int64_t x = random.in(0, most), y = random.in(0, most), z = random.in(0, most);
      balls.push_back({x, y, z, random.in(0, most)});
    }
    ASSERT_NO_FATAL_FAILURE(check(balls, random, 6, seen)) << k;
  }
}

// Lattices around the radii at which their gaps close, shifted against the cubes or not: vertices lie on sides.
TEST(FreeSpace, OfLattices) {
  oracle::RandomSource random(4);
  Seen seen;
  for (const int64_t radius : {50, 70, 71, 75, 86, 87}) {
    Balls balls = oracle::box_lattice({3, 3, 3}, {100, 100, 100}, radius);
    ASSERT_NO_FATAL_FAILURE(check(balls, random, 60, seen));
    for (auto &ball : balls) ball.x += radius;
    ASSERT_NO_FATAL_FAILURE(check(balls, random, 60, seen));
  }
  for (const int64_t radius : {50, 57, 58, 60}) {
    ASSERT_NO_FATAL_FAILURE(check(oracle::chosen_points(4, radius, 70, oracle::is_face_centred), random, 60, seen));
  }
  for (const int64_t radius : {70, 71, 90, 100}) {
    ASSERT_NO_FATAL_FAILURE(check(oracle::cage_of_26(100, radius), random, 60, seen));
  }
  EXPECT_GT(seen.regions, 30U);
}

// A cage within a cage, with a ball in the middle: cubes inside that no ball meets.
TEST(FreeSpace, WithHollowsInside) {
  oracle::RandomSource random(5);
  Seen seen;
  Balls large;
  for (const auto &ball : oracle::box_lattice({7, 7, 7}, {1000, 1000, 1000}, 720)) {
    const auto [least, most] = std::minmax({ball.x, ball.y, ball.z});
    if (least == 0 || most == 6000) large.push_back(ball);
  }
  ASSERT_NO_FATAL_FAILURE(check(large, random, 100, seen));
  Balls inner = oracle::balls_on_sphere(3, 200, 350);
  for (auto &ball : inner) ball = {ball.x + 3000, ball.y + 3000, ball.z + 3000, ball.radius};
  const Balls both = oracle::joined(large, inner);
  ASSERT_NO_FATAL_FAILURE(check(both, random, 100, seen));
  ASSERT_NO_FATAL_FAILURE(check(oracle::joined(both, {{3000, 3000, 3000, 10}}), random, 100, seen));
  EXPECT_EQ(seen.regions, 2U + 3 + 3);
}

// A row of large balls, whose discs cut the facets between them in two, and small balls just beyond the side of cubes
// on which these facets lie: facets that touch no border of what they lie in.
TEST(FreeSpace, OfFacetsInsideFacets) {
  oracle::RandomSource random(8);
  Seen seen;
  uint32_t crossings = 0;
  for (int k = 0; k < 40; ++k) {
    const bool mirrored = random.one_in(2);
    const auto at = [&](int64_t x) { return mirrored ? 4000 - x : x; };
    Balls balls;
    for (int64_t y = -250; y <= 2250; y += 500) balls.push_back({at(1300), y, 900, 1000});
    for (int i = 0; i < 30; ++i) {
      const int64_t radius = random.in(1, 4), gap = random.in(1, 10);
      const int64_t y = random.in(1150, 1350), above = random.in(1620, 1950), below = random.in(20, 160);
      balls.push_back({at(2000 + radius + gap), y, random.one_in(2) ? above : below, radius});
    }
    ASSERT_NO_FATAL_FAILURE(check(balls, random, 10, seen)) << k;
    const BuiltFreeSpace built(balls);
    const FreeSpace &space = built.space();
    for (int n = 0; n < 100; ++n) {
      const LatticePoint on{2000, random.in(1150, 1350), random.in(0, 1999)};
      const LatticePoint before{1999, on[1], on[2]};
      if (!is_free(balls, on) || !is_free(balls, before)) continue;
      const uint32_t a = hsp::cell_at(built.balls(), space, {before[0], before[1], before[2]});
      const uint32_t b = hsp::cell_at(built.balls(), space, {on[0], on[1], on[2]});
      if (least_power(built, space.cell(a).cube, balls, on) != space.cell(a).ball) continue;
      ASSERT_TRUE(adjacent(space, a, b));
      ++crossings;
    }
  }
  EXPECT_GT(seen.several_parts, 50U);
  EXPECT_GT(crossings, 500U);
}

// The facets between two balls are rectangles, whole but for a disc around one corner: paths go through the corner that
// is farthest from the balls.
TEST(FreeSpace, HasPortalsFarFromTheBalls) {
  const Balls balls{{500, 300, 300, 1000}, {1500, 300, 300, 1000}};
  BuiltFreeSpace built(balls);
  hsp::FreeSpaceLimits limits;
  ASSERT_EQ(hsp::default_limits(2, limits), hsp::Status::ok);
  CarvedMemory memory;
  hsp::FreeSpaceBuilder builder;
  memory.carve(builder, limits, true);
  ASSERT_EQ(builder.build(built.grid()), hsp::Status::ok);
  const FreeSpace &space = builder.structure();
  const auto farther = [&](int64_t cube, int64_t centre) {
    const int64_t low = cube * space.side, high = low + space.side;
    return centre - low > high - centre ? low : high;
  };
  uint32_t facets = 0;
  for (uint32_t k = 0; k < space.contacts.size(); ++k) {
    const FreeCell &a = space.cell(space.contacts[k].cell[0]), &b = space.cell(space.contacts[k].cell[1]);
    if (a.cube == no_id || a.cube != b.cube) continue;
    const hsp::CubeCoordinates &cube = space.cover.cube(a.cube);
    const hsp::exact::Vector &portal = space.contacts.portal(k);
    EXPECT_EQ(portal.x, 1000);
    EXPECT_EQ(portal.y, farther(cube.y, 300));
    EXPECT_EQ(portal.z, farther(cube.z, 300));
    ++facets;
  }
  EXPECT_GE(facets, 4U);
}

// Centres and radii as large as a lattice may have them.
TEST(FreeSpace, OfTheLargestNumbers) {
  oracle::RandomSource random(6);
  Seen seen;
  for (int k = 0; k < 60; ++k) {
    const Balls balls = oracle::largest_balls(random, static_cast<size_t>(random.in(2, 12)));
    ASSERT_NO_FATAL_FAILURE(check(balls, random, 40, seen)) << k;
  }
}

// A retry with the needed limits ends well, and soon, for any first limits.
TEST(FreeSpace, GrowsToWhatItNeeds) {
  oracle::RandomSource random(7);
  for (int k = 0; k < 60; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(1, 20)));
    const BuiltFreeSpace expected(balls);
    ASSERT_EQ(expected.status(), hsp::Status::ok);
    const auto few = [&] { return static_cast<uint32_t>(random.in(0, 40)); };
    hsp::FreeSpaceLimits limits;
    for (uint32_t *limit : {&limits.cubes, &limits.entries, &limits.cells, &limits.adjacencies, &limits.landmarks,
                            &limits.facets, &limits.corners, &limits.cube_balls, &limits.cube_corners}) {
      *limit = few();
    }
    BuiltFreeSpace built(balls, limits);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_LE(built.retries(), 6U);
    EXPECT_EQ(built.space().cell_count(), expected.space().cell_count());
    EXPECT_EQ(built.space().adjacency_count(), expected.space().adjacency_count());
    EXPECT_EQ(built.space().region_count(), expected.space().region_count());
  }
}

// A pair that finds no room is counted once for a row of corners, not at each of them again.
TEST(FreeSpace, AsksForLittleMoreThanThereIsWithPortals) {
  oracle::RandomSource random(8);
  for (int k = 0; k < 20; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 20)));
    BuiltFreeSpace built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    if (built.space().adjacency_count() <= 1) continue;
    hsp::FreeSpaceLimits limits = built.builder().retry_limits();
    limits.adjacencies = 1;
    CarvedMemory memory;
    hsp::FreeSpaceBuilder builder;
    memory.carve(builder, limits, true);
    ASSERT_EQ(builder.build(built.grid()), hsp::Status::capacity);
    EXPECT_GE(builder.needed().adjacencies, built.space().adjacency_count());
    EXPECT_LE(builder.needed().adjacencies, built.space().adjacency_count() * 5 / 4 + 8);
  }
}

}  // namespace
