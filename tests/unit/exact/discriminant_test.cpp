// D in the compiler's 128-bit integers against the exact stage over limbs of 32 bits: balls of every size down to
// single steps, where D has few bits or is 0, and the largest that the contract of plane.hpp allows.
#include "exact/discriminant.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "exact/lattice_ball.hpp"
#include "random_balls.hpp"

namespace {

using hsp::exact::LatticeBall;

// Whether the circles of the second and third ball on the first cross.
bool expect_same(const LatticeBall &origin, const LatticeBall &p, const LatticeBall &q) {
  for (const LatticeBall *other : {&p, &q}) {
    if (hsp::exact::pair_relation(origin, *other) != hsp::exact::PairRelation::circle) return false;
  }
  const hsp::exact::Sphere sphere = sphere_of(origin);
  const hsp::exact::Plane P = plane_of(origin, p), Q = plane_of(origin, q);
  const double expected = hsp::exact::ExactPredicates<uint32_t>::discriminant(sphere, P, Q);
  const double found = hsp::exact::discriminant(sphere, P, Q);
  EXPECT_EQ(found, expected) << "centres (" << P.v.x << ", " << P.v.y << ", " << P.v.z << ") and (" << Q.v.x << ", "
                             << Q.v.y << ", " << Q.v.z << "), h " << P.h << " and " << Q.h << ", W " << sphere.W;
  return expected > 0.0;
}

TEST(Discriminant, OfBallsOfEverySize) {
  oracle::RandomSource random(41);
  int crossing = 0;
  for (int k = 0; k < 1000000; ++k) {
    const int64_t size = int64_t{1} << random.in(0, 30);
    LatticeBall ball[3];
    for (LatticeBall &b : ball) {
      const int64_t width = random.in(0, size - 1);
      b = {{random.in(-width, width), random.in(-width, width), random.in(-width, width)}, random.in(0, size - 1), 0};
    }
    crossing += expect_same(ball[0], ball[1], ball[2]);
  }
  EXPECT_GT(crossing, 50000);
}

// Around the centre of the sphere, where D is largest, and where q.q nearly takes away all of W n.n.
TEST(Discriminant, OfTheLargestBalls) {
  oracle::RandomSource random(42);
  constexpr int64_t most = (int64_t{1} << 30) - 1;
  const LatticeBall origin{{0, 0, 0}, most, 0};
  int crossing = 0;
  for (int k = 0; k < 200000; ++k) {
    const int64_t spread = int64_t{1} << random.in(0, 30);
    const auto near = [&](int64_t value) { return value - random.in(0, spread - 1); };
    const LatticeBall p{{near(most), 0, random.in(0, 1)}, near(most), 1};
    const LatticeBall q{{random.in(0, 1), near(most), near(most)}, near(most), 2};
    crossing += expect_same(origin, p, q);
  }
  EXPECT_GT(crossing, 10000);
}

// The third sphere passes through a point of the circle of the first two that lies on the lattice: D is a small
// integer, 0 if the circles touch there.
TEST(Discriminant, OfCirclesThatAlmostTouch) {
  oracle::RandomSource random(43);
  int touching = 0;
  for (int64_t scale = 1; scale < int64_t{1} << 24; scale *= 3) {
    for (int k = 0; k < 300; ++k) {
      // Circles x = a and y = b on the sphere of radius 5 with a = 3 and b = 4, and what lies one step beside.
      const auto offset = [&]() { return random.in(-1, 1); };
      const LatticeBall origin{{0, 0, 0}, 5 * scale, 0};
      const LatticeBall p{{6 * scale + offset(), offset(), 0}, 5 * scale + offset(), 1};
      const LatticeBall q{{0, 8 * scale + offset(), offset()}, 5 * scale + offset(), 2};
      touching += !expect_same(origin, p, q);
    }
  }
  EXPECT_GT(touching, 100);
}

#if defined(__SIZEOF_INT128__) && !defined(HSP_PORTABLE_LIMBS)
// Half-way between two doubles what lies far below decides.
TEST(Discriminant, IsRoundedToTheNearestDouble) {
  using hsp::exact::int128;
  const auto expect = [](int128 high, uint64_t low, double expected) {
    EXPECT_EQ(hsp::exact::rounded_or_zero(high, low), expected) << static_cast<uint64_t>(high) << " " << low;
  };
  const int128 one = static_cast<int128>(1) << 64;  // 2^128 as the upper part
  expect(one, 0, 0x1p128);
  expect(one + (1 << 11), 0, 0x1p128);
  expect(one + (1 << 11), 1, 0x1.0000000000001p128);
  expect(one + 3 * (1 << 11), 0, 0x1.0000000000002p128);
  expect(one + 3 * (1 << 11), 1, 0x1.0000000000002p128);
  expect(1, UINT64_C(1) << 11, 0x1p64);
  expect(1, (UINT64_C(1) << 11) + 1, 0x1.0000000000001p64);
  expect(INT64_MAX, UINT64_MAX, 0x1p127);
  expect(0, (UINT64_C(1) << 53) + 1, 0x1p53);
  expect(0, UINT64_MAX, 0x1p64);
  expect(0, 0, 0.0);
  expect(-1, UINT64_MAX, 0.0);
  expect(-one, 7, 0.0);
}
#endif

}  // namespace
