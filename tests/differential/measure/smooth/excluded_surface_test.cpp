// Area and volume of the solvent-excluded surface against lines through its definition, for sets whose surface meets
// itself in every way, and against each other: what the volume loses while the probe grows inside the same spheres is
// the area.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "excluded_surface.hpp"
#include "molecule_file.hpp"
#include "owned_handle.hpp"
#include "owned_surfaces.hpp"
#include "random_numbers.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Point;
using oracle::ProbedBall;

std::vector<uint32_t> shells_of_region(const hsp_boundary *boundary, uint32_t region) {
  support::OwnedTopology topology;
  topology.take(support::topology_limits_for(boundary));
  topology.compute([&](hsp_topology *handle, hsp_topology_limits *limits) {
    return hsp_topology_compute(handle, boundary, limits);
  });
  hsp_topology_counts counts;
  support::expect_ok(hsp_topology_get_counts(topology.get(), &counts), "hsp_topology_get_counts");
  EXPECT_EQ(counts.regions, 2U);
  std::vector<uint32_t> shells(counts.shells);
  uint32_t needed = 0;
  support::expect_ok(hsp_topology_get_region_shells(topology.get(), region, shells.data(), counts.shells, &needed),
                     "hsp_topology_get_region_shells");
  shells.resize(needed);
  return shells;
}

// Of the whole complement, or of one of its regions.
hsp_surface_totals library_surface(const std::vector<ProbedBall> &balls, double probe, hsp_surface_counts &counts,
                                   uint32_t region = HSP_NONE) {
  support::BallList list;
  for (const ProbedBall &ball : balls) {
    list.add(ball.centre[0], ball.centre[1], ball.centre[2], ball.radius - probe);
  }
  hsp_model_options options;
  support::expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
  options.probe = probe;
  support::OwnedModel model(list.size());
  support::expect_ok(model.set(list, &options), "hsp_model_set");
  support::OwnedBoundary boundary;
  boundary.take(support::default_boundary_limits(list.size()));
  boundary.compute([&](hsp_boundary *handle, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(handle, model.get(), limits);
  });
  support::OwnedSurface surface;
  surface.take(support::surface_limits_for(boundary.get()));
  const std::vector<uint32_t> shells =
      region == HSP_NONE ? std::vector<uint32_t>{} : shells_of_region(boundary.get(), region);
  surface.compute([&](hsp_surface *handle, hsp_surface_limits *limits) {
    return region == HSP_NONE ? hsp_surface_compute(handle, boundary.get(), limits)
                              : hsp_surface_compute_shells(handle, boundary.get(), shells.data(),
                                                           static_cast<uint32_t>(shells.size()), limits);
  });
  hsp_surface_totals totals;
  support::expect_ok(hsp_surface_measure(surface.get(), &totals, nullptr, 0, nullptr), "hsp_surface_measure");
  support::expect_ok(hsp_surface_get_counts(surface.get(), &counts), "hsp_surface_get_counts");
  return totals;
}

void expect_as_by_lines(const std::vector<ProbedBall> &balls, double probe, int lines, double tolerance,
                        hsp_surface_counts &counts, uint32_t region = HSP_NONE,
                        const oracle::Room &room = oracle::everywhere) {
  const hsp_surface_totals found = library_surface(balls, probe, counts, region);
  const oracle::AreaAndVolume expected = oracle::excluded_surface_by_lines(balls, probe, lines, room);
  EXPECT_NEAR(found.volume, expected.volume, tolerance * std::abs(found.volume));
  EXPECT_NEAR(found.area, expected.area, tolerance * found.area);
}

