// Which balls may be nearest in the parts of a cube, against distances from many of their points, on all targets.
#include "pores/cube_halves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "runnable_targets.hpp"

namespace {

struct SomeBalls {
  std::vector<double> x, y, z, radius;
  std::vector<uint32_t> ball;

  SomeBalls(std::mt19937_64 &random, uint32_t count) {
    std::uniform_real_distribution<double> place(-4e8, 4e8), size(1e7, 2e8);
    for (uint32_t k = 0; k < count; ++k) {
      for (auto *axis : {&x, &y, &z}) axis->push_back(std::floor(place(random)));
      radius.push_back(std::floor(size(random)));
      if (k % 3 != 1) ball.push_back(k);
    }
  }
  hsp::NearArrays arrays() const {
    return {x.data(), y.data(), z.data(), radius.data(), ball.data(), static_cast<uint32_t>(ball.size())};
  }
  double gap(uint32_t k, double px, double py, double pz) const {
    return std::hypot(x[k] - px, y[k] - py, z[k] - pz) - radius[k];
  }
};

TEST(CubeHalves, KeepWhatIsNearestSomewhere) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  int kept = 0, all = 0;
  for (int turn = 0; turn < 200; ++turn) {
    const SomeBalls balls(random, 3 + static_cast<uint32_t>(turn) % 40);
    const double half = std::ldexp(1.0, 20 + turn % 9);
    hsp::CubeParts parts{};
    for (uint32_t part = 0; part < 8; ++part) {
      parts.x[part] = (part & 1) != 0 ? half : -half;
      parts.y[part] = (part & 2) != 0 ? half : -half;
      parts.z[part] = (part & 4) != 0 ? half : -half;
    }
    parts.edge = half + 2.0;
    std::vector<uint8_t> in(balls.ball.size()), same(balls.ball.size());
    find_nearest(hsp::Target::baseline, balls.arrays(), parts);
    for (uint32_t part = 0; part < 8; ++part) {
      const auto gap = [&](uint32_t k) { return balls.gap(k, parts.x[part], parts.y[part], parts.z[part]); };
      double least = gap(balls.ball[0]);
      for (const uint32_t k : balls.ball) least = std::min(least, gap(k));
      ASSERT_NEAR(gap(parts.nearest[part]), least, 1e-6);
      parts.most_level[part] = least + 1.7321 * (half + 2.0);
    }
    find_near(hsp::Target::baseline, balls.arrays(), parts, in.data());
    for (uint32_t part = 0; part < 8; ++part) {
      for (int point = 0; point < 40; ++point) {
        const auto at = [&](double middle) {
          // Corners, too.
          return middle + half * (point < 20 ? within(random) : within(random) < 0.0 ? -1.0 : 1.0);
        };
        const double px = at(parts.x[part]), py = at(parts.y[part]), pz = at(parts.z[part]);
        size_t nearest = 0;
        for (size_t k = 1; k < balls.ball.size(); ++k) {
          if (balls.gap(balls.ball[k], px, py, pz) < balls.gap(balls.ball[nearest], px, py, pz)) nearest = k;
        }
        ASSERT_NE(in[nearest] >> part & 1, 0);
      }
      for (const uint8_t bits : in) kept += bits >> part & 1;
      all += static_cast<int>(in.size());
    }
    for (const hsp::Target target : runnable_targets()) {
      hsp::CubeParts others = parts;
      find_nearest(target, balls.arrays(), others);
      find_near(target, balls.arrays(), others, same.data());
      ASSERT_EQ(std::memcmp(others.nearest, parts.nearest, sizeof others.nearest), 0);
      ASSERT_EQ(same, in);
    }
  }
  EXPECT_LT(kept, all * 3 / 4);
}

TEST(CubeHalves, FartherBallsAreSoInAllOfACube) {
  std::mt19937_64 random(2);
  int farther = 0;
  for (int turn = 0; turn < 200; ++turn) {
    const SomeBalls balls(random, 3 + static_cast<uint32_t>(turn) % 60);
    const hsp::NearArrays near = balls.arrays();
    const double middle[3] = {1e7, -2e7, 3e7};
    hsp::ViewedBalls seen;
    seen.side = std::ldexp(1.0, 20 + turn % 9);
    see(hsp::Target::baseline, near, middle, seen);
    const uint64_t any = find_farther(hsp::Target::baseline, seen, near.count);
    for (uint32_t m = 0; m < near.count; ++m) {
      if ((any >> m & 1) != 0) continue;
      for (uint32_t k = 0; k < near.count; ++k) {
        if ((seen.farther[m] >> k & 1) == 0) continue;
        ASSERT_EQ(any >> k & 1, 1);
        ++farther;
        for (int corner = 0; corner < 8; ++corner) {
          const auto at = [&](int axis) { return middle[axis] + ((corner >> axis & 1) != 0 ? seen.side : -seen.side); };
          ASSERT_GT(balls.gap(near.ball[k], at(0), at(1), at(2)), balls.gap(near.ball[m], at(0), at(1), at(2)));
        }
      }
    }
    for (const hsp::Target target : runnable_targets()) {
      hsp::ViewedBalls same;
      same.side = seen.side;
      see(target, near, middle, same);
      ASSERT_EQ(find_farther(target, same, near.count), any);
      for (uint32_t m = 0; m < near.count; ++m) {
        ASSERT_TRUE((any >> m & 1) != 0 || same.farther[m] == seen.farther[m]);
      }
    }
  }
  EXPECT_GT(farther, 1000);
}

}  // namespace
