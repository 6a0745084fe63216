#include "sphere_predicates.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <stdexcept>
#include <type_traits>

#include "big_integer.hpp"
#include "infinitesimal.hpp"

namespace oracle {
namespace {

// The weights of the balls as given, in one type of number.
template <class NumberType>
class GivenWeights {
 public:
  using Number = NumberType;
  explicit GivenWeights(const Balls &balls) : balls_(balls) {}
  Number operator()(uint32_t ball) const { return Number(Int128{balls_[ball].radius} * balls_[ball].radius); }

 private:
  const Balls &balls_;
};

// The inflated weights of the few balls of one question, up to the first few infinitesimals.
class InflatedWeights {
 public:
  using Number = Infinitesimal;
  InflatedWeights(const TiedBalls &set, std::initializer_list<uint32_t> balls, unsigned infinitesimals) {
    for (const uint32_t ball : balls)
      if (ball != no_ball) balls_.push_back(ball);
    std::sort(balls_.begin(), balls_.end(), [&](uint32_t a, uint32_t b) { return set.rank(a) < set.rank(b); });
    if (TiedBalls::levels + balls_.size() > Infinitesimal::variables)
      throw std::logic_error("too many balls in one question");
    unsigned own = TiedBalls::levels;
    for (const uint32_t ball : balls_) {
      Infinitesimal weight = GivenWeights<Infinitesimal>(set.balls())(ball);
      for (unsigned level = 0; level < TiedBalls::levels && level < infinitesimals; ++level)
        weight = weight + Infinitesimal(set.growth(level, ball)) * Infinitesimal::epsilon(level);
      if (own < infinitesimals) weight = weight + Infinitesimal::epsilon(own);
      ++own;
      weights_.push_back(weight);
    }
  }
  const Number &operator()(uint32_t ball) const {
    return weights_.at(static_cast<size_t>(std::find(balls_.begin(), balls_.end(), ball) - balls_.begin()));
  }