TEST(ExcludedSurface, WhereItMeetsItself) {
  const double a = 1.79555934;
  struct Set {
    std::vector<ProbedBall> balls;
    uint32_t cusped, cut;
  };
  const Set sets[] = {{{{{0, 0, 0}, 3.1}, {{6.1, 0, 0}, 3.1}}, 1, 0},
                      {{{{2.9, 0, 0}, 3.1}, {{-1.45, 2.51147367, 0}, 3.1}, {{-1.45, -2.51147367, 0}, 3.1}}, 0, 2},
                      {{{{a, a, a}, 3.1}, {{a, -a, -a}, 3.1}, {{-a, a, -a}, 3.1}, {{-a, -a, a}, 3.1}}, 0, 8}};
  for (const Set &set : sets) {
    hsp_surface_counts counts;
    expect_as_by_lines(set.balls, 1.4, 64, 2e-3, counts);
    EXPECT_EQ(counts.cusped_patches, set.cusped);
    EXPECT_EQ(counts.cut_patches, set.cut);
  }
}

TEST(ExcludedSurface, OfRandomSets) {
  support::Random random(20261121);
  uint32_t cut = 0, cusped = 0;
  for (int k = 0; k < oracle::sets(20); ++k) {
    const double probe = 1 + 0.5 * random.below(4);
    std::vector<ProbedBall> balls(6);
    for (ProbedBall &ball : balls) {
      for (double &coordinate : ball.centre) coordinate = static_cast<double>(random.below(600)) / 100;
      ball.radius = probe + 0.8 + static_cast<double>(random.below(80)) / 100;
    }
    hsp_surface_counts counts;
    SCOPED_TRACE(k);
    expect_as_by_lines(balls, probe, 56, 3e-3, counts);
    cut += counts.cut_patches;
    cusped += counts.cusped_patches;
  }
  if (oracle::sets_for_one == 1) {
    EXPECT_GT(cut, 25U);
    EXPECT_GT(cusped, 5U);
  }
}

// Six balls around a void, almost as an octahedron: probes inside and outside overlap, also such that have no two balls
// in common. A point that is in no ball is in the void if it is in the convex hull of the centres.
class Cage {
 public:
  explicit Cage(support::Random &random) {
    const auto shaken = [&random](double x) { return x + (static_cast<double>(random.below(101)) - 50) / 500; };
    for (size_t k = 0; k < 6; ++k) {
      ProbedBall ball{{}, 3.1};
      for (size_t axis = 0; axis < 3; ++axis) {
        ball.centre[axis] = shaken(axis != k / 2 ? 0.0 : k % 2 == 0 ? 3.4 : -3.4);
      }
      balls_.push_back(ball);
    }
    for (size_t i = 0; i < 6; ++i) {
      for (size_t j = 0; j < 6; ++j) {
        for (size_t k = 0; k < 6; ++k) add_facet(i, j, k);
      }
    }
  }
  [[nodiscard]] const std::vector<ProbedBall> &balls() const { return balls_; }
  [[nodiscard]] bool encloses(const Point &y) const {
    return std::all_of(facets_.begin(), facets_.end(), [&](const Facet &facet) { return facet.above(y) < 0; });
  }

 private:
  struct Facet {
    Point normal;
    double height;
    [[nodiscard]] double above(const Point &y) const {
      return normal[0] * y[0] + normal[1] * y[1] + normal[2] * y[2] - height;
    }
  };
  void add_facet(size_t i, size_t j, size_t k) {
    if (i == j || j == k || k == i) return;
    const auto &a = balls_[i].centre, &b = balls_[j].centre, &c = balls_[k].centre;
    Facet facet{{(b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
                 (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]),
                 (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])},
                0};
    facet.height = facet.above(a);
    for (size_t m = 0; m < balls_.size(); ++m) {
      if (m != i && m != j && m != k && facet.above(balls_[m].centre) > 0) return;
    }
    facets_.push_back(facet);
  }

  std::vector<ProbedBall> balls_;
  std::vector<Facet> facets_;
};

