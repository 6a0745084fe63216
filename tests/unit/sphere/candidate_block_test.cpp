// The candidates near one ball, against the exact relation of all pairs: none that meets it is missing, few others are
// there. Balls that touch each other, cubes as large and as far away as there may be.
#include "sphere/candidate_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "exact/lattice_ball.hpp"
#include "model/ball_set.hpp"
#include "model/meeting.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

#if HSP_LANES
namespace {

using hsp::exact::LatticeBall;

struct Candidates {
  std::vector<double> x, y, z, r;
  std::vector<float> fx, fy, fz, fr;
  std::vector<uint32_t> id;
  hsp::CandidateBlock block;

  Candidates(hsp::Target target, const std::vector<LatticeBall> &balls, const hsp::exact::Vector &centre,
             int64_t side) {
    for (const LatticeBall &ball : balls) {
      x.push_back(static_cast<double>(ball.centre.x));
      y.push_back(static_cast<double>(ball.centre.y));
      z.push_back(static_cast<double>(ball.centre.z));
      r.push_back(static_cast<double>(ball.radius));
    }
    const uint32_t n = static_cast<uint32_t>(balls.size());
    for (std::vector<double> *numbers : {&x, &y, &z, &r}) numbers->resize(n + hsp::BallSet::read_behind);
    for (std::vector<float> *floats : {&fx, &fy, &fz, &fr}) floats->resize(n + hsp::CandidateBlock::spare);
    id.resize(n + hsp::CandidateBlock::spare);
    block.x = fx.data();
    block.y = fy.data();
    block.z = fz.data();
    block.r = fr.data();
    block.ball = id.data();
    block.room = n;
    block.doubt = static_cast<float>(hsp::doubt_nearby(static_cast<double>(side)));
    const double middle[3] = {static_cast<double>(centre.x), static_cast<double>(centre.y),
                              static_cast<double>(centre.z)};
    // In two parts that end where no vector does.
    const hsp::BallArrays arrays{x.data(), y.data(), z.data(), r.data()};
    const hsp::BallRange parts[2] = {{0, n / 3}, {n / 3, n}};
    hsp::set_candidates(target, block, arrays, parts, 2, middle);
  }
};

double square(int64_t x) {
  return static_cast<double>(x) * static_cast<double>(x);
}
// d^2 - t^2 for their distance d and the sum t of their radii, about.
double excess(const LatticeBall &a, const LatticeBall &b) {
  return square(a.centre.x - b.centre.x) + square(a.centre.y - b.centre.y) + square(a.centre.z - b.centre.z) -
         square(a.radius + b.radius);
}

// Balls of the cube around `centre` and of its neighbours; many of them touch the first one.
std::vector<LatticeBall> balls_around(oracle::RandomSource &random, const hsp::exact::Vector &centre, int64_t side) {
  const auto within = [&random](int64_t low, int64_t high) {
    return std::min(high, low + static_cast<int64_t>(random.fraction() * static_cast<double>(high - low + 1)));
  };
  const auto ball = [&](int64_t reach, uint32_t index) {
    return LatticeBall{{centre.x + within(-reach, reach - 1), centre.y + within(-reach, reach - 1),
                        centre.z + within(-reach, reach - 1)},
                       within(0, side / 2),
                       index};
  };
  std::vector<LatticeBall> balls = {ball(side / 2, 0)};
  const LatticeBall first = balls.front();
  while (balls.size() < 40 + balls.front().index % 7) {
    LatticeBall next = ball(side + side / 2, static_cast<uint32_t>(balls.size()));
    if (balls.size() % 2 == 0) {
      // The radius with which it just meets the first one, or just does not.
      next.radius = -first.radius;
      const int64_t distance = static_cast<int64_t>(std::sqrt(excess(first, next)));
      next.radius = distance - first.radius + within(-1, 1);
      if (next.radius < 0 || next.radius > side / 2) continue;
    }
    balls.push_back(next);
  }
  return balls;
}

class CandidateBlock : public testing::TestWithParam<hsp::Target> {};
INSTANTIATE_TEST_SUITE_P(Targets, CandidateBlock, testing::ValuesIn(runnable_targets()));

TEST_P(CandidateBlock, NoneThatMeetsIsLeftOut) {
  const hsp::Target target = GetParam();
  oracle::RandomSource random(901);
  uint32_t meeting = 0, near_misses = 0;
  for (int k = 0; k < 4000; ++k) {
    constexpr int64_t sides[] = {2, 8, 3000, 4194304, 2147483646, 2147483646};
    const int64_t side = sides[k % 6];
    const int64_t far = (INT64_C(1) << 50) / side * side - 2 * side;
    const hsp::exact::Vector centre = k % 4 == 0 ? hsp::exact::Vector{far + side / 2, -far + side / 2, side / 2}
                                                 : hsp::exact::Vector{side / 2, -side / 2, 5 * side + side / 2};
    std::vector<LatticeBall> balls = balls_around(random, centre, side);
    const uint32_t own = static_cast<uint32_t>(k) % 40;
    std::swap(balls[0], balls[own]);
    const Candidates candidates(target, balls, centre, side);
    const uint32_t n = static_cast<uint32_t>(balls.size());
    std::vector<uint32_t> near(n + hsp::spare_ids);
    uint32_t earlier = 0;
    const uint32_t found = hsp::near_candidates(target, candidates.block, own, near.data(), n, earlier);
    ASSERT_LT(found, n);
    ASSERT_EQ(hsp::count_candidates(target, candidates.block, own), found + 1);
    ASSERT_TRUE(std::is_sorted(near.begin(), near.begin() + found));
    ASSERT_EQ(earlier, std::lower_bound(near.begin(), near.begin() + found, own) - near.begin());
    ASSERT_FALSE(std::binary_search(near.begin(), near.begin() + found, own));
    for (uint32_t j = 0; j < n; ++j) {
      if (j == own) continue;
      const bool meets = hsp::exact::pair_relation(balls[own], balls[j]) != hsp::exact::PairRelation::disjoint;
      const bool is_listed = std::binary_search(near.begin(), near.begin() + found, j);
      ASSERT_TRUE(is_listed || !meets) << "side " << side << ", set " << k;
      meeting += meets ? 1U : 0U;
      near_misses += is_listed && !meets ? 1U : 0U;
      if (is_listed) {
        ASSERT_LE(excess(balls[own], balls[j]),
                  2.0 * static_cast<double>(candidates.block.doubt) + 1e-9 * square(side));
      }
    }
    std::vector<uint32_t> later(n + hsp::spare_ids);
    ASSERT_EQ(hsp::later_candidates(target, candidates.block, own, later.data(), n), found - earlier);
    ASSERT_TRUE(std::equal(near.begin() + earlier, near.begin() + found, later.begin()));
    // More than asked for.
    if (found > 9) {
      ASSERT_GT(hsp::near_candidates(target, candidates.block, own, near.data(), found - 1, earlier), found - 1);
      ASSERT_EQ(hsp::near_candidates(target, candidates.block, own, near.data(), found, earlier), found);
    }
  }
  EXPECT_GT(meeting, 20000U);
  EXPECT_GT(near_misses, 100U);
}

}  // namespace
#endif