 private:
  std::vector<uint32_t> balls_;  // by rank
  std::vector<Number> weights_;
};

template <class Number>
Number dot_product(const Vector &a, const Vector &b) {
  return Number(a[0]) * Number(b[0]) + Number(a[1]) * Number(b[1]) + Number(a[2]) * Number(b[2]);
}

template <class Number>
Number determinant(const std::array<std::array<Number, 3>, 3> &m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// g of a cap: |v|^2 + w_a - w_b, or 0 for a plane through the centre.
template <class Weights>
typename Weights::Number offset(const Weights &weight, uint32_t a, const Cap &cap) {
  using Number = typename Weights::Number;
  if (cap.ball == no_ball) return Number(0);
  return dot_product<Number>(cap.normal, cap.normal) + weight(a) - weight(cap.ball);
}

// D = det [[u.u, u.v, g_u], [u.v, v.v, g_v], [g_u, g_v, 4 w_a]] = 4 |u x v|^2 (w_a - |foot|^2), where the foot is the
// point of the plane of u and v on both cap planes: the circles cross where D > 0.
template <class Weights>
typename Weights::Number crossing_determinant(const Weights &weight, uint32_t a, const Cap &first, const Cap &second) {
  using Number = typename Weights::Number;
  const Vector &u = first.normal;
  const Vector &v = second.normal;
  const Number uv = dot_product<Number>(u, v);
  const Number gu = offset(weight, a, first);
  const Number gv = offset(weight, a, second);
  return determinant<Number>(
      {{{dot_product<Number>(u, u), uv, gu}, {uv, dot_product<Number>(v, v), gv}, {gu, gv, Number(4) * weight(a)}}});
}

// Sign of A + side B sqrt(D), D >= 0, by squaring.
template <class Number>
int sign_with_root(const Number &A, const Number &B, const Number &D, int side) {
  const int sign_a = sign_of(A);
  const int sign_b = sign_of(D) > 0 ? side * sign_of(B) : 0;
  if (sign_b == 0 || sign_a == sign_b) return sign_a;
  if (sign_a == 0) return sign_b;
  return sign_a * sign_of(A * A - B * B * D);
}

// The crossing is y = foot + side sqrt(D) / (2 N) u x v, N = |u x v|^2. Solving for the foot by Cramer's rule,
// N (2 z.y - g_z) = A + side B sqrt(D) with A = -det [[u.u, u.v, g_u], [u.v, v.v, g_v], [z.u, z.v, g_z]] and
// B = det [u, v, z].
template <class Weights>
int side_of_crossing(const Weights &weight, uint32_t a, const Crossing &point, const Cap &cap) {
  using Number = typename Weights::Number;
  const Vector &u = point.first.normal;
  const Vector &v = point.second.normal;
  const Vector &z = cap.normal;
  const Number uv = dot_product<Number>(u, v);
  const Number minus_a =
      determinant<Number>({{{dot_product<Number>(u, u), uv, offset(weight, a, point.first)},
                            {uv, dot_product<Number>(v, v), offset(weight, a, point.second)},
                            {dot_product<Number>(z, u), dot_product<Number>(z, v), offset(weight, a, cap)}}});
  std::array<std::array<Number, 3>, 3> rows;
  for (size_t k = 0; k < 3; ++k) rows[k] = {Number(u[k]), Number(v[k]), Number(z[k])};
  return sign_with_root(Number(0) - minus_a, determinant<Number>(rows),
                        crossing_determinant(weight, a, point.first, point.second), point.side);
}

int bit_length(Int128 value) {
  int bits = 0;
  for (Int128 rest = value < 0 ? -value : value; rest != 0; rest >>= 1) ++bits;
  return bits;
}

int bit_length(const Vector &v) {
  return std::max({bit_length(v[0]), bit_length(v[1]), bit_length(v[2])});
}

// Is every number in side_of_crossing certainly below 2^127? With all components and radii below 2^bits, every entry
// of the determinants A and D is below 2^(2 bits + 2), so A and D are below 2^(6 bits + 9) and A^2 - B^2 D below
// 2^(12 bits + 19).
bool fits_128_bits(const Balls &balls, uint32_t a, std::initializer_list<Cap> caps) {
  int bits = bit_length(balls[a].radius);
  for (const Cap &cap : caps) {
    bits = std::max(bits, bit_length(cap.normal));
    if (cap.ball != no_ball) bits = std::max(bits, bit_length(balls[cap.ball].radius));
  }
  return 12 * bits + 19 <= 127;
}

// The sign of a formula for the balls as given.
template <class Formula>
int sign_as_given(const TiedBalls &set, bool fits, const Formula &formula) {
  return fits ? formula(GivenWeights<Int128>(set.balls())) : formula(GivenWeights<BigInteger>(set.balls()));
}

// The sign of a formula for the inflated balls; 0 only if the value is 0 with all infinitesimals. They are added a few
// at a time, until the value is not 0: smaller infinitesimals cannot change its sign any more.
template <class Formula>
int sign_with_ties(const TiedBalls &set, bool fits, std::initializer_list<uint32_t> balls, const Formula &formula) {
  int sign = sign_as_given(set, fits, formula);
  for (const unsigned infinitesimals : {1U, 5U, 6U, Infinitesimal::variables})
    if (sign == 0) sign = formula(InflatedWeights(set, balls, infinitesimals));
  return sign;
}

// The same where inflation must break every tie.
template <class Formula>
bool is_positive(const TiedBalls &set, bool fits, std::initializer_list<uint32_t> balls, const Formula &formula) {
  const int sign = sign_with_ties(set, fits, balls, formula);
  if (sign == 0) throw std::logic_error("a tie that inflation does not break: " + to_text(set.balls()));
  return sign > 0;
}

}  // namespace

Int128 TiedBalls::growth(unsigned level, uint32_t ball) const {
  const Int128 x = balls_[ball].x, y = balls_[ball].y, z = balls_[ball].z, r = balls_[ball].radius;
  const std::array<Int128, levels> amounts = {
      r * r, 1, x, y, z, 1009 * x * x + 757 * x * y + 499 * x * z + 331 * y * y + 211 * y * z + 113 * z * z};
  return amounts[level];
}

PairRelation TiedBalls::pair(uint32_t a, uint32_t b) const {
  const Cap seen_from_a = cap(a, b);
  const Cap seen_from_b = cap(b, a);
  const auto decide = [&](const auto &formula) { return is_positive(*this, false, {a, b}, formula); };
  // The cap plane is at distance g / (2 |v|) from the centre: a proper circle if 4 w_a |v|^2 - g^2 > 0.
  const bool circle = decide([&](const auto &weight) {
    using Number = typename std::decay_t<decltype(weight)>::Number;
    const Number g = offset(weight, a, seen_from_a);
    return sign_of(Number(4) * weight(a) * dot_product<Number>(seen_from_a.normal, seen_from_a.normal) - g * g);
  });
  if (circle) return PairRelation::circle;
  // Without a common circle the sphere of a is wholly inside b or wholly outside: ask for the mean of 2 v.y - g.
  if (!decide([&](const auto &weight) { return sign_of(offset(weight, a, seen_from_a)); }))
    return PairRelation::first_inside_second;
  if (!decide([&](const auto &weight) { return sign_of(offset(weight, b, seen_from_b)); }))
    return PairRelation::second_inside_first;
  return PairRelation::disjoint;
}

bool TiedBalls::circles_cross(uint32_t a, const Cap &first, const Cap &second) const {
  return is_positive(*this, fits_128_bits(balls_, a, {first, second}), {a, first.ball, second.ball},
                     [&](const auto &weight) { return sign_of(crossing_determinant(weight, a, first, second)); });
}

int TiedBalls::circles_cross_as_given(uint32_t a, const Cap &first, const Cap &second) const {
  return sign_as_given(*this, fits_128_bits(balls_, a, {first, second}),
                       [&](const auto &weight) { return sign_of(crossing_determinant(weight, a, first, second)); });
}

bool TiedBalls::circle_inside(uint32_t a, const Cap &circle, const Cap &other) const {
  // 2 z.y - g_z has no zero on the circle, so its mean, the value at the circle's centre g_u / (2 u.u) u, tells.
  return is_positive(*this, fits_128_bits(balls_, a, {circle, other}), {a, circle.ball, other.ball},
                     [&](const auto &weight) {
                       using Number = typename std::decay_t<decltype(weight)>::Number;
                       const Vector &u = circle.normal;
                       const Vector &z = other.normal;
                       return sign_of(dot_product<Number>(z, u) * offset(weight, a, circle) -
                                      dot_product<Number>(u, u) * offset(weight, a, other));
                     });
}

bool TiedBalls::crossing_inside(uint32_t a, const Crossing &point, const Cap &cap) const {
  return is_positive(*this, fits_128_bits(balls_, a, {point.first, point.second, cap}),
                     {a, point.first.ball, point.second.ball, cap.ball},
                     [&](const auto &weight) { return side_of_crossing(weight, a, point, cap); });
}

int TiedBalls::crossing_side(uint32_t a, const Crossing &point, const Vector &normal) const {
  const Cap plane = {normal, no_ball};
  return sign_with_ties(*this, fits_128_bits(balls_, a, {point.first, point.second, plane}),
                        {a, point.first.ball, point.second.ball},
                        [&](const auto &weight) { return side_of_crossing(weight, a, point, plane); });
}

int TiedBalls::crossing_inside_as_given(uint32_t a, const Crossing &point, const Cap &cap) const {
  return sign_as_given(*this, fits_128_bits(balls_, a, {point.first, point.second, cap}),
                       [&](const auto &weight) { return side_of_crossing(weight, a, point, cap); });
}

}  // namespace oracle
