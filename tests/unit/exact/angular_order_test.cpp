// The side of a plane through two directions, filter and exact stage together, against 128-bit integers.
#include <gtest/gtest.h>

#include "exact/angular_order.hpp"
#include "random_balls.hpp"

namespace {

using hsp::exact::orientation;
using hsp::exact::Vector;
__extension__ typedef __int128 Int128;

// |u|, |v|, |z| < 2^31: the determinant stays below 2^93.
int exact_sign(const Vector &u, const Vector &v, const Vector &z) {
  const Int128 value = (Int128{u.y} * v.z - Int128{u.z} * v.y) * z.x + (Int128{u.z} * v.x - Int128{u.x} * v.z) * z.y +
                       (Int128{u.x} * v.y - Int128{u.y} * v.x) * z.z;
  return (value > 0) - (value < 0);
}

class Vectors : public oracle::RandomSource {
 public:
  using RandomSource::RandomSource;
  Vector of_size(int64_t size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
};

// Of vectors shorter than 2^31 each component is below 2^31 / sqrt(3) if all are alike.
constexpr int64_t largest = 1239850262;

struct Seen {
  int left = 0, right = 0, flat = 0;
};

void check(const Vector &u, const Vector &v, const Vector &z, Seen &seen) {
  const int expected = exact_sign(u, v, z);
  ASSERT_EQ(orientation(u, v, z), expected) << u.x << ' ' << u.y << ' ' << u.z << "  " << v.x << ' ' << v.y << ' '
                                            << v.z << "  " << z.x << ' ' << z.y << ' ' << z.z;
  ASSERT_EQ(orientation(v, u, z), -expected);
  ++(expected > 0 ? seen.left : expected < 0 ? seen.right : seen.flat);
}

TEST(Orientation, OfRandomVectors) {
  Vectors vectors(1);
  Seen seen;
  for (int k = 0; k < 100000; ++k) {
    const int64_t size = largest >> vectors.in(0, 29);
    check(vectors.of_size(size), vectors.of_size(size), vectors.of_size(size), seen);
  }
  EXPECT_GT(seen.left, 10000);
  EXPECT_GT(seen.right, 10000);
  EXPECT_GT(seen.flat, 100);
}

// In one plane, or one step off: where a filter alone would guess.
TEST(Orientation, OfVectorsInOnePlaneAndNextToIt) {
  Vectors vectors(2);
  Seen seen;
  for (int k = 0; k < 100000; ++k) {
    const int64_t size = largest >> vectors.in(2, 29);
    const Vector u = vectors.of_size(size);
    const Vector v = vectors.of_size(size);
    const int64_t s = vectors.in(-2, 2);
    const int64_t t = vectors.in(-2, 2);
    Vector z{s * u.x + t * v.x, s * u.y + t * v.y, s * u.z + t * v.z};
    if (vectors.in(0, 2) > 0) {
      z.x += vectors.in(-1, 1);
      z.y += vectors.in(-1, 1);
      z.z += vectors.in(-1, 1);
    }
    check(u, v, z, seen);
  }
  EXPECT_GT(seen.left, 10000);
  EXPECT_GT(seen.right, 10000);
  EXPECT_GT(seen.flat, 10000);
}

// Nearly parallel vectors: products that cancel, and a determinant of a few steps between numbers of 2^93.
TEST(Orientation, OfNearlyParallelVectors) {
  Vectors vectors(3);
  Seen seen;
  for (int k = 0; k < 100000; ++k) {
    const Vector u = vectors.of_size(largest);
    const auto near = [&](int64_t off) {
      return Vector{u.x + vectors.in(-off, off), u.y + vectors.in(-off, off), u.z + vectors.in(-off, off)};
    };
    const int64_t off = vectors.in(0, 1) == 0 ? 1 : 100;
    check(u, near(off), near(off), seen);
  }
  EXPECT_GT(seen.left, 10000);
  EXPECT_GT(seen.right, 10000);
  EXPECT_GT(seen.flat, 1000);
}

TEST(Orientation, OfTheLongestVectors) {
  constexpr int64_t longest = (int64_t{1} << 31) - 1;
  Seen seen;
  const Vector axes[] = {{longest, 0, 0},
                         {0, longest, 0},
                         {0, 0, longest},
                         {-longest, 0, 0},
                         {0, -longest, 0},
                         {0, 0, -longest},
                         {largest, largest, largest},
                         {-largest, largest, largest},
                         {largest, -largest, largest},
                         {largest, largest, -largest},
                         {largest, largest, largest - 1},
                         {largest, largest - 1, largest},
                         {0, 0, 0}};
  for (const Vector &u : axes) {
    for (const Vector &v : axes) {
      for (const Vector &z : axes) check(u, v, z, seen);
    }
  }
  EXPECT_EQ(seen.left, seen.right);
  EXPECT_GT(seen.flat, 100);
}

}  // namespace
