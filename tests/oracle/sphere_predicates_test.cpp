// The naive predicates against other formulas for balls that are inflated by tiny numbers instead of infinitesimals.
#include "sphere_predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "big_integer.hpp"
#include "random_balls.hpp"

namespace {

using namespace oracle;

using Triple = std::array<BigInteger, 3>;

BigInteger dot(const Triple &a, const Triple &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Triple cross(const Triple &a, const Triple &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Triple combination(const BigInteger &s, const Triple &a, const BigInteger &t, const Triple &b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

// Up to four balls, scaled by 2^640. In units before scaling each weight w is enlarged by w / 2^90 (for eps_0), by M /
// 2^270 (for eps_5) and, by the ball's rank, by 2^-360, 2^-450, 2^-540 or 2^-630. The second number is far below the
// square of the first, and each later number is far below the one before, times any coefficient that balls of a few
// steps can produce. There is nothing for eps_1 to eps_4.
class ExplicitBalls {
 public:
  explicit ExplicitBalls(const TiedBalls &set) {
    constexpr std::array<unsigned, 4> exponent = {920, 830, 740, 650};
    for (uint32_t i = 0; i < set.size(); ++i) {
      const LatticeBall &ball = set.balls()[i];
      centre_.push_back({scaled(ball.x, 640), scaled(ball.y, 640), scaled(ball.z, 640)});
      const Int128 weight = Int128{ball.radius} * ball.radius;
      const Int128 form = Int128{1009} * ball.x * ball.x + Int128{757} * ball.x * ball.y +
                          Int128{499} * ball.x * ball.z + Int128{331} * ball.y * ball.y +
                          Int128{211} * ball.y * ball.z + Int128{113} * ball.z * ball.z;
      weight_.push_back(scaled(weight, 1280) + scaled(weight, 1190) + scaled(form, 1010) +
                        scaled(1, exponent[set.rank(i)]));
    }
  }

  // Vector formulas: with y' = 2 (x - c_a) ball b is v.y' > h, and circles u, v cross at (q x n + s sqrt(D) n) / N
  // where n = u x v, q = h_u v - h_v u, N = n.n, D = 4 w N - q.q.
  [[nodiscard]] int crossing(uint32_t a, uint32_t b, uint32_t c) const {
    const View view(*this, a, b, c);
    return view.N.sign() == 0 ? -1 : view.D.sign();
  }

  [[nodiscard]] int inside(uint32_t a, uint32_t b, uint32_t c, int side, uint32_t d) const {
    const View view(*this, a, b, c);
    const Triple z = difference(a, d);
    const BigInteger rational = dot(z, cross(view.q, view.n)) - view.N * height(a, d);
    const BigInteger root = side > 0 ? dot(z, view.n) : -dot(z, view.n);
    if (rational.sign() >= 0 && root.sign() >= 0) return rational.sign() + root.sign() > 0 ? 1 : 0;
    if (rational.sign() <= 0 && root.sign() <= 0) return -1;
    return rational.sign() * (rational * rational - root * root * view.D).sign();
  }

  [[nodiscard]] PairRelation pair(uint32_t a, uint32_t b) const {
    // Distances squared: |w_a + w_b - U| < 2 r_a r_b for a proper circle.
    const Triple v = difference(a, b);
    const BigInteger U = dot(v, v);
    const BigInteger excess = weight_[a] + weight_[b] - U;
    if ((excess * excess - BigInteger(4) * weight_[a] * weight_[b]).sign() < 0) return PairRelation::circle;
    if (excess.sign() < 0) return PairRelation::disjoint;
    return (weight_[a] - weight_[b]).sign() < 0 ? PairRelation::first_inside_second : PairRelation::second_inside_first;
  }

 private:
  struct View {
    View(const ExplicitBalls &balls, uint32_t a, uint32_t b, uint32_t c) {
      const Triple u = balls.difference(a, b);
      const Triple v = balls.difference(a, c);
      n = cross(u, v);
      N = dot(n, n);
      q = combination(balls.height(a, b), v, -balls.height(a, c), u);
      D = BigInteger(4) * balls.weight_[a] * N - dot(q, q);
    }
    Triple n, q;
    BigInteger N, D;
  };
  static BigInteger scaled(Int128 value, unsigned bits) { return BigInteger(value).times_power_of_two(bits); }
  [[nodiscard]] Triple difference(uint32_t a, uint32_t b) const {
    return combination(BigInteger(1), centre_[b], BigInteger(-1), centre_[a]);
  }
  [[nodiscard]] BigInteger height(uint32_t a, uint32_t b) const {
    const Triple v = difference(a, b);
    return dot(v, v) + weight_[a] - weight_[b];
  }

  std::vector<Triple> centre_;
  std::vector<BigInteger> weight_;
};

TEST(SpherePredicates, AgreeWithExplicitTinyInflations) {
  RandomSource random(3);
  int crossings = 0;
  int ties = 0;
  for (int k = 0; k < 600; ++k) {
    Balls balls = random.one_in(2) ? grid_balls(random, 4) : degenerate_balls(random, 4);
    for (LatticeBall &ball : balls) {
      // Keep coefficients below 2^60.
      ball = {std::clamp<int64_t>(ball.x, -8, 8), std::clamp<int64_t>(ball.y, -8, 8),
              std::clamp<int64_t>(ball.z, -8, 8), std::min<int64_t>(ball.radius, 8)};
    }
    const TiedBalls set(balls);
    const ExplicitBalls explicit_balls(set);
    for (uint32_t a = 0; a < 4; ++a)
      for (uint32_t b = 0; b < 4; ++b) {
        if (b == a) continue;
        ASSERT_EQ(set.pair(a, b), explicit_balls.pair(a, b)) << to_text(balls);
        if (set.pair(a, b) != PairRelation::circle) continue;
        for (uint32_t c = 0; c < 4; ++c) {
          if (c == a || c == b || set.pair(a, c) != PairRelation::circle) continue;
          const bool cross = set.circles_cross(a, set.cap(a, b), set.cap(a, c));
          ASSERT_EQ(cross, explicit_balls.crossing(a, b, c) > 0) << to_text(balls);
          const uint32_t d = 6 - a - b - c;
          if (!cross || set.pair(a, d) != PairRelation::circle) continue;
          for (const int side : {+1, -1}) {
            const Crossing point = {set.cap(a, b), set.cap(a, c), side};
            ASSERT_EQ(set.crossing_inside(a, point, set.cap(a, d)), explicit_balls.inside(a, b, c, side, d) > 0)
                << to_text(balls);
            ++crossings;
            ties += set.crossing_inside_as_given(a, point, set.cap(a, d)) == 0 ? 1 : 0;
          }
        }
      }
  }
  EXPECT_GT(crossings, 1000);
  EXPECT_GT(ties, 100);
}

TEST(SpherePredicates, RankIsLexicographic) {
  const Balls balls = {{1, 0, 0, 2}, {0, 5, 0, 1}, {1, 0, 0, 1}, {0, 5, 0, 1}, {1, -1, 9, 9}};
  EXPECT_EQ(tie_ranks(balls), (std::vector<uint32_t>{4, 0, 3, 1, 2}));
}

TEST(SpherePredicates, LowestRankSwallowsItsDuplicates) {
  const TiedBalls set({{0, 0, 0, 5}, {0, 0, 0, 5}});
  EXPECT_EQ(set.pair(0, 1), PairRelation::second_inside_first);
  EXPECT_EQ(set.pair(1, 0), PairRelation::first_inside_second);
}

}  // namespace
