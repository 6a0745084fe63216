#include "poses/sphere_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "random_poses.hpp"

namespace {

using hsp::SphereTree;
using hsp::TreeNode;

// First children follow their parents: the leaf that is the second child of second children is the last node.
uint32_t node_count(const SphereTree &tree) {
  if (tree.empty()) return 0;
  uint32_t last = 0;
  while (!tree.node(last).is_leaf()) last = tree.node(last).second;
  return last + 1;
}

// Empty, or how the spheres of a level are not around the balls below them. Numbers are floats.
std::string complaint_about_levels(const SphereTree &tree) {
  const hsp::SphereLevels &levels = tree.levels();
  const TreeNode &root = tree.node(0);
  const double error = 0x1p-22 * root.radius;
  uint64_t size = 1;
  for (uint32_t level = 0; level <= levels.top; ++level, size *= 8) {
    if (level == levels.top && size < tree.ball_count()) return "top";
    const auto count = static_cast<uint32_t>((tree.ball_count() + size - 1) / size);
    const uint32_t blocks = (count + 7) / 8;
    if (level < levels.top && levels.first[level + 1] != levels.first[level] + blocks) return "blocks of a level";
    for (uint32_t k = 0; k < 8 * blocks; ++k) {
      const hsp::SphereBlock &block = levels.blocks[levels.first[level] + k / 8];
      const double x = block.x[k % 8], y = block.y[k % 8], z = block.z[k % 8], r = block.r[k % 8];
      if (k >= count) {
        if (r != 0 || std::hypot(x, y, z) < 0x1p59) return "a sphere of nothing";
        continue;
      }
      if (r > 2 * root.radius) return "too large";
      for (uint64_t i = k * size; i < (k + 1) * size && i < tree.ball_count(); ++i) {
        const auto ball = static_cast<uint32_t>(i);
        const hsp::Vec3 v = tree.centre(ball) - root.centre;
        if (std::hypot(v.x - x, v.y - y, v.z - z) + tree.radius(ball) > r + error)
          return "a ball sticks out of a level";
      }
    }
  }
  return "";
}

// Empty, or how the nodes are no tree of spheres around all balls.
std::string complaint(const oracle::Balls &balls) {
  const BuiltTree built(balls);
  const SphereTree &tree = built.tree();
  if (built.status() != hsp::Status::ok || tree.ball_count() != balls.size()) return "not built";
  std::vector<uint32_t> callers;
  for (uint32_t i = 0; i < tree.ball_count(); ++i) {
    const uint32_t caller = tree.caller(i);
    callers.push_back(caller);
    const oracle::LatticeBall ball{static_cast<int64_t>(tree.centre(i).x), static_cast<int64_t>(tree.centre(i).y),
                                   static_cast<int64_t>(tree.centre(i).z), static_cast<int64_t>(tree.radius(i))};
    if (caller >= balls.size() || ball != balls[caller]) return "another ball";
    if (std::hypot(tree.centre(i).x, tree.centre(i).y, tree.centre(i).z) > tree.reach()) return "reach";
  }
  std::sort(callers.begin(), callers.end());
  for (uint32_t i = 0; i < callers.size(); ++i)
    if (callers[i] != i) return "a ball twice";
  for (uint32_t k = 0; k < node_count(tree); ++k) {
    const TreeNode &node = tree.node(k);
    for (uint32_t i = node.first; i < node.last; ++i) {
      const hsp::Vec3 v = tree.centre(i) - node.centre;
      if (std::hypot(v.x, v.y, v.z) + tree.radius(i) > node.radius) return "a ball sticks out";
    }
    if (std::hypot(node.centre.x, node.centre.y, node.centre.z) > tree.reach()) return "reach of a node";
    const uint32_t size = node.last - node.first;
    if (node.is_leaf() != (size <= SphereTree::leaf_size)) return "size of a leaf";
    if (node.is_leaf()) continue;
    const TreeNode &one = tree.node(k + 1), &two = tree.node(node.second);
    if (one.first != node.first || one.last != two.first || two.last != node.last) return "not a division";
    // Groups of four, eight, 64, .. balls, of which the first child has as many as the second or one more.
    uint32_t group = 4;
    while (group * (group == 4 ? 2 : 8) < size) group *= group == 4 ? 2 : 8;
    const uint32_t in_one = one.last - one.first, in_two = two.last - two.first;
    if (in_one % group != 0 || in_one < in_two || in_one > in_two + 2 * group - 1) return "uneven";
  }
  return balls.empty() ? "" : complaint_about_levels(tree);
}

TEST(SphereTree, HoldsAllBalls) {
  oracle::RandomSource random(2);
  for (size_t n = 0; n <= 40; ++n) EXPECT_EQ(complaint(oracle::loose_balls(random, n)), "") << n;
  for (int k = 0; k < 200; ++k) {
    const oracle::Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(1, 90)));
    ASSERT_EQ(complaint(balls), "") << oracle::to_text(balls);
  }
  EXPECT_EQ(complaint(oracle::loose_balls(random, 3000)), "");
  for (const size_t n : std::vector<size_t>{63, 64, 65, 511, 512, 513, 4105})
    EXPECT_EQ(complaint(oracle::loose_balls(random, n)), "") << n;
  EXPECT_EQ(complaint(oracle::Balls(500, {7, 8, 9, 10})), "");
}

// Its spheres are small: what it is for.
TEST(SphereTree, HasSmallSpheres) {
  const BuiltTree pair({{-5, 0, 0, 2}, {5, 0, 0, 2}});
  EXPECT_LT(pair.tree().node(0).radius, 8.5);
  const BuiltTree single({{3, 4, 5, 6}});
  EXPECT_LT(single.tree().node(0).radius, 7.001);
  oracle::RandomSource random(3);
  const BuiltTree many(oracle::balls_in_box(random, 4096, 100000, 1, 1));
  double sum = 0;
  uint32_t leaves = 0;
  for (uint32_t k = 0; k < node_count(many.tree()); ++k) {
    if (!many.tree().node(k).is_leaf()) continue;
    sum += many.tree().node(k).radius;
    ++leaves;
  }
  // Four of 4096 points of a cube of side 200000 fill one of side 20000.
  EXPECT_LT(sum / leaves, 12000);
}

TEST(SphereTree, DoesNotDependOnTheOrderOfTheBalls) {
  oracle::RandomSource random(4);
  for (int time = 0; time < 20; ++time) {
    const oracle::Balls balls = oracle::any_balls(random, 60);
    const BuiltTree one(balls), two(oracle::permuted(balls, random.permutation(balls.size())));
    ASSERT_EQ(node_count(one.tree()), node_count(two.tree()));
    for (uint32_t k = 0; k < node_count(one.tree()); ++k) {
      EXPECT_EQ(one.tree().node(k).centre.x, two.tree().node(k).centre.x);
      EXPECT_EQ(one.tree().node(k).radius, two.tree().node(k).radius);
    }
    for (uint32_t i = 0; i < 60; ++i) EXPECT_EQ(one.tree().radius(i), two.tree().radius(i));
  }
}

TEST(SphereTree, RefusesMoreBallsThanItHasRoomFor) {
  oracle::RandomSource random(5);
  const BuiltGrid grid(oracle::in_lengths(oracle::loose_balls(random, 10), 1.0));
  CarvedMemory memory;
  SphereTree tree;
  memory.carve(tree, 9U);
  EXPECT_EQ(tree.build(grid.grid().balls()), hsp::Status::capacity);
  EXPECT_TRUE(tree.empty());
  EXPECT_EQ(tree.ball_count(), 0U);
}

}  // namespace
