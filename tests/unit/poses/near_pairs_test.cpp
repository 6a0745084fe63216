#include "poses/near_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "random_poses.hpp"
#include "runnable_targets.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

hsp::FloatPose floats_of(const hsp::SphereTree &fixed, const hsp::SphereTree &moving, const hsp::Pose &pose,
                         double slack) {
  hsp::FloatPose floats{};
  const hsp::Vec3 shift = pose.image(moving.node(0).centre) - fixed.node(0).centre;
  const auto store = [](const hsp::Vec3 &v, float *to) {
    to[0] = static_cast<float>(v.x);
    to[1] = static_cast<float>(v.y);
    to[2] = static_cast<float>(v.z);
  };
  for (uint32_t k = 0; k < 3; ++k) store(pose.row(k), floats.row[k]);
  store(shift, floats.shift);
  floats.slack = static_cast<float>(slack);
  return floats;
}

// All pairs that are found, in their order.
Pairs found_by(hsp::Target target, const hsp::SphereTree &fixed, const hsp::SphereTree &moving,
               const hsp::FloatPose &pose) {
  const auto walk = std::make_unique<hsp::PairWalk>();
  walk->waiting = 1;
  walk->pair[0] = {
      {pose.shift[0], pose.shift[1], pose.shift[2], static_cast<float>(moving.node(0).radius) + pose.slack},
      0,
      0,
      fixed.levels().top,
      moving.levels().top};
  Pairs pairs;
  while (const uint32_t count = hsp::find_near_pairs(target, fixed.levels(), moving.levels(), pose, *walk)) {
    EXPECT_LE(count, std::size(walk->found));
    EXPECT_LE(walk->waiting, std::size(walk->pair));
    for (uint32_t k = 0; k < count; ++k) pairs.emplace_back(walk->found[k].fixed, walk->found[k].moving);
  }
  EXPECT_EQ(hsp::find_near_pairs(target, fixed.levels(), moving.levels(), pose, *walk), 0U);
  return pairs;
}

double gap_of(const hsp::SphereTree &fixed, const hsp::SphereTree &moving, const hsp::Pose &pose, uint32_t i,
              uint32_t j) {
  const hsp::Vec3 v = pose.image(moving.centre(j)) - fixed.centre(i);
  return std::hypot(v.x, v.y, v.z) - (fixed.radius(i) + moving.radius(j));
}

// Empty, or which pair is left out, or found twice or although it is far apart.
std::string complaint(hsp::Target target, const BuiltTree &fixed, const BuiltTree &moving, const hsp::Pose &pose) {
  const hsp::SphereTree &rest = fixed.tree(), &other = moving.tree();
  const double sum = rest.node(0).radius + other.node(0).radius;
  const double slack = 1 + 0x1p-19 * sum;
  Pairs found = found_by(target, rest, other, floats_of(rest, other, pose, slack));
  std::sort(found.begin(), found.end());
  if (std::adjacent_find(found.begin(), found.end()) != found.end()) return "a pair twice";
  for (uint32_t i = 0; i < rest.ball_count(); ++i)
    for (uint32_t j = 0; j < other.ball_count(); ++j) {
      const double gap = gap_of(rest, other, pose, i, j);
      const bool is_found = std::binary_search(found.begin(), found.end(), std::pair{i, j});
      if (gap <= 0 && !is_found) return "a pair is left out";
      if (gap > 2 * slack && is_found) return "a pair that is apart";
    }
  return found.empty() || found.back().first < rest.ball_count() ? "" : "no ball";
}

class NearPairs : public testing::TestWithParam<hsp::Target> {};

TEST_P(NearPairs, AreAllThatAreNotCertainlyApart) {
  oracle::RandomSource random(31);
  size_t near = 0;
  for (const size_t n : std::vector<size_t>{1, 5, 8, 9, 64, 65, 130, 600}) {
    for (const size_t m : std::vector<size_t>{1, 4, 8, 17, 64, 100}) {
      const BuiltTree fixed(oracle::loose_balls(random, n)), moving(oracle::loose_balls(random, m));
      const double reach = fixed.tree().reach() + 100;
      for (int k = 0; k < 6; ++k) {
        const hsp::Pose pose = pose_of(random_pose(random, static_cast<int64_t>(k * reach / 4)));
        ASSERT_EQ(complaint(GetParam(), fixed, moving, pose), "") << n << ' ' << m;
        near +=
            found_by(GetParam(), fixed.tree(), moving.tree(), floats_of(fixed.tree(), moving.tree(), pose, 1)).size();
      }
    }
  }
  EXPECT_GT(near, 10000U);
}

// Where floats keep a part of the coordinates only. Half of the pairs touch.
TEST_P(NearPairs, AreFoundUpToTheErrorOfFloats) {
  oracle::RandomSource random(32);
  for (int time = 0; time < 40; ++time) {
    const int64_t size = int64_t{1} << random.in(10, 46), largest = std::min<int64_t>(size / 8, 1 << 29);
    const Balls moving = oracle::balls_in_box(random, 80, size, 1, largest);
    const hsp::Pose pose = pose_of(random_pose(random, size));
    Balls fixed;
    for (const LatticeBall &ball : moving) {
      const hsp::Vec3 p =
          pose.snapped({static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)});
      const int64_t radius = random.in(1, largest);
      fixed.push_back({static_cast<int64_t>(p.x), static_cast<int64_t>(p.y),
                       static_cast<int64_t>(p.z) + ball.radius + radius - 2, radius});
    }
    ASSERT_EQ(complaint(GetParam(), BuiltTree(fixed), BuiltTree(moving), pose), "") << size;
  }
}

// Those that meet; of others one kind of floats finds some that the other one does not.
TEST_P(NearPairs, ComeInOneOrder) {
  oracle::RandomSource random(33);
  for (int time = 0; time < 20; ++time) {
    const BuiltTree fixed(oracle::loose_balls(random, 300)), moving(oracle::loose_balls(random, 90));
    const hsp::Pose pose = pose_of(random_pose(random, 300));
    const auto meeting_by = [&](hsp::Target target) {
      Pairs pairs = found_by(target, fixed.tree(), moving.tree(), floats_of(fixed.tree(), moving.tree(), pose, 2));
      std::erase_if(pairs, [&](const auto &pair) {
        return gap_of(fixed.tree(), moving.tree(), pose, pair.first, pair.second) > 0;
      });
      return pairs;
    };
    EXPECT_EQ(meeting_by(GetParam()), meeting_by(hsp::Target::baseline));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, NearPairs, testing::ValuesIn(runnable_targets()));

}  // namespace
