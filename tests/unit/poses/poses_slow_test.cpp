// Two hundred thousand poses against brute force in integers, in the long form a million: free, touching, overlapping
// and far, of sets of any kind, of lattices against lattices and of sets against themselves, each with the witness and
// the gap of poses before. The code for wide registers and that for every processor take turns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "point_lattices.hpp"
#include "poses/pose_queries.hpp"
#include "random_poses.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::Int128;
using oracle::LatticeBall;
using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

hsp::Vec3 in_doubles(const LatticeBall &ball) {
  return {static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)};
}

struct Meeting {
  Meeting(const Balls &rest, const Balls &other) : fixed(rest), moving(other), fixed_tree(rest), moving_tree(other) {}

  // Empty, or what the trees say otherwise than brute force.
  std::string complaint(const PoseNumbers &numbers) {
    const hsp::Pose pose = pose_of(numbers);
    Pairs expected;
    for (uint32_t j = 0; j < moving.size(); ++j) {
      const hsp::Vec3 p = pose.snapped(in_doubles(moving[j]));
      const LatticeBall image{static_cast<int64_t>(p.x), static_cast<int64_t>(p.y), static_cast<int64_t>(p.z),
                              moving[j].radius};
      for (uint32_t i = 0; i < fixed.size(); ++i) {
        const oracle::Vector v = oracle::centre_difference(fixed[i], image);
        const Int128 sum = Int128{fixed[i].radius} + image.radius;
        const Int128 excess = oracle::dot(v, v) - sum * sum;
        touching += excess == 0 ? 1 : 0;
        if (excess <= 0) expected.emplace_back(i, j);
      }
    }
    std::sort(expected.begin(), expected.end());
    hits += expected.empty() ? 0 : 1;
    if (hsp::any_balls_meet(fixed_tree.tree(), moving_tree.tree(), pose, witness) == expected.empty()) return "hit";
    if (hsp::any_balls_meet(fixed_tree.tree(), moving_tree.tree(), pose, known) == expected.empty())
      return "hit by what is known";
    std::vector<hsp::MeetingPair> room(expected.size() + 1);
    const uint64_t count = hsp::list_meeting_pairs(fixed_tree.tree(), moving_tree.tree(), pose,
                                                   {room.data(), static_cast<uint32_t>(room.size())});
    Pairs pairs;
    for (uint64_t k = 0; k < count && k < room.size(); ++k) pairs.emplace_back(room[k].fixed, room[k].moving);
    if (pairs != expected) return "pairs";
    const hsp::PairGap gap = hsp::least_gap(fixed_tree.tree(), moving_tree.tree(), pose, nearest);
    const hsp::PairGap alone = hsp::least_gap(fixed_tree.tree(), moving_tree.tree(), pose);
    if (gap.gap != alone.gap || gap.fixed != alone.fixed || gap.moving != alone.moving) return "gap by the witness";
    return (gap.gap < 0 && expected.empty()) || (gap.gap > 0 && !expected.empty()) ? "sign of the gap" : "";
  }

  Balls fixed, moving;
  BuiltTree fixed_tree, moving_tree;
  hsp::PairRanks witness, nearest;
  hsp::GapBudget known{300};
  int hits = 0, touching = 0;
};

TEST(PosesSlow, AgreeWithBruteForceOfSetsOfAnyKind) {
  oracle::RandomSource random(21);
  int hits = 0;
  const int sets = oracle::rounds(300, 5000);
  for (int k = 0; k < sets; ++k) {
    const Balls fixed = oracle::any_balls(random, static_cast<size_t>(random.in(1, 40)));
    const Balls other = oracle::any_balls(random, static_cast<size_t>(random.in(1, 40)));
    Meeting meeting(fixed, k % 5 == 0 ? fixed : other);
    if (k % 2 == 1) meeting.fixed_tree.use(hsp::Target::baseline);
    int64_t size = 1;
    for (const LatticeBall &ball : fixed) size = std::max({size, std::abs(ball.x), std::abs(ball.y), std::abs(ball.z)});
    for (int time = 0; time < 200; ++time) {
      const int64_t shift = time % 4 == 0 ? 0 : time % 4 == 1 ? size / 4 + 1 : time % 4 == 2 ? 2 * size : 20 * size;
      ASSERT_EQ(meeting.complaint(random_pose(random, shift)), "") << oracle::to_text(fixed) << "\n"
                                                                   << oracle::to_text(meeting.moving);
    }
    hits += meeting.hits;
  }
  EXPECT_GT(hits, 12 * sets);
  EXPECT_LT(hits, 188 * sets);
}

TEST(PosesSlow, AgreeOfLatticesAgainstLattices) {
  oracle::RandomSource random(22);
  int touching = 0;
  for (int k = 0; k < 40; ++k) {
    const int64_t spacing = random.in(2, 6), radius = random.in(1, 4), other_radius = random.in(1, 4);
    const Balls fixed = oracle::box_lattice({4, 3, 3}, {spacing, spacing, spacing}, radius);
    Meeting meeting(fixed, oracle::box_lattice({3, 3, 4}, {spacing, spacing, spacing}, other_radius));
    if (k % 2 == 1) meeting.fixed_tree.use(hsp::Target::baseline);
    for (int time = 0; time < 1000; ++time)
      ASSERT_EQ(meeting.complaint(random_pose(random, 4 * spacing)), "") << spacing << ' ' << radius;
    touching += meeting.touching;
  }
  EXPECT_GT(touching, 10000);
}

// Frames of a slow motion, one molecule through another: what witnesses are for.
TEST(PosesSlow, AgreeAlongPaths) {
  oracle::RandomSource random(23);
  const Balls fixed = oracle::balls_in_box(random, 60, 4000, 300, 700);
  const Balls moving = oracle::balls_in_box(random, 30, 2500, 300, 700);
  Meeting meeting(fixed, moving);
  for (int k = 0; k < 5000; ++k) {
    const double angle = 1e-3 * k;
    const PoseNumbers numbers{{std::cos(angle), 0.3 * std::sin(angle), 0.1, std::sin(angle)}, {4.0 * k - 10000, 10, 0}};
    ASSERT_EQ(meeting.complaint(numbers), "") << k;
  }
  EXPECT_GT(meeting.hits, 500);
  EXPECT_LT(meeting.hits, 4500);
}

}  // namespace
