// Caps by sectors of longitude: none that a meridian meets is left out, and few others are looked at.
#include "sphere/meridian_sectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "built_grid.hpp"
#include "bumps.hpp"
#include "carved_memory.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

namespace {

// The caps of the large ball among bumps.
struct Bumps {
  Bumps(const oracle::Balls &balls)
      : built(oracle::in_lengths(balls, 1)),
        first(hsp::MeridianSectors::sectors_for(static_cast<uint32_t>(balls.size())) + 1),
        listed(hsp::MeridianSectors::entries_for_each * balls.size()) {
    const uint32_t n = static_cast<uint32_t>(balls.size());
    memory.carve(caps, n);
    const hsp::BallSet &set = built.grid().balls();
    uint32_t largest = 0;
    for (uint32_t i = 0; i < n; ++i) largest = set.r[i] > set.r[largest] ? i : largest;
    caps.gather(set, built.grid().block_around(built.grid().cube_at(set.ball(largest).centre)), largest, nullptr);
    sectors.start(caps, {{first.data(), static_cast<uint32_t>(first.size())},
                         {listed.data(), static_cast<uint32_t>(listed.size())}});
  }
  std::vector<uint32_t> visited(double x, double y) const {
    std::vector<uint32_t> found;
    sectors.visit(x, y, [&](uint32_t cap) {
      found.push_back(cap);
      return true;
    });
    return found;
  }

  BuiltGrid built;
  CarvedMemory memory;
  hsp::Caps caps;
  hsp::MeridianSectors sectors;
  std::vector<uint32_t> first, listed;
};

TEST(MeridianSectors, ListAllThatMeet) {
  oracle::RandomSource random(71);
  constexpr double sizes[][2] = {{0.00001, 0.00001}, {0.02, 0.3}, {0.0001, 1.2}, {0.1, 0.1}, {0.5, 0.9}, {0.01, 0.01}};
  uint64_t meetings = 0;
  for (const auto &[least, most] : sizes) {
    for (const uint32_t n : {260U, 1500U}) {
      const Bumps bumpy(bumps(random, n, least, most));
      const hsp::Caps &caps = bumpy.caps;
      ASSERT_EQ(bumpy.visited(-1.0, 0.0), bumpy.visited(1.0, 0.0));
      for (int turn = 0; turn < 300; ++turn) {
        // Along the axes of caps, beside them, through their rims, and anywhere.
        const uint32_t own = static_cast<uint32_t>(random.below(caps.count));
        const long double rim = std::acos(std::clamp<long double>(caps.b[own], -1, 1));
        long double angle = std::atan2(static_cast<long double>(caps.uy[own]), static_cast<long double>(caps.ux[own]));
        if (turn % 4 == 1) angle += 1e-9L;
        if (turn % 4 == 2) angle += rim / std::hypot(caps.ux[own], caps.uy[own]);
        if (turn % 4 == 3) angle = static_cast<long double>(random.in(0, 1000000)) * 1e-5L;
        const double x = static_cast<double>(std::cos(angle)), y = static_cast<double>(std::sin(angle));
        const std::vector<uint32_t> found = bumpy.visited(x, y);
        ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
        ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
        ASSERT_EQ(found, bumpy.visited(-x, -y)) << "a meridian is a whole circle";
        for (uint32_t k = 0; k < caps.count; ++k) {
          const long double from_plane =
              static_cast<long double>(caps.ux[k]) * y - static_cast<long double>(caps.uy[k]) * x;
          const long double b = caps.b[k];
          if (b > 0 && from_plane * from_plane > 1 - b * b) continue;
          ASSERT_TRUE(std::binary_search(found.begin(), found.end(), k)) << k << " of " << n;
          ++meetings;
        }
      }
    }
  }
  EXPECT_GT(meetings, 50000U);
}

// Marked for one cap, all meridians that meet it are, and few others.
TEST(MeridianSectors, MarkWhereCapsReach) {
  oracle::RandomSource random(73);
  for (const double size : {0.0001, 0.01, 0.2}) {
    const Bumps bumpy(bumps(random, 1500, size, size));
    const hsp::Caps &caps = bumpy.caps;
    uint32_t marked = 0, met = 0, wide = 0;
    for (uint32_t cap = 0; cap < caps.count; cap += 7) {
      bumpy.sectors.clear_marks();
      EXPECT_FALSE(bumpy.sectors.is_marked(caps.ux[cap], caps.uy[cap]));
      bumpy.sectors.mark(caps, cap);
      EXPECT_TRUE(bumpy.sectors.is_marked(caps.ux[cap], caps.uy[cap]));
      const double across = std::hypot(caps.ux[cap], caps.uy[cap]);
      const double sine = std::sqrt(1 - caps.b[cap] * caps.b[cap]) / across;
      if (sine >= 0.49) continue;
      for (int turn = 0; turn < 400; ++turn) {
        const double angle = 0.007853981 * turn;
        const double x = std::cos(angle), y = std::sin(angle);
        const bool meets = std::fabs(caps.ux[cap] * y - caps.uy[cap] * x) < sine * across;
        const bool is_marked = bumpy.sectors.is_marked(x, y);
        EXPECT_TRUE(is_marked || !meets) << cap << " at " << angle;
        marked += is_marked ? 1 : 0;
        met += meets ? 1 : 0;
        ++wide;
      }
    }
    EXPECT_GT(wide, 10000U);
    EXPECT_LT(marked, met + wide / 100);
  }
}

// About as many as lie on a meridian, for small caps all over the ball.
TEST(MeridianSectors, LookAtFew) {
  oracle::RandomSource random(72);
  const Bumps bumpy(bumps(random, 4000, 0.01, 0.01));
  uint64_t looked_at = 0;
  for (int turn = 0; turn < 200; ++turn) {
    const double angle = 0.1 * turn;
    looked_at += bumpy.visited(std::cos(angle), std::sin(angle)).size();
  }
  EXPECT_LT(looked_at, 200U * bumpy.caps.count / 32);
}

// After any of them, small or wide.
TEST(MeridianSectors, StopAfterAnyCap) {
  oracle::RandomSource random(74);
  const Bumps of_small(bumps(random, 1500, 0.01, 0.9)), of_wide(bumps(random, 100, 0.6, 0.9));
  for (const Bumps *bumpy : {&of_small, &of_wide}) {
    const size_t all = bumpy->visited(1.0, 0.0).size();
    for (size_t last = 1; last <= all; ++last) {
      size_t visits = 0;
      bumpy->sectors.visit(1.0, 0.0, [&](uint32_t) { return ++visits < last; });
      ASSERT_EQ(visits, last);
    }
  }
}

}  // namespace