// The outer region alone, the void alone, both: where probes of the two overlap they cut each other only in the last.
TEST(ExcludedSurface, OfOneRegion) {
  const double a = 1.79555934;
  const std::vector<ProbedBall> four = {{{a, a, a}, 3.1}, {{a, -a, -a}, 3.1}, {{-a, a, -a}, 3.1}, {{-a, -a, a}, 3.1}};
  const auto is_near = [](const Point &y) { return y[0] * y[0] + y[1] * y[1] + y[2] * y[2] < 1; };
  hsp_surface_counts counts;
  expect_as_by_lines(four, 1.4, 64, 2e-3, counts, 0, [&](const Point &y) { return !is_near(y); });
  EXPECT_EQ(counts.cut_patches, 0U);
  expect_as_by_lines(four, 1.4, 64, 3e-3, counts, 1, is_near);
  EXPECT_EQ(counts.cut_patches, 0U);
  support::Random random(16);
  for (const double probe : {1.4, 1.8, 2.2, 2.4}) {
    if (oracle::emulated && probe > 1.4) break;
    SCOPED_TRACE(probe);
    const Cage cage(random);
    const auto is_void = [&](const Point &y) { return cage.encloses(y); };
    expect_as_by_lines(cage.balls(), probe, 50, 3e-2, counts);
    expect_as_by_lines(cage.balls(), probe, 50, 3e-2, counts, 0, [&](const Point &y) { return !is_void(y); });
    expect_as_by_lines(cage.balls(), probe, 50, 3e-2, counts, 1, is_void);
  }
}

// The surfaces {f = t} at the distance t from the outside of the same spheres are parallel: V' = -A. So the volume is
// that of the union, which knows nothing of patches, less the integral of the areas on the way, on which cusps and cuts
// are born. Gauss's rule with eight points on each of some intervals; where something is born A has the power 3/2 of t.
struct ParallelSurfaces {
  double union_volume = 0, integral = 0, volume = 0;
  uint32_t cut = 0, cusped = 0;

  ParallelSurfaces(const std::vector<ProbedBall> &balls, double probe, int intervals) {
    constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    hsp_surface_counts counts;
    union_volume = library_surface(balls, 0, counts).volume;
    const double half = 0.5 * probe / intervals;
    for (int k = 0; k < intervals; ++k) {
      for (int j = 0; j < 8; ++j) {
        const double t = half * (2 * k + 1 + (j % 2 == 0 ? node[j / 2] : -node[j / 2]));
        integral += half * weight[j / 2] * library_surface(balls, t, counts).area;
      }
    }
    volume = library_surface(balls, probe, counts).volume;
    cut = counts.cut_patches;
    cusped = counts.cusped_patches;
  }
};

TEST(ExcludedSurface, VolumesFallByTheAreas) {
  support::Random random(20261122);
  uint32_t cut = 0, cusped = 0;
  for (int k = 0; k < oracle::sets(40); ++k) {
    const double probe = 0.8 + 0.4 * random.below(4);
    std::vector<ProbedBall> balls(8);
    for (ProbedBall &ball : balls) {
      for (double &coordinate : ball.centre) coordinate = static_cast<double>(random.below(600)) / 100;
      ball.radius = probe + 0.8 + static_cast<double>(random.below(80)) / 100;
    }
    SCOPED_TRACE(k);
    const ParallelSurfaces surfaces(balls, probe, 12);
    EXPECT_NEAR(surfaces.volume, surfaces.union_volume - surfaces.integral, 1e-6 * surfaces.union_volume);
    cut += surfaces.cut;
    cusped += surfaces.cusped;
  }
  if (oracle::sets_for_one == 1) {
    EXPECT_GT(cut, 60U);
    EXPECT_GT(cusped, 20U);
  }
}

TEST(ExcludedSurface, VolumeOfCrambinFallsByTheAreas) {
  const support::BallList atoms =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  std::vector<ProbedBall> balls(atoms.size());
  for (size_t i = 0; i < balls.size(); ++i) {
    balls[i] = {{atoms.xyz[3 * i], atoms.xyz[3 * i + 1], atoms.xyz[3 * i + 2]}, atoms.radius[i] + 1.4};
  }
  const ParallelSurfaces surfaces(balls, 1.4, 12);
  EXPECT_NEAR(surfaces.volume, surfaces.union_volume - surfaces.integral, 1e-8 * surfaces.union_volume);
}

}  // namespace
