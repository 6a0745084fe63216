// Sets that are too degenerate for a smooth surface, for triangles or for a map have a status that says so.
// HSP_E_CHECK would be a fault of the library.
#include <gtest/gtest.h>
#include <hardsphere_workspace.h>

#include <cmath>
#include <map>
#include <vector>

#include "random_numbers.hpp"
#include "sweep_length.hpp"

namespace {

using Random = support::RandomNumbers<support::SplitMix64>;

struct Set {
  std::vector<double> xyz, radius;
  double probe = 0;

  void add(double x, double y, double z, double r) {
    xyz.insert(xyz.end(), {x, y, z});
    radius.push_back(r);
  }
};

// Points or tiny balls on a small lattice, off it by so much, under a probe larger than they are.
Set near_lattice(Random &random, int64_t n, double radius, double off) {
  Set set;
  const auto at = [&] { return static_cast<double>(random.in(0, 1)) + off * static_cast<double>(random.in(-9, 9)); };
  for (int64_t k = 0; k < n; ++k) {
    const double x = at(), y = at(), z = at();
    set.add(x, y, z, radius);
  }
  set.probe = static_cast<double>(random.in(1, 4));
  return set;
}

// Tiny balls about the surface of a huge one.
Set on_a_huge_ball(Random &random, double size) {
  Set set;
  set.add(0, 0, 0, size);
  for (int k = 0; k < 2; ++k) {
    const auto off = [&] { return static_cast<double>(random.in(-2, 2)); };
    set.add(0.8 * size + off(), off(), 0.6 * size + off(), static_cast<double>(random.in(1, 3)));
  }
  return set;
}

// Balls of equal size on a lattice, many of which touch, a little off it or not.
Set touching(Random &random, double off) {
  Set set;
  for (int64_t n = random.in(2, 7); n > 0; --n) {
    const auto at = [&] { return static_cast<double>(random.in(0, 3)) + off * static_cast<double>(random.in(-9, 9)); };
    const double x = at(), y = at(), z = at();
    set.add(x, y, z, random.one_in(2) ? 0.5 : 1.0);
  }
  return set;
}

class Statuses {
 public:
  Statuses() = default;
  ~Statuses() { hsp_workspace_free(&work_); }
  Statuses(const Statuses &) = delete;
  Statuses &operator=(const Statuses &) = delete;

  void take(const Set &set) {
    hsp_model_options options;
    ASSERT_EQ(hsp_model_options_init(&options, sizeof options), HSP_OK);
    options.probe = set.probe;
    const auto n = static_cast<uint32_t>(set.radius.size());
    ASSERT_EQ(hsp_workspace_set(&work_, n, set.xyz.data(), set.radius.data(), &options, nullptr), HSP_OK);
    ASSERT_EQ(hsp_workspace_boundary(&work_), HSP_OK);
  }
  void mesh_of_boundary(double edge) { count(hsp_workspace_mesh(&work_, 0, edge)); }
  void mesh_of_surface(double edge) {
    const int32_t status = hsp_workspace_surface(&work_);
    count(status == HSP_OK ? hsp_workspace_mesh(&work_, 1, edge) : status);
  }
  void map_from(double x, double y, double z) {
    hsp_view_options options;
    ASSERT_EQ(hsp_view_options_init(&options, sizeof options), HSP_OK);
    options.towards[0] = x;
    options.towards[1] = y;
    options.towards[2] = z;
    count(hsp_workspace_map(&work_, &options));
  }
  std::map<int32_t, int> found;

 private:
  void count(int32_t status) {
    ++found[status];
    EXPECT_TRUE(status == HSP_OK || status == HSP_E_DEGENERATE) << hsp_status_text(status);
  }
  hsp_workspace work_{};
};

TEST(DegenerateStatuses, AreNoFaultsOfTheLibrary) {
  Statuses statuses;
  Random random(20261127);
  for (int k = 0; k < oracle::rounds(120, 2500); ++k) {
    SCOPED_TRACE(k);
    const double radii[] = {0, 0.01, 0.1, 1}, offsets[] = {0, 1e-8, 1e-7, 1e-6};
    const double radius = radii[random.below(4)], off = offsets[random.below(4)];
    const Set points = near_lattice(random, random.in(3, 5), radius, off);
    statuses.take(points);
    statuses.mesh_of_surface(0.3 * points.probe);
    const double size = std::pow(10.0, static_cast<double>(random.in(4, 6)));
    statuses.take(on_a_huge_ball(random, size));
    statuses.mesh_of_boundary(0.4 * size);
    statuses.take(touching(random, offsets[random.below(4)]));
    for (int views = 0; views < 2; ++views) {
      double towards[3] = {0, 0, 0};
      while (towards[0] == 0 && towards[1] == 0 && towards[2] == 0) {
        for (double &part : towards) part = static_cast<double>(random.in(-3, 3));
      }
      statuses.map_from(towards[0], towards[1], towards[2]);
    }
  }
  EXPECT_GT(statuses.found[HSP_E_DEGENERATE], 0);
  EXPECT_GT(statuses.found[HSP_OK], statuses.found[HSP_E_DEGENERATE]);
}

}  // namespace
