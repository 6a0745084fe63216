// The planes of blocks are those of all members, and no plane is nearer than is said before it is known.
#include "cells/member_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "carved_memory.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

namespace {

using hsp::MemberArrays;
using hsp::MemberBall;
using hsp::MemberBlocks;
using hsp::PlaneArrays;
using hsp::PlaneOrder;

// Arrays for the planes of so many balls.
class Planes {
 public:
  explicit Planes(uint32_t count) : numbers_(5, std::vector<double>(count + 64, hsp::done_with)), nearest_(count) {}
  PlaneArrays get() {
    return {numbers_[0].data(),
            numbers_[1].data(),
            numbers_[2].data(),
            numbers_[3].data(),
            numbers_[4].data(),
            nearest_.data(),
            &order_};
  }

 private:
  std::vector<std::vector<double>> numbers_;
  std::vector<uint32_t> nearest_;
  PlaneOrder order_{};
};

// Balls with centres up to a side from the middle of a cube, most of them small.
class Members {
 public:
  Members(oracle::RandomSource &random, uint32_t count, double side, double largest) : count_(count) {
    for (auto *numbers : {&x_, &y_, &z_, &radius_, &power_, &not_discarded_}) numbers->assign(count + 7, 0.0);
    const auto place = [&] { return side * (2 * random.fraction() - 1); };
    for (uint32_t k = 0; k < count; ++k) {
      x_[k] = place();
      y_[k] = place();
      z_[k] = place();
      radius_[k] = random.one_in(500) ? largest : 0.02 * largest * random.fraction();
      power_[k] = x_[k] * x_[k] + y_[k] * y_[k] + z_[k] * z_[k] - radius_[k] * radius_[k];
      not_discarded_[k] = 1.0;
    }
  }
  MemberArrays get() const {
    return {x_.data(), y_.data(), z_.data(), radius_.data(), power_.data(), not_discarded_.data(), count_};
  }
  MemberBall ball(uint32_t k) const { return {x_[k], y_[k], z_[k], radius_[k], power_[k]}; }
  void discard(uint32_t k) { not_discarded_[k] = 0.0; }

 private:
  uint32_t count_;
  std::vector<double> x_, y_, z_, radius_, power_, not_discarded_;
};

TEST(MemberBlocks, FewAreNotInBlocks) {
  oracle::RandomSource random(1);
  MemberBlocks blocks;
  CarvedMemory memory;
  memory.carve(blocks, MemberBlocks::fewest);
  const Members few(random, MemberBlocks::fewest - 1, 10, 1), many(random, MemberBlocks::fewest, 10, 1);
  blocks.enter(many.get(), 10);
  EXPECT_TRUE(blocks.is_there());
  blocks.enter(few.get(), 10);
  EXPECT_FALSE(blocks.is_there());
}

TEST(MemberBlocks, KnowAllPlanesThatAreNearer) {
  constexpr uint32_t count = 3001;
  oracle::RandomSource random(2);
  MemberBlocks blocks;
  CarvedMemory memory;
  memory.carve(blocks, count);
  uint32_t calls = 0, unknown = 0, before = 0, not_before = 0;
  for (const double largest : {0.0, 8.0, 200.0}) {
    Members members(random, count, 100, largest);
    blocks.enter(members.get(), 100);
    Planes all(count), known(count);
    for (int round = 0; round < 40; ++round) {
      const uint32_t own = random.below(count), gone = random.below(count);
      members.discard(gone);
      blocks.discard(gone);
      const MemberBall ball = members.ball(own);
      const double limit = random.one_in(2) ? 90000.0 : 400.0;
      const PlaneArrays expected = all.get(), planes = known.get();
      for (const hsp::Target target : runnable_targets()) {
        find_planes(target, members.get(), ball, limit, expected);
        blocks.begin(ball, limit);
        do {
          std::map<uint32_t, uint32_t> place_of;
          for (uint32_t place = 0; place < blocks.known(); ++place) {
            if (planes.distance[place] == hsp::done_with) continue;
            EXPECT_TRUE(place_of.emplace(blocks.member_at(place), place).second);
          }
          for (uint32_t m = 0; m < count; ++m) {
            const auto found = place_of.find(m);
            if (found == place_of.end()) {
              EXPECT_GE(expected.distance[m], blocks.nearest_unknown()) << m;
              unknown += expected.distance[m] < hsp::done_with ? 1U : 0U;
              continue;
            }
            const uint32_t place = found->second;
            EXPECT_EQ(planes.distance[place], expected.distance[m]) << m;
            EXPECT_TRUE(planes.x[place] == expected.x[m] && planes.y[place] == expected.y[m] &&
                        planes.z[place] == expected.z[m] && planes.h[place] == expected.h[m]);
          }
          ++calls;
        } while (blocks.find_more(target, planes));
        EXPECT_EQ(blocks.nearest_unknown(), hsp::done_with);

        const hsp::Vec3 point{2 * ball.x, 2 * ball.y, 2 * ball.z};
        const double error = 100.0 * random.fraction() - 90.0;
        for (uint32_t m = count; m < count + 7; ++m) expected.distance[m] = hsp::done_with;
        const bool is_before = is_before_all(target, members.get(), ball, point, error, expected.distance);
        EXPECT_EQ(blocks.is_before_known(target, point, error, planes.distance), is_before);
        ++(is_before ? before : not_before);
      }
    }
  }
  EXPECT_GT(calls, 500U);
  EXPECT_GT(unknown, 100000U);
  EXPECT_GT(before, 10U);
  EXPECT_GT(not_before, 10U);
}

}  // namespace
