// Parts of chords in lanes against the same from integers: balls of every size down to single steps, the largest there
// may be, planes that are nearly parallel, and balls on a small lattice, where much is 0 and lanes must not be certain.
#include "contacts/chord_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "carved_memory.hpp"
#include "exact/discriminant.hpp"
#include "exact/lattice_ball.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"
#include "sphere/caps.hpp"

#if HSP_LANES
namespace {

using hsp::exact::LatticeBall;

// Five balls of each chord: its three ones, and those that clip it.
class Chords {
 public:
  explicit Chords(hsp::Target target) : target_(target) {
    memory_.carve(balls_, 5 * hsp::ChordBatch::capacity);
    balls_.n = 5 * hsp::ChordBatch::capacity;
  }

  // If all meet the first one in circles and the chord is none of parallel planes.
  void add(const LatticeBall (&ball)[5], int free_ends) {
    for (uint32_t k = 1; k < 5; ++k) {
      if (hsp::exact::pair_relation(ball[0], ball[k]) != hsp::exact::PairRelation::circle) return;
    }
    const hsp::exact::Plane P = plane_of(ball[0], ball[1]);
    const hsp::exact::Plane Q = plane_of(ball[0], ball[2]);
    if (is_zero(cross(P.v, Q.v))) return;
    for (uint32_t k = 3; k < 5; ++k) {
      if (hsp::exact::Exact::triple_product_sign(P.v, Q.v, plane_of(ball[0], ball[k]).v) == 0) return;
    }
    const uint32_t s = batch_.count++;
    for (uint32_t k = 0; k < 5; ++k) {
      balls_.store(5 * s + k, ball[k]);
      (k < 3 ? batch_.ball[k] : batch_.clipper[k - 3])[s] = 5 * s + k;
    }
    const double root = std::sqrt(hsp::exact::discriminant(sphere_of(ball[0]), P, Q));
    const double clipped = std::numeric_limits<double>::quiet_NaN();
    batch_.free_end[0][s] = (free_ends & 1) != 0 ? -root : clipped;
    batch_.free_end[1][s] = (free_ends & 2) != 0 ? root : clipped;
    if (batch_.count == hsp::ChordBatch::capacity) compare();
  }

  uint32_t all() const { return all_; }
  uint32_t certain() const { return certain_; }

 private:
  void compare() {
    hsp::ChordBatch exact = batch_;
    const uint32_t uncertain = hsp::measure_in_lanes(target_, hsp::arrays_of(balls_), batch_, batch_.count);
    for (uint32_t s = 0; s < batch_.count; ++s) {
      ++all_;
      if ((uncertain >> s & 1U) != 0) continue;
      ++certain_;
      hsp::measure_in_integers(balls_, exact, s);
      for (uint32_t pair = 0; pair < 3; ++pair) EXPECT_EQ(batch_.part[pair][s], exact.part[pair][s]);
    }
    batch_.count = 0;
  }

  const hsp::Target target_;
  CarvedMemory memory_;
  hsp::BallSet balls_;
  hsp::ChordBatch batch_;
  uint32_t all_ = 0, certain_ = 0;
};

class ChordParts : public testing::TestWithParam<hsp::Target> {
 protected:
  // No lane is certain where this is left to integers.
  static bool by_integers() { return GetParam() == hsp::Target::baseline; }
};
INSTANTIATE_TEST_SUITE_P(Targets, ChordParts, testing::ValuesIn(runnable_targets()));

TEST_P(ChordParts, OfBallsOfEverySize) {
  oracle::RandomSource random(51);
  Chords chords(GetParam());
  for (uint32_t k = 0; k < 60000; ++k) {
    const int64_t size = int64_t{1} << random.in(4, 30);
    LatticeBall ball[5];
    for (LatticeBall &b : ball) {
      const int64_t x = random.in(-size / 3, size / 3), y = random.in(-size / 3, size / 3);
      b = {{x, y, random.in(-size / 3, size / 3)}, random.in(size / 3, size - 1), 0};
    }
    chords.add(ball, static_cast<int>(k % 4));
  }
  EXPECT_GT(chords.all(), 60000U / 8);
  EXPECT_TRUE(by_integers() || chords.certain() > chords.all() / 10 * 9);
}

// Centres near one line or plane, so that polynomials lose most of their digits.
TEST_P(ChordParts, OfNearlyParallelPlanes) {
  oracle::RandomSource random(52);
  Chords chords(GetParam());
  for (uint32_t k = 0; k < 60000; ++k) {
    const int64_t size = (int64_t{1} << 30) - 1;
    LatticeBall ball[5];
    const int64_t wide = int64_t{1} << random.in(0, 26);
    for (LatticeBall &b : ball) {
      const int64_t x = random.in(-size / 2, size / 2);
      b = {{x, random.in(-wide, wide), k % 2 == 0 ? random.in(-wide, wide) : random.in(-size / 2, size / 2)}, 0, 0};
      b.radius = size - random.in(0, wide);
    }
    chords.add(ball, static_cast<int>(k % 4));
  }
  EXPECT_GT(chords.all(), 60000U / 8);
  EXPECT_TRUE(by_integers() || chords.certain() > chords.all() / 4);
}

TEST_P(ChordParts, OfBallsOnASmallLattice) {
  oracle::RandomSource random(53);
  Chords chords(GetParam());
  for (uint32_t k = 0; k < 60000; ++k) {
    const int64_t step = int64_t{1} << random.in(0, 25);
    LatticeBall ball[5];
    for (LatticeBall &b : ball) {
      b = {{step * random.in(-3, 3), step * random.in(-3, 3), step * random.in(-3, 3)}, step * random.in(2, 6), 0};
    }
    chords.add(ball, static_cast<int>(k % 4));
  }
  EXPECT_GT(chords.all(), 60000U / 16);
  EXPECT_TRUE(by_integers() || chords.certain() > chords.all() / 10);
  EXPECT_LT(chords.certain(), chords.all());
}

}  // namespace
#endif
