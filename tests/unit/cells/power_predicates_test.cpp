// The exact questions about power cells, held against the same values computed in a ring with infinitesimal weights.
#include "cells/power_predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "built_free_space.hpp"
#include "infinitesimal.hpp"
#include "random_balls.hpp"

namespace {

using hsp::PowerPlane;
using oracle::Balls;
using oracle::Infinitesimal;
using Number = Infinitesimal;
using Vector = std::array<int64_t, 3>;

Number number(oracle::Int128 value) {
  return Number(value);
}

struct Plane {
  Vector v;
  Number h;
};

// Up to four balls, in the library's order, whose weights have infinitesimals by rank.
class Ring {
 public:
  Ring(const hsp::BallSet &balls, const hsp::CubeFrame &frame) : balls_(balls), frame_(frame) {
    std::vector<uint32_t> order;
    for (uint32_t i = 0; i < balls.n; ++i) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
    place_.resize(balls.n);
    for (uint32_t k = 0; k < balls.n; ++k) place_[order[k]] = k;
  }
  Number weight(uint32_t ball) const {
    const auto r = static_cast<oracle::Int128>(balls_.r[ball]);
    return number(r * r) + Number::epsilon(place_[ball]);
  }
  Number h(uint32_t origin, uint32_t ball) const {
    const auto v = balls_.exact_difference(origin, ball);
    const oracle::Int128 x = v.x, y = v.y, z = v.z;
    return number(x * x + y * y + z * z) + weight(origin) - weight(ball);
  }
  Plane plane(uint32_t origin, const PowerPlane &name) const {
    if (!name.is_side()) {
      const auto v = balls_.exact_difference(name.near, name.far);
      const Number zero;
      return {{v.x, v.y, v.z},
              (name.far == origin ? zero : h(origin, name.far)) - (name.near == origin ? zero : h(origin, name.near))};
    }
    const auto low = frame_.low();
    const auto c = balls_.ball(origin).centre;
    const std::array<int64_t, 3> from{low.x - c.x, low.y - c.y, low.z - c.z};
    const size_t axis = name.side() / 2;
    const bool upper = name.side() % 2 != 0;
    Plane plane{{0, 0, 0}, number(2 * (upper ? from[axis] + frame_.exact_side() : -from[axis]))};
    plane.v[axis] = upper ? 1 : -1;
    return plane;
  }

 private:
  const hsp::BallSet &balls_;
  const hsp::CubeFrame &frame_;
  std::vector<uint32_t> place_;
};

oracle::Int128 minor(const Vector &a, const Vector &b, size_t k) {
  const size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return oracle::Int128{a[i]} * b[j] - oracle::Int128{a[j]} * b[i];
}

struct Common {
  Common(const Plane &P, const Plane &Q, const Plane &R) {
    for (size_t k = 0; k < 3; ++k) {
      H[k] = number(minor(Q.v, R.v, k)) * P.h + number(minor(R.v, P.v, k)) * Q.h + number(minor(P.v, Q.v, k)) * R.h;
      n[k] = minor(P.v, Q.v, k);
      B = B + number(n[k]) * number(R.v[k]);
    }
  }
  std::array<Number, 3> H;
  std::array<oracle::Int128, 3> n;
  Number B;
};

template <class A, class C>
Number sum_of_products(const A &a, const C &b) {
  Number sum;
  for (size_t k = 0; k < 3; ++k) sum = sum + Number(a[k]) * Number(b[k]);
  return sum;
}

struct Answers {
  uint32_t vertices = 0, lines = 0, zeros = 0;
};

void compare(const BuiltFreeSpace &built, oracle::RandomSource &random, Answers &answers) {
  const hsp::BallSet &balls = built.balls();
  const hsp::CubeFrame frame(built.grid().cube_at(balls.ball(0).centre), built.grid().side());
  const Ring ring(balls, frame);
  const uint32_t origin = static_cast<uint32_t>(random.in(0, 3));
  const hsp::PowerPredicates exact(balls, origin, frame);
  const auto any_plane = [&](bool of_origin) {
    for (;;) {
      if (random.one_in(3)) return hsp::side_plane(static_cast<uint32_t>(random.in(0, 5)));
      const uint32_t near = of_origin ? origin : static_cast<uint32_t>(random.in(0, 3));
      const uint32_t far = static_cast<uint32_t>(random.in(0, 3));
      if (near == far || balls.exact_difference(near, far).x == 0) continue;
      return PowerPlane{near, far};
    }
  };
  const auto planes = [&](const PowerPlane &p) { return ring.plane(origin, p); };

  const PowerPlane P = any_plane(false), Q = any_plane(false), R = any_plane(false), S = any_plane(false);
  const Common any(planes(P), planes(Q), planes(R));
  if (any.B.sign() != 0) {
    const Plane s = planes(S);
    const int sign = (any.B * s.h - sum_of_products(any.H, s.v)).sign() * any.B.sign();
    ASSERT_EQ(exact.side_of(P, Q, R, S), sign);
    answers.zeros += sign == 0 ? 1U : 0U;
    ++answers.vertices;
  }
  const PowerPlane p = any_plane(true), q = any_plane(true), r = any_plane(true);
  const Common own(planes(p), planes(q), planes(r));
  const Number W = number(4) * ring.weight(origin);
  const Plane u = planes(p), v = planes(q);
  const Number N = sum_of_products(own.n, own.n);
  if (own.B.sign() != 0) {
    ASSERT_EQ(exact.is_outside(p, q, r), (W * own.B * own.B - sum_of_products(own.H, own.H)).sign() < 0);
  }
  if (N.sign() != 0) {
    std::array<Number, 3> radical;
    for (size_t k = 0; k < 3; ++k) radical[k] = u.h * number(v.v[k]) - v.h * number(u.v[k]);
    const bool meets = (W * N - sum_of_products(radical, radical)).sign() > 0;
    ASSERT_EQ(exact.meets_line(p, q), meets);
    // On the line the point n-ward of the centre: N (z.m - h_R), from m = (radical x n) / N.
    const Common with(u, v, planes(R));
    ASSERT_EQ(exact.side_of_middle(p, q, R), sum_of_products(with.H, with.n).sign());
    ++answers.lines;
  }
  const Number U = sum_of_products(u.v, u.v);
  ASSERT_EQ(exact.meets_plane(p), (W * U - u.h * u.h).sign() > 0);
  ASSERT_EQ(exact.side_of_disc(p, R), (U * planes(R).h - u.h * sum_of_products(u.v, planes(R).v)).sign());
  if (!p.is_side()) {
    ASSERT_EQ(exact.side_of_centre(p), u.h.sign());
  }
}

TEST(PowerPredicates, AreThoseOfInflatedBalls) {
  oracle::RandomSource random(1);
  Answers answers;
  for (int k = 0; k < 1500; ++k) {
    Balls balls;
    const int64_t most = random.one_in(3) ? (INT64_C(1) << 30) - 1 : random.in(2, 8);
    for (int i = 0; i < 4; ++i) {
      const int64_t x = random.in(0, 2 * most), y = random.in(0, 2 * most), z = random.in(0, 2 * most);
      balls.push_back({x, y, z, i == 0 ? most : random.in(0, most)});
    }
    const BuiltFreeSpace built(balls);
    ASSERT_NO_FATAL_FAILURE(compare(built, random, answers)) << oracle::to_text(balls);
  }
  EXPECT_GT(answers.vertices, 500U);
  EXPECT_GT(answers.lines, 500U);
  EXPECT_GT(answers.zeros, 30U);
}

}  // namespace
