// Contacts in lanes against the same from integers: of balls of every size down to single steps, the largest there may
// be, and circles that touch or nearly do, where lanes must not be certain.
#include "contacts/contact_measures.hpp"

#include <gtest/gtest.h>

#include "carved_memory.hpp"
#include "exact/lattice_ball.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"
#include "sphere/caps.hpp"

namespace {

using hsp::exact::LatticeBall;
using hsp::exact::PairRelation;

class Pairs {
 public:
  Pairs() {
    memory_.carve(balls_, 8);
    balls_.n = 8;
  }

  // If they meet in a circle, or touch.
  void add(oracle::RandomSource &random, const LatticeBall &a, const LatticeBall &b) {
    if (hsp::exact::pair_relation(a, b) != PairRelation::circle) return;
    balls_.store(2 * count_, a);
    balls_.store(2 * count_ + 1, b);
    for (uint32_t side = 0; side < 2; ++side) contacts_.ball[side][count_] = 2 * count_ + side;
    const double r = static_cast<double>(a.radius);
    contacts_.area[count_] = r * r * r * static_cast<double>(random.in(-1000, 1000));
    contacts_.rim[count_] = static_cast<double>(random.in(0, 6000)) / 1000;
    if (++count_ == 4) compare();
  }
  uint32_t groups() const { return groups_; }
  uint32_t certain() const { return certain_; }
  uint32_t touching() const { return touching_; }

 private:
  void compare() {
    count_ = 0;
    ++groups_;
    hsp::ContactMeasures exact = contacts_;
    for (uint32_t s = 0; s < 4; ++s) {
      const LatticeBall a = balls_.ball(2 * s), b = balls_.ball(2 * s + 1);
      const hsp::exact::Plane P = plane_of(a, b);
      const int64_t sum = a.radius + b.radius, difference = a.radius - b.radius, U = dot(P.v, P.v);
      const bool touches = U == sum * sum || U == difference * difference;
      touching_ += touches ? 1U : 0U;
      EXPECT_EQ(hsp::measure_contact_in_integers(balls_, exact, s), touches);
      EXPECT_TRUE(!touches || (exact.area[s] == 0.0 && exact.rim[s] == 0.0));
    }
    if constexpr (hsp::has_lanes) {
      for (const hsp::Target target : runnable_targets()) {
        hsp::ContactMeasures found = contacts_;
        const bool certain = hsp::measure_contacts_in_lanes(target, hsp::arrays_of(balls_), found);
        certain_ += certain ? 1U : 0U;
        const hsp::ContactMeasures &expected = certain ? exact : contacts_;
        for (uint32_t s = 0; s < 4; ++s) {
          EXPECT_EQ(found.area[s], expected.area[s]);
          EXPECT_EQ(found.rim[s], expected.rim[s]);
          for (uint32_t side = 0; certain && side < 2; ++side) EXPECT_EQ(found.cone[side][s], exact.cone[side][s]);
        }
      }
    }
  }

  CarvedMemory memory_;
  hsp::BallSet balls_;
  hsp::ContactMeasures contacts_{};
  uint32_t count_ = 0, groups_ = 0, certain_ = 0, touching_ = 0;
};

TEST(ContactMeasures, OfBallsOfEverySize) {
  oracle::RandomSource random(61);
  Pairs pairs;
  for (int k = 0; k < 60000; ++k) {
    const int64_t size = int64_t{1} << random.in(4, 30);
    LatticeBall ball[2];
    for (LatticeBall &b : ball) {
      const int64_t x = random.in(-size / 2, size / 2), y = random.in(-size / 2, size / 2);
      b = {{x, y, random.in(-size / 2, size / 2)}, random.in(1, size - 1), 0};
    }
    pairs.add(random, ball[0], ball[1]);
  }
  EXPECT_GT(pairs.groups(), 4000U);
  if (hsp::best_target() == hsp::Target::avx2) {
    EXPECT_GT(pairs.certain(), pairs.groups() / 2);
  }
}

// Along one axis, by a step or more less than the sum or the difference of the radii apart, in which Delta loses bits.
TEST(ContactMeasures, OfBallsThatNearlyTouch) {
  oracle::RandomSource random(62);
  Pairs pairs;
  for (int k = 0; k < 60000; ++k) {
    const int64_t r = (int64_t{1} << 29) + random.in(0, int64_t{1} << 28), s = r + random.in(1, int64_t{1} << 28);
    const int64_t off = random.in(0, int64_t{1} << random.in(0, 20)) - (k % 16 == 0 ? 1 : 0);
    const int64_t apart = k % 2 == 0 ? r + s - off : s - r + off;
    pairs.add(random, {{0, 0, 0}, r, 0}, {{0, apart, random.in(0, 1)}, s, 1});
  }
  EXPECT_GT(pairs.groups(), 10000U);
  EXPECT_GT(pairs.touching(), 100U);
  if (hsp::best_target() == hsp::Target::avx2) {
    EXPECT_GT(pairs.certain(), pairs.groups() / 10);
    EXPECT_LT(pairs.certain(), pairs.groups());
  }
}

}  // namespace
