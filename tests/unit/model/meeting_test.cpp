// The bounds of meeting.hpp against integers: where doubles or floats are certain they are right, whether products are
// fused or not, and pairs are made so that they are as near to a tie as there are integers.
#include "model/meeting.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

#if defined(__SIZEOF_INT128__)

using Wide = __int128;

struct Pair {
  int64_t dx, dy, dz, sum;

  // d^2 - t^2
  Wide excess() const { return Wide{dx} * dx + Wide{dy} * dy + Wide{dz} * dz - Wide{sum} * sum; }
};

int sign_of(Wide a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}

class RandomPairs {
 public:
  int64_t in(int64_t low, int64_t high) { return std::uniform_int_distribution<int64_t>(low, high)(random_); }
  // The sum of the radii is the distance, rounded and up to two more or less; for some it is the distance itself.
  Pair next(int64_t largest) {
    if (in(0, 7) == 0) {
      const int64_t k = in(0, largest / 9);
      return in(0, 1) == 0 ? Pair{k, -4 * k, 8 * k, 9 * k} : Pair{2 * k, 3 * k, -6 * k, 7 * k};
    }
    Pair pair{in(-largest, largest), in(-largest, largest), in(-largest, largest), 0};
    const double length = std::sqrt(static_cast<double>(pair.dx) * static_cast<double>(pair.dx) +
                                    static_cast<double>(pair.dy) * static_cast<double>(pair.dy) +
                                    static_cast<double>(pair.dz) * static_cast<double>(pair.dz));
    pair.sum = static_cast<int64_t>(length) + in(-2, 2);
    return pair;
  }

 private:
  std::mt19937_64 random_{17};
};

// d^2 - t^2 as kernels compute it, in floats or doubles.
template <class Real>
Real excess(Real dx, Real dy, Real dz, Real sum, bool fused) {
  if (!fused) return dz * dz + (dy * dy + (dx * dx - sum * sum));
  return std::fma(dz, dz, std::fma(dy, dy, std::fma(dx, dx, -(sum * sum))));
}

TEST(Meeting, IntegersDecideTies) {
  RandomPairs pairs;
  for (int bits = 2; bits <= 29; ++bits) {
    for (int k = 0; k < 2000; ++k) {
      const Pair pair = pairs.next(int64_t{1} << bits);
      const double dx = static_cast<double>(pair.dx), dy = static_cast<double>(pair.dy),
                   dz = static_cast<double>(pair.dz), sum = static_cast<double>(pair.sum);
      if (pair.sum < 0) continue;
      ASSERT_EQ(hsp::meet(dx, dy, dz, sum), pair.excess() <= 0);
      ASSERT_EQ(hsp::meet_exactly(dx, dy, dz, sum), pair.excess() <= 0);
    }
  }
  EXPECT_TRUE(hsp::meet(0, 0, 0, 0));
  EXPECT_FALSE(hsp::meet(1, 0, 0, 0));
}

// Both ways in which doubles are asked. Most pairs are left open by neither, as they are not that near to a tie.
TEST(Meeting, DoublesAreRightWhereTheyAreCertain) {
  RandomPairs pairs;
  uint32_t open = 0, certain = 0;
  for (int k = 0; k < 400000; ++k) {
    const Pair pair = pairs.next(int64_t{1} << (20 + k % 10));
    if (pair.sum < 0) continue;
    const double dx = static_cast<double>(pair.dx), dy = static_cast<double>(pair.dy),
                 dz = static_cast<double>(pair.dz), sum = static_cast<double>(pair.sum);
    const int sign = sign_of(pair.excess());
    const double squared = dx * dx + dy * dy + dz * dz, within = sum * sum;
    if (squared > within * hsp::certainly_above) {
      ASSERT_EQ(sign, 1);
    } else if (squared < within * hsp::certainly_below) {
      ASSERT_EQ(sign, -1);
    }
    for (const bool fused : {false, true}) {
      const double computed = excess(dx, dy, dz, sum, fused);
      const bool is_certain = std::fabs(computed) > hsp::meeting_doubt * within;
      if (is_certain) {
        ASSERT_EQ(sign, computed > 0.0 ? 1 : -1);
      }
      ++(is_certain ? certain : open);
    }
  }
  EXPECT_GT(open, 40000U);
  EXPECT_GT(certain, 40000U);
}

