// The side of a plane through two directions, filter and exact stage together, against 128-bit integers; and the order
// of directions around an axis against angles.
#include "angular_order_cases.hpp"

#include <cmath>
#include <numbers>

#include "expect_cases.hpp"
#include "int128.hpp"
#include "random_balls.hpp"

namespace {

using hsp::exact::orientation;
using hsp::exact::Vector;
using oracle::Int128;

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

constexpr int64_t largest = cases::longest_diagonal;

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

TEST(Orientation, Cases) {
  expect_cases(cases::exact_angular_order);
}

TEST(CyclicOrder, AgreesWithAngles) {
  Vectors vectors(4);
  for (int k = 0; k < 50000; ++k) {
    const Vector axis = vectors.of_size(10);
    const Vector reference = vectors.of_size(10);
    const Vector v = vectors.of_size(10);
    const Vector w = vectors.of_size(10);
    const auto angle = [&](const Vector &direction) {
      const Vector across = cross(axis, reference);
      const double length = std::sqrt(static_cast<double>(dot(axis, axis)));
      const double sine = static_cast<double>(dot(across, direction)) * length;
      const double cosine = static_cast<double>(dot(across, cross(axis, direction)));
      const double to_view = std::atan2(sine, cosine);
      return to_view < 0.0 ? to_view + 2 * std::numbers::pi : to_view;
    };
    if (is_zero(cross(axis, reference)) || is_zero(cross(axis, v)) || is_zero(cross(axis, w))) continue;
    const double angle_v = angle(v);
    const double angle_w = angle(w);
    if (std::fabs(angle_v - angle_w) < 1e-9 || std::fabs(angle_v - angle_w) > 6.2831) continue;
    EXPECT_EQ(counter_clockwise_before(axis, reference, v, w), angle_v < angle_w);
    if (angle_v > 1e-9 && angle_w > 1e-9) {
      EXPECT_EQ(strictly_between(axis, reference, v, w), angle_v < angle_w);
    }
    EXPECT_TRUE(strictly_between(axis, v, w, v));
  }
}

}  // namespace
