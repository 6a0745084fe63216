// Regions of random boxes against a flood of cells of a grid, which bounds their volumes from both sides, and against
// the classes of the tree; of molecules against the nesting that vertical rays find.
#include "pores/region_finder.hpp"

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
    status = finder.find(pores, hsp::BallsAround(periodic.get()), periodic->boundary(), &periodic.get(), 0);
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
    ASSERT_EQ(finder.find(pores.builder(), pores.grid(), topology.boundary(), nullptr, 0), hsp::Status::ok);
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

}  // namespace
