// sqrt(D) of vertices in lanes against exact::discriminant(): balls of every size down to single steps, the largest
// there may be, and circles that touch or nearly do, where D is 0 or far below W n.n and doubles must not be certain.
#include "sphere/root_discriminants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "exact/discriminant.hpp"
#include "exact/lattice_ball.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

#if HSP_LANES
namespace {

using hsp::exact::LatticeBall;

// Vertices of three balls each.
class Vertices {
 public:
  // If both balls meet the first one in circles.
  void add(const LatticeBall (&ball)[3]) {
    for (uint32_t k = 1; k < 3; ++k) {
      if (hsp::exact::pair_relation(ball[0], ball[k]) != hsp::exact::PairRelation::circle) return;
    }
    // The balls are not in the order of the vertex.
    constexpr uint32_t place[3] = {2, 0, 1};
    const uint32_t first = static_cast<uint32_t>(x_.size());
    for (const uint32_t p : {1U, 2U, 0U}) {
      x_.push_back(static_cast<double>(ball[p].centre.x));
      y_.push_back(static_cast<double>(ball[p].centre.y));
      z_.push_back(static_cast<double>(ball[p].centre.z));
      r_.push_back(static_cast<double>(ball[p].radius));
    }
    for (const uint32_t p : place) words_.push_back(first + p);
    words_.push_back(UINT32_MAX);
    expected_.push_back(std::sqrt(hsp::exact::discriminant(sphere_of(ball[0]), hsp::exact::plane_of(ball[0], ball[1]),
                                                           hsp::exact::plane_of(ball[0], ball[2]))));
  }

  // The number of vertices for which lanes are certain.
  uint32_t expect_the_same(hsp::Target target) const {
    const uint32_t count = static_cast<uint32_t>(expected_.size());
    std::vector<double> roots(count + 1, -2.0);
    uint32_t done = count;
    const bool all = hsp::find_roots_in_lanes(target, {x_.data(), y_.data(), z_.data(), r_.data()}, words_.data(),
                                              count, roots.data(), done);
    EXPECT_TRUE(done == count / 4 * 4 || (done == 0 && target == hsp::Target::baseline));
    uint32_t certain = 0;
    for (uint32_t v = 0; v < done; ++v) {
      if (roots[v] == hsp::doubtful_root) continue;
      ++certain;
      EXPECT_EQ(roots[v], expected_[v]) << v;
      EXPECT_GT(expected_[v], 0.0) << v;
    }
    for (uint32_t v = done; v < count + 1; ++v) EXPECT_EQ(roots[v], -2.0) << v;
    EXPECT_EQ(all, certain == done);
    return certain;
  }
  uint32_t size() const { return static_cast<uint32_t>(expected_.size()); }

 private:
  std::vector<double> x_, y_, z_, r_, expected_;
  std::vector<uint32_t> words_;
};

class RootDiscriminants : public testing::TestWithParam<hsp::Target> {
 protected:
  // No lane is certain where this is left to integers.
  static bool by_integers() { return GetParam() == hsp::Target::baseline; }
};
INSTANTIATE_TEST_SUITE_P(Targets, RootDiscriminants, testing::ValuesIn(runnable_targets()));

TEST_P(RootDiscriminants, OfBallsOfEverySize) {
  oracle::RandomSource random(43);
  Vertices vertices;
  for (int k = 0; k < 300000; ++k) {
    const int64_t size = int64_t{1} << random.in(0, 30);
    LatticeBall ball[3];
    for (LatticeBall &b : ball) {
      const int64_t width = random.in(0, size - 1);
      const int64_t x = random.in(-width, width), y = random.in(-width, width), z = random.in(-width, width);
      b = {{x, y, z}, random.in(0, size - 1), 0};
    }
    vertices.add(ball);
  }
  // Many have circles that do not cross: D is negative.
  EXPECT_GT(vertices.size(), 20000U);
  const uint32_t certain = vertices.expect_the_same(GetParam());
  EXPECT_TRUE(by_integers() || certain > vertices.size() / 3);
  EXPECT_LT(certain, vertices.size());
}

// Around the centre of the sphere, where D is largest, and where q.q nearly takes away all of W n.n.
TEST_P(RootDiscriminants, OfTheLargestBalls) {
  oracle::RandomSource random(44);
  constexpr int64_t most = (int64_t{1} << 30) - 1;
  Vertices vertices;
  for (int k = 0; k < 200000; ++k) {
    const int64_t spread = int64_t{1} << random.in(0, 30);
    const auto near = [&](int64_t value) { return value - random.in(0, spread - 1); };
    LatticeBall ball[3] = {{{0, 0, 0}, most, 0}, {{}, 0, 1}, {{}, 0, 2}};
    ball[1].centre.x = near(most);
    ball[1].centre.z = random.in(0, 1);
    ball[1].radius = near(most);
    ball[2].centre.x = random.in(0, 1);
    ball[2].centre.y = near(most);
    ball[2].centre.z = near(most);
    ball[2].radius = near(most);
    vertices.add(ball);
  }
  EXPECT_GT(vertices.size(), 10000U);
  const uint32_t certain = vertices.expect_the_same(GetParam());
  EXPECT_TRUE(by_integers() || certain > 10000U);
}

// Three spheres through a point in the plane of their centres, where D is 0, with one of them off that plane by so
// little that D is small against W n.n: bits are lost.
TEST_P(RootDiscriminants, OfCirclesThatNearlyTouch) {
  oracle::RandomSource random(45);
  Vertices vertices;
  for (int k = 0; k < 200000; ++k) {
    const int64_t size = (int64_t{1} << 29) - random.in(0, int64_t{1} << 28);
    const int64_t m = random.in(1 << 20, 1 << 26), n = random.in(1 << 20, 1 << 26);
    const int64_t off = random.in(0, int64_t{1} << random.in(0, 20));
    LatticeBall ball[3] = {{{0, 0, 0}, size, 0}, {{}, 5 * m, 1}, {{}, 5 * n, 2}};
    ball[1].centre.x = size + 3 * (k % 2 == 0 ? m : -m);
    ball[1].centre.y = 4 * m;
    ball[2].centre.x = size + 4 * (k % 4 < 2 ? n : -n);
    ball[2].centre.y = 3 * (k % 8 < 4 ? n : -n);
    ball[2].centre.z = off;
    vertices.add(ball);
  }
  EXPECT_GT(vertices.size(), 100000U);
  const uint32_t certain = vertices.expect_the_same(GetParam());
  EXPECT_TRUE(by_integers() || certain > vertices.size() / 10);
  EXPECT_LT(certain, vertices.size());
}

}  // namespace
#endif
