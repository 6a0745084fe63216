// Pores of boxes of any three vectors: points that go in and come out are in the caller's frame, by distances of our
// own; and plugs that come out can be given back.
#include <gtest/gtest.h>

#include <algorithm>

#include "../boxes/any_box.hpp"
#include "owned_spaces.hpp"

namespace {

using boxes::AnyBox;
using boxes::Computed;
using boxes::Vector;
using support::Random;

class Pores {
 public:
  explicit Pores(const Computed &computed) {
    hsp_pores_limits limits{};
    support::expect_ok(hsp_pores_limits_init(&limits, sizeof limits, computed.set().n()), "limits");
    owned_.take(limits);
    owned_.compute([&](hsp_pores *handle, hsp_pores_limits *asked) {
      return hsp_pores_compute_periodic(handle, computed.get(), nullptr, asked);
    });
    hsp_pores_counts counts{};
    support::expect_ok(hsp_pores_get_counts(get(), &counts), "counts");
    maxima.resize(counts.maxima);
    gates.resize(counts.gates);
    support::expect_ok(hsp_pores_get_maxima(get(), 0, counts.maxima, maxima.data()), "maxima");
    support::expect_ok(hsp_pores_get_gates(get(), 0, counts.gates, gates.data()), "gates");
  }
  hsp_pores *get() const { return owned_.get(); }

  std::vector<hsp_pore_maximum> maxima;
  std::vector<hsp_pore_gate> gates;

 private:
  support::OwnedHandle<support::PoresKind> owned_;
};

// To the sphere that is nearest, among all images.
double clearance(const AnyBox &set, const double *point) {
  double least = 1e9;
  for (uint32_t i = 0; i < set.n(); ++i) {
    const Vector own = set.fractions(set.centre(i)), there = set.fractions(point);
    for (int32_t k = 0; k < 343; ++k) {
      const int32_t step[3] = {k % 7 - 3, k / 7 % 7 - 3, k / 49 - 3};
      int32_t shift[3];
      for (size_t row = 0; row < 3; ++row)
        shift[row] = step[row] + static_cast<int32_t>(std::lround(there[row] - own[row]));
      const Vector at = set.image(i, shift);
      const double x = at[0] - point[0], y = at[1] - point[1], z = at[2] - point[2];
      least = std::min(least, std::sqrt(x * x + y * y + z * z) - set.balls.radius[i]);
    }
  }
  return least;
}

TEST(TurnedPores, HavePointsInTheCallersFrame) {
  Random random(751);
  size_t points = 0, ways = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Computed computed(boxes::random_box(random, 2));
    const AnyBox &set = computed.set();
    const Pores pores(computed);
    for (const auto &maximum : pores.maxima) EXPECT_NEAR(clearance(set, maximum.xyz), maximum.radius, 1e-5);
    for (const auto &gate : pores.gates) EXPECT_NEAR(clearance(set, gate.xyz), gate.radius, 1e-5);
    points += pores.maxima.size() + pores.gates.size();
    const size_t asked = std::min<size_t>(4, pores.maxima.size());
    for (uint32_t k = 0; k < asked; ++k) {
      const hsp_pore_maximum &maximum = pores.maxima[k];
      // A little beside it the way up leads back, and the clearance is what distances say.
      const double beside[3] = {maximum.xyz[0] + 0.01, maximum.xyz[1] - 0.02, maximum.xyz[2] + 0.01};
      hsp_pore_place place{};
      ASSERT_EQ(hsp_pores_locate(pores.get(), beside, &place), HSP_OK);
      EXPECT_NEAR(place.radius, clearance(set, beside), 1e-5);
      hsp_pore_passage passage{};
      ASSERT_EQ(hsp_pores_widest(pores.get(), beside, nullptr, &passage), HSP_OK);
      hsp_tunnel tunnel{};
      ASSERT_EQ(hsp_pores_find_tunnel(pores.get(), maximum.xyz, pores.maxima[0].xyz, nullptr, 0, &tunnel, nullptr),
                HSP_OK);
      std::vector<hsp_tunnel_point> way(tunnel.points);
      uint32_t needed = 0;
      ASSERT_EQ(hsp_pores_get_tunnel_points(pores.get(), way.data(), tunnel.points, &needed), HSP_OK);
      for (const hsp_tunnel_point &point : way) EXPECT_NEAR(clearance(set, point.xyz), point.radius, 1e-5);
      if (!way.empty()) {
        for (size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(way[0].xyz[axis], maximum.xyz[axis], 1e-6);
        ++ways;
      }
    }
  }
  EXPECT_GT(points, 200U);
  EXPECT_GT(ways, 20U);
}

TEST(TurnedPores, TakeTheirPlugsBack) {
  Random random(752);
  size_t measured = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const Computed computed(boxes::random_box(random, 3));
    const Pores pores(computed);
    if (pores.maxima.empty() || !(pores.maxima[0].radius > 0.2)) continue;
    uint32_t pockets = 0, needed = 0;
    ASSERT_EQ(hsp_pores_find_pockets(pores.get(), 0.05, 0.9 * pores.maxima[0].radius, &pockets), HSP_OK);
    ASSERT_EQ(hsp_pores_get_plugged_balls(pores.get(), nullptr, nullptr, 0, &needed), HSP_OK);
    AnyBox plugged = computed.set();
    plugged.balls.xyz.resize(3 * size_t{needed});
    plugged.balls.radius.resize(needed);
    plugged.sigma.resize(needed);
    ASSERT_EQ(hsp_pores_get_plugged_balls(pores.get(), plugged.balls.xyz.data(), plugged.balls.radius.data(), needed,
                                          &needed),
              HSP_OK);
    const Computed again(plugged);
    const Pores narrow(again);
    std::vector<hsp_pore_pocket_size> size(pockets + 1);
    EXPECT_EQ(hsp_pores_measure_pockets(pores.get(), narrow.get(), nullptr, size.data(), pockets, &needed), HSP_OK);
    EXPECT_EQ(needed, pockets);
    // The same balls in a box that lies otherwise are others.
    const Computed elsewhere(plugged.turned(boxes::random_rotation(random)));
    const Pores turned(elsewhere);
    EXPECT_EQ(hsp_pores_measure_pockets(pores.get(), turned.get(), nullptr, size.data(), pockets, &needed),
              HSP_E_ARGUMENT);
    ++measured;
  }
  EXPECT_GT(measured, 3U);
}

}  // namespace
