// Regions of random boxes against a flood of cells of a grid, which bounds their volumes from both sides, and against
// the classes of the tree; of molecules against the nesting that vertical rays find.
#include "pockets/region_finder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "box_flood.hpp"
#include "built_periodic.hpp"
#include "built_pores.hpp"
#include "built_topology.hpp"
#include "pore_sets.hpp"
#include "sweep_length.hpp"
#include "topology/shell_volumes.hpp"

namespace {

constexpr int64_t unit = 100000000;

struct FoundRegions {
  FoundRegions(const oracle::Balls &balls, const oracle::BoxRows &box)
      : periodic(BuiltPores::listed(balls), vectors_of(box)) {
    hsp::PoreLimits limits{4000, 4000, 8000, 8000, 20000, 4000};
    pores_memory.carve(pores, limits);
    EXPECT_EQ(pores.build(periodic->images(), 0), hsp::Status::ok);
    finder_memory.carve(finder, limits);
    status = finder.find(pores, hsp::BallsAround(periodic.get()), periodic->boundary(), &periodic.get(), 0, hsp::no_id);
  }
  static BoxVectors vectors_of(const oracle::BoxRows &box) {
    BoxVectors vectors;
    for (size_t k = 0; k < 9; ++k) vectors[k] = static_cast<double>(box[k / 3][k % 3]);
    return vectors;
  }

  BuiltPeriodic periodic;
  CarvedMemory pores_memory, finder_memory;
  hsp::PoresBuilder pores;
  hsp::RegionFinder finder;
  hsp::Status status;
};

TEST(RegionFinder, VolumesAreBetweenThoseOfCells) {
  oracle::RandomSource random(4);
  int several = 0, blocked = 0, compared = 0;
  for (int trial = 0; trial < oracle::sets(24); ++trial) {
    const auto side = [&] { return random.in(2 * unit, 3 * unit); };
    oracle::BoxRows box = {{{side(), 0, 0}, {0, side(), 0}, {0, 0, side()}}};
    if (trial % 2 == 1) {
      box[1][0] = random.in(-unit, unit);
      box[2][0] = random.in(-unit, unit);
      box[2][1] = random.in(-unit, unit);
    }
    oracle::Balls balls;
    for (int64_t k = random.in(2, 14); k > 0; --k) {
      const auto at = [&] { return random.in(-unit, 3 * unit); };
      balls.push_back({at(), at(), at(), random.in(unit * 3 / 5, unit * 6 / 5)});
    }
    const FoundRegions found(balls, box);
    ASSERT_EQ(found.status, hsp::Status::ok);
    const double whole = found.periodic->images().box().volume();
    std::vector<double> volumes;
    double sum = 0.0;
    for (const hsp::PoreRegion &region : found.finder.regions()) {
      volumes.push_back(region.volume / whole);
      sum += region.volume / whole;
      blocked += region.is_accessible() ? 0 : 1;
    }
    const hsp::PeriodicTotals totals = found.periodic.totals();
    ASSERT_NEAR(sum, totals.free_volume / totals.box_volume, 1e-12);
    std::sort(volumes.rbegin(), volumes.rend());
    several += volumes.size() > 1 ? 1 : 0;
    const oracle::VolumeBounds bounds = oracle::free_volumes(balls, box, 0.0, 16);
    // Cells that are free may be many components of one region, but none is of two.
    if (!bounds.least.empty()) {
      ASSERT_GE(volumes.at(0), bounds.least[0]);
    }
    if (bounds.most.size() != volumes.size()) continue;
    for (size_t k = 0; k < volumes.size(); ++k) ASSERT_LE(volumes[k], bounds.most[k]);
    ++compared;
  }
  if (oracle::sets(24) < 24) return;
  EXPECT_GT(several, 2);
  EXPECT_GT(blocked, 3);
  EXPECT_GT(compared, 4);
}

TEST(RegionFinder, OfMoleculesTheyAreThoseOfVerticalRays) {
  oracle::RandomSource random(9);
  int voids = 0;
  for (int trial = 0; trial < oracle::sets(60); ++trial) {
    oracle::Balls balls;  // around a place that is free, and some that float there
    for (int k = 0; k < 100; ++k) {
      const double z = 2.0 * random.fraction() - 1.0, turn = 6.283185307179586 * random.fraction();
      const double across = std::sqrt(1.0 - z * z), far = 2.0 * static_cast<double>(unit);
      const auto along = [&](double part) { return static_cast<int64_t>(part * far) + random.in(-unit / 5, unit / 5); };
      balls.push_back(
          {along(across * std::cos(turn)), along(across * std::sin(turn)), along(z), random.in(unit * 3 / 4, unit)});
    }
    for (int64_t k = random.in(0, 2); k > 0; --k) {
      balls.push_back(
          {random.in(-unit / 2, unit / 2), random.in(-unit / 2, unit / 2), random.in(-unit, unit), unit / 8});
    }
    BuiltPores pores(balls, 0);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    BuiltTopology topology(balls);
    CarvedMemory memory;
    hsp::RegionFinder finder;
    memory.carve(finder, hsp::PoreLimits{400, 4000, 0, 0, 0, 0});
    ASSERT_EQ(finder.find(pores.builder(), pores.grid(), topology.boundary(), nullptr, 0, hsp::no_id), hsp::Status::ok);
    std::vector<std::array<double, 2>> one, other;
    for (const hsp::PoreRegion &region : finder.regions()) {
      one.push_back({region.maximum == hsp::pore_outside ? 0.0 : region.volume, region.area});
    }
    struct Region {
      double area, volume;
      uint32_t enclosing_shell, components, shells;
    };
    std::vector<Region> regions(topology.structure().region_count);
    hsp::measure_regions(topology.balls(), topology.boundary(), topology.structure(),
                         hsp::Span<Region>(regions.data(), static_cast<uint32_t>(regions.size())));
    for (const Region &region : regions) other.push_back({region.volume, region.area});
    ASSERT_EQ(one.size(), other.size());
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    for (size_t k = 0; k < one.size(); ++k) {
      for (size_t part = 0; part < 2; ++part) ASSERT_NEAR(one[k][part], other[k][part], 1e-9 * (1.0 + other[k][part]));
    }
    voids += static_cast<int>(one.size()) - 1;
  }
  EXPECT_GT(voids, 3);
}

// Regions of some balls by the tree of pores above a floor, in the order of the list.
struct MoleculeRegions {
  MoleculeRegions(const oracle::Balls &balls, int64_t floor) : pores(balls, floor), topology(balls) {
    EXPECT_EQ(pores.status(), hsp::Status::ok);
    const auto n = static_cast<uint32_t>(balls.size());
    memory.carve(finder, hsp::PoreLimits{n, 8 * n + 64, 0, 0, 0, 0});
    status = finder.find(pores.builder(), pores.grid(), topology.boundary(), nullptr, floor, hsp::no_id);
  }

