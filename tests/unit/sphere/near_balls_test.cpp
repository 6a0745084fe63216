// Caps four at a time, by the kernels of each target, against those one at a time: the same bits.
#include "sphere/near_balls.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "carved_memory.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"
#include "sphere/caps.hpp"

namespace {

// Balls with some caps of each, found both ways.
class BothWays {
 public:
  BothWays(hsp::Target target, const std::vector<hsp::exact::LatticeBall> &balls, uint32_t capacity) {
    const uint32_t n = static_cast<uint32_t>(balls.size());
    set_memory_.carve(set_, n);
    set_.n = n;
    for (uint32_t i = 0; i < n; ++i) set_.store(i, balls[i]);
    for (int way = 0; way < 2; ++way) {
      memory_[way].carve(caps_[way], capacity);
      parent_[way].resize(n);
      components_[way] = hsp::DisjointSets({parent_[way].data(), n});
      components_[way].reset();
    }
    caps_[0].lanes = false;
    caps_[1].lanes = true;
    caps_[1].target = target;
  }

  // The caps of all balls, with the balls in two ranges.
  void expect_same(uint32_t first_range_ends) {
    hsp::CubeBlock block;
    block.range[0] = {0, first_range_ends};
    block.range[1] = {first_range_ends, set_.n};
    block.ranges = 2;
    for (uint32_t i = 0; i < set_.n; ++i) {
      for (int way = 0; way < 2; ++way) caps_[way].gather(set_, block, i, &components_[way]);
      const hsp::Caps &a = caps_[0];
      const hsp::Caps &b = caps_[1];
      ASSERT_EQ(a.contained, b.contained) << i;
      contained += a.contained ? 1 : 0;
      if (a.contained) continue;
      ASSERT_EQ(a.met, b.met) << i;
      if (a.overflowed()) {  // the caps are lost, one way or the other
        ++overflowed;
        continue;
      }
      ASSERT_EQ(a.count, b.count) << i;
      ASSERT_EQ(a.first_later, b.first_later) << i;
      caps += a.count;
      ASSERT_EQ(a.length_squared, b.length_squared) << i;
      for (uint32_t k = 0; k < a.count; ++k) {
        ASSERT_EQ(a.ball[k], b.ball[k]) << i;
        ASSERT_TRUE(same(a.ux[k], b.ux[k]) && same(a.uy[k], b.uy[k]) && same(a.uz[k], b.uz[k]) && same(a.b[k], b.b[k]))
            << i << ", cap " << k;
        ASSERT_EQ(a.plane(k).h, b.plane(k).h);
        ASSERT_EQ(a.plane(k).v.x, b.plane(k).v.x);
      }
    }
    for (uint32_t i = 0; i < set_.n; ++i) ASSERT_EQ(components_[0].find(i), components_[1].find(i));
  }

  uint32_t contained = 0, caps = 0, overflowed = 0;

 private:
  static bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b); }

  hsp::BallSet set_;
  CarvedMemory set_memory_;
  hsp::Caps caps_[2];
  hsp::DisjointSets components_[2];
  std::vector<uint32_t> parent_[2];
  CarvedMemory memory_[2];
};

struct Family {
  const char *name;
  uint32_t n;
  int64_t extent, least_radius, largest_radius;
};
constexpr Family families[] = {
    {"sparse", 61, 4000, 100, 400},
    {"dense, more hits than one look takes", 400, 900, 300, 500},
    {"small integers, which touch and contain each other", 150, 12, 0, 4},
    {"radii from 1 to the limit", 60, 1500000000, 1, 1073741823},
    {"far from the origin, as large as can be", 90, 2100000000, 1000000000, 1073741823},
};

std::vector<hsp::exact::LatticeBall> random_balls(const Family &family, uint64_t seed, int64_t shift) {
  oracle::RandomSource random(seed);
  const auto within = [&random](int64_t low, int64_t high) {
    return low + static_cast<int64_t>(random.fraction() * static_cast<double>(high - low + 1));
  };
  std::vector<hsp::exact::LatticeBall> balls;
  for (uint32_t i = 0; i < family.n; ++i) {
    const int64_t e = family.extent;
    balls.push_back({{shift + within(0, e), shift + within(0, e), within(0, e) - shift},
                     within(family.least_radius, family.largest_radius),
                     i});
  }
  return balls;
}

class NearBalls : public testing::TestWithParam<hsp::Target> {};
INSTANTIATE_TEST_SUITE_P(Targets, NearBalls, testing::ValuesIn(runnable_targets()));

TEST_P(NearBalls, SameCapsBothWays) {
  if (!hsp::has_lanes) GTEST_SKIP() << "no such code";
  uint32_t contained = 0, overflowed = 0;
  uint64_t seed = 700;
  for (const Family &family : families) {
    for (const int64_t shift : {INT64_C(0), (INT64_C(1) << 50) - 2200000000}) {
      for (const uint32_t capacity : {family.n, family.n / 8, UINT32_C(1)}) {
        const std::vector<hsp::exact::LatticeBall> balls = random_balls(family, ++seed, shift);
        for (const uint32_t split : {UINT32_C(0), family.n / 3, family.n}) {
          SCOPED_TRACE(family.name);
          BothWays both(GetParam(), balls, capacity);
          both.expect_same(split);
          if (testing::Test::HasFatalFailure()) return;
          EXPECT_GT(both.caps + both.contained + both.overflowed, 0U);
          contained += both.contained;
          overflowed += both.overflowed;
        }
      }
    }
  }
  EXPECT_GT(contained, 50U);
  EXPECT_GT(overflowed, 50U);
}

}  // namespace