// The error of a difference of squares in floats, as a part of the doubt. It comes near to a quarter of it.
struct Errors {
  double largest = 0.0;
  bool signs_are_right = true;

  void add(double computed, const Pair &pair, double doubt) {
    const Wide exact = pair.excess();
    const double error = std::fabs(computed - static_cast<double>(exact)) / doubt;
    if (error > largest) largest = error;
    if (std::fabs(computed) > doubt && sign_of(exact) != (computed > 0.0 ? 1 : -1)) signs_are_right = false;
  }
};

float rounded(int64_t halves) {
  return static_cast<float>(0.5 * static_cast<double>(halves));
}

// One ball is within 1.5 sides of a point along each axis; radii are up to half a side, and distances near their sum.
TEST(Meeting, FloatsAboutAPointNearby) {
  RandomPairs pairs;
  for (const int64_t side : {INT64_C(1000003), INT64_C(123456789), (INT64_C(1) << 31) - 2}) {
    Errors errors;
    const double doubt = hsp::doubt_nearby(static_cast<double>(side));
    for (int k = 0; k < 100000; ++k) {
      Pair pair = pairs.next(side * 4 / 7);
      if (pair.sum < 0 || pair.sum > side) continue;
      const int64_t own = pair.sum / 2;
      int64_t at[3];
      for (int64_t &along : at) along = pairs.in(0, 1) == 0 ? pairs.in(-3 * side, 3 * side) : 3 * side - pairs.in(0, 9);
      const float dx = rounded(at[0] + 2 * pair.dx) - rounded(at[0]),
                  dy = rounded(at[1] + 2 * pair.dy) - rounded(at[1]),
                  dz = rounded(at[2] + 2 * pair.dz) - rounded(at[2]),
                  sum = rounded(2 * own) + rounded(2 * (pair.sum - own));
      for (const bool fused : {false, true}) {
        errors.add(static_cast<double>(excess(dx, dy, dz, sum, fused)), pair, doubt);
      }
    }
    EXPECT_TRUE(errors.signs_are_right);
    EXPECT_LT(errors.largest, 1.0);
    EXPECT_GT(errors.largest, 0.15);
  }
}

TEST(Meeting, FloatsAboutTheMiddleOfASet) {
  RandomPairs pairs;
  for (const int64_t extent : {INT64_C(50000000), INT64_C(3000000001), INT64_C(1) << 40}) {
    Errors errors;
    const int64_t reach = 30000000;
    const double doubt = hsp::doubt_within(static_cast<double>(extent), static_cast<double>(reach));
    for (int k = 0; k < 100000; ++k) {
      const Pair pair = pairs.next(reach * 4 / 7);
      if (pair.sum < 0 || pair.sum > reach) continue;
      const int64_t own = pair.sum / 2;
      int64_t at[3];
      for (int64_t &along : at) along = pairs.in(0, 1) == 0 ? pairs.in(-extent, extent) : extent - pairs.in(0, 9);
      const float dx = rounded(2 * (at[0] + pair.dx)) - rounded(2 * at[0]),
                  dy = rounded(2 * (at[1] + pair.dy)) - rounded(2 * at[1]),
                  dz = rounded(2 * (at[2] + pair.dz)) - rounded(2 * at[2]),
                  sum = rounded(2 * own) + rounded(2 * (pair.sum - own));
      for (const bool fused : {false, true}) {
        errors.add(static_cast<double>(excess(dx, dy, dz, sum, fused)), pair, doubt);
      }
    }
    EXPECT_TRUE(errors.signs_are_right);
    EXPECT_LT(errors.largest, 1.0);
    EXPECT_GT(errors.largest, 0.05);
  }
}

#else

TEST(Meeting, NeedsWideIntegers) {
  EXPECT_TRUE(hsp::meet(3, 4, 0, 5));
}

#endif

}  // namespace