  BuiltPores pores;
  BuiltTopology topology;
  CarvedMemory memory;
  hsp::RegionFinder finder;
  hsp::Status status;
};

// With the floor 0 integers leave out of the list what is not above it. With others levels are compared with 0 later.
// Returns how many regions there are beside the outside.
uint32_t check_floors(const oracle::Balls &balls) {
  MoleculeRegions expected(balls, 0);
  EXPECT_EQ(expected.status, hsp::Status::ok);
  const auto one = expected.finder.regions();
  EXPECT_EQ(one.size(), expected.topology.structure().region_count);
  for (const int64_t floor : {INT64_C(-1), BuiltPores::lowest(balls)}) {
    const MoleculeRegions found(balls, floor);
    EXPECT_EQ(found.status, hsp::Status::ok);
    const auto other = found.finder.regions();
    EXPECT_EQ(one.size(), other.size());
    for (uint32_t k = 0; k < one.size() && k < other.size(); ++k) {
      EXPECT_EQ(one[k].maximum, other[k].maximum);
      EXPECT_EQ(one[k].maxima, other[k].maxima);
      EXPECT_EQ(one[k].shells, other[k].shells);
      EXPECT_EQ(one[k].volume, other[k].volume);
    }
  }
  return one.size() - 1;
}

// A whole number r with r^2 + 1 = a^2 + b^2 for an a between 0.45 r and 0.55 r.
struct NearCircle {
  int64_t r, a, b;
};
NearCircle next_near_circle(int64_t r) {
  for (;; ++r) {
    for (int64_t a = r * 9 / 20; a < r * 11 / 20; ++a) {
      const int64_t rest = r * r + 1 - a * a;
      const auto b = static_cast<int64_t>(std::sqrt(static_cast<double>(rest)));
      if (b * b == rest) return {r, a, b};
    }
  }
}

// Two cavities on both sides of three balls around the origin, in a shell of balls.
oracle::Balls neck(int64_t r, const std::array<std::array<int64_t, 2>, 3> &centres, size_t first_axis) {
  oracle::Balls balls;
  const auto add = [&](int64_t x, int64_t y, int64_t z, int64_t radius) {
    const std::array<int64_t, 3> at{x, y, z};
    balls.push_back({at[(3 - first_axis) % 3], at[(4 - first_axis) % 3], at[(5 - first_axis) % 3], radius});
  };
  for (const auto &centre : centres) add(centre[0], centre[1], 0, r);
  for (int k = 0; k < 150; ++k) {
    const double z = (2.0 * k + 1.0) / 150.0 - 1.0, turn = 2.399963229728653 * k, across = std::sqrt(1.0 - z * z);
    const auto along = [&](double part) { return static_cast<int64_t>(3.0 * static_cast<double>(r) * part); };
    add(along(across * std::cos(turn)), along(across * std::sin(turn)), along(z), r * 11 / 5);
  }
  return balls;
}

TEST(RegionFinder, AGateAsWideAsAPointSeparatesOneThatIsWiderByLittleDoesNot) {
  for (size_t axis = 0; axis < 3; ++axis) {
    // 33^2 + 56^2 = 65^2.
    const int64_t k = 100000 + 777 * static_cast<int64_t>(axis);
    EXPECT_EQ(check_floors(neck(65 * k, {{{65 * k, 0}, {-33 * k, 56 * k}, {-33 * k, -56 * k}}}, axis)), 2U);
    // Its level is 1 / (2 r) of a step, less than levels are rounded to.
    const NearCircle circle = next_near_circle(5000000 + 12345 * static_cast<int64_t>(axis));
    const auto [r, a, b] = circle;
    EXPECT_EQ(check_floors(neck(r, {{{r, 1}, {-a, b}, {-a, -b}}}, axis)), 1U);
    EXPECT_EQ(check_floors(neck(r + 1, {{{r, 1}, {-a, b}, {-a, -b}}}, axis)), 2U);
  }
}

// Bricks of balls with the edges 6 and 8: with the radius 5 those of a face 6 by 8 leave a point in its middle, those
// of one 6 by 6 none, and those of one 8 by 8 a way through. Balls with the radius 3 touch along edges.
TEST(RegionFinder, BricksThatTouchAreTheSameFromAnyFloor) {
  oracle::RandomSource random(51);
  uint32_t regions = 0;
  for (int trial = 0; trial < oracle::sets(40); ++trial) {
    constexpr int64_t scale = 1000000;
    oracle::Balls balls;
    int64_t at[3][4] = {};
    for (auto &places : at) {
      for (size_t k = 1; k < 4; ++k) places[k] = places[k - 1] + (random.one_in(2) ? 6 : 8) * scale;
    }
    const int64_t more = random.one_in(3) ? random.in(-1, 1) : 0;
    for (const int64_t x : at[0]) {
      for (const int64_t y : at[1]) {
        for (const int64_t z : at[2]) {
          if (random.one_in(12)) continue;
          balls.push_back({x, y, z, (random.one_in(12) ? random.in(3, 4) : 5) * scale + more});
        }
      }
    }
    regions += check_floors(balls);
    ASSERT_FALSE(testing::Test::HasFailure()) << trial;
  }
  if (oracle::sets(40) < 40) return;
  EXPECT_GT(regions, 100U);
}

// A region that two have a claim on is no one's: of two pockets, or of one and of none, in either order.
TEST(RegionFinder, ClaimsOfTwoAreShared) {
  const oracle::Balls ball{{0, 0, 0, unit}};
  for (const auto &[first, second] : {std::pair{3U, 4U}, std::pair{3U, hsp::no_id}, std::pair{hsp::no_id, 3U}}) {
    MoleculeRegions found(ball, 0);
    ASSERT_EQ(found.finder.regions().size(), 1U);
    found.finder.claim(0, first);
    found.finder.claim(0, first);
    EXPECT_EQ(found.finder.regions()[0].owner, first);
    EXPECT_FALSE(found.finder.regions()[0].is_shared);
    found.finder.claim(0, second);
    EXPECT_TRUE(found.finder.regions()[0].is_shared);
  }
}

}  // namespace
