#include "brute_queries.hpp"

#include <algorithm>
#include <cmath>

#include "big_integer.hpp"

namespace oracle {
namespace {

Int128 squared_distance(const LatticeBall &a, const LatticeBall &b) {
  const Vector difference = centre_difference(a, b);
  return dot(difference, difference);
}

Int128 squared_radius_sum(const LatticeBall &a, const LatticeBall &b) {
  const Int128 sum = Int128{a.radius} + b.radius;
  return sum * sum;
}

// A line's chord in a ball, in units of the parameter t of origin + t direction, with L the length of the direction:
// the chord's middle times L^2, and the square of half the chord times L^4. The square is negative for a line beside
// the ball.
struct Chord {
  BigInteger foot, squared;
};

BigInteger big_dot(const Vector &a, const Vector &b) {
  return BigInteger(a[0]) * BigInteger(b[0]) + BigInteger(a[1]) * BigInteger(b[1]) +
         BigInteger(a[2]) * BigInteger(b[2]);
}

// By the line's distance from the centre.
Chord chord_of(const LatticeBall &ball, const LatticePoint &origin, const LatticePoint &direction) {
  const Vector to_centre = centre_difference(ball_around(origin, 0), ball);
  const Vector along = {direction[0], direction[1], direction[2]};
  const BigInteger length = big_dot(along, along);
  const BigInteger u[3] = {BigInteger(to_centre[0]), BigInteger(to_centre[1]), BigInteger(to_centre[2])};
  const BigInteger d[3] = {BigInteger(along[0]), BigInteger(along[1]), BigInteger(along[2])};
  BigInteger beside;
  for (size_t k = 0; k < 3; ++k) {
    const BigInteger part = u[k] * d[(k + 1) % 3] - u[(k + 1) % 3] * d[k];
    beside = beside + part * part;
  }
  return {big_dot(to_centre, along), BigInteger(Int128{ball.radius} * ball.radius) * length - beside};
}

// Sign of E + sqrt(a).
int sign_with_root(const BigInteger &E, const BigInteger &a) {
  if (E.sign() >= 0) return E.sign() > 0 || a.sign() > 0 ? 1 : 0;
  return (a - E * E).sign();
}

// Sign of the sum of E and a term that is given by its sign and its square.
int sign_with_term(const BigInteger &E, const BigInteger &term_squared, int term_sign) {
  if (E.sign() * term_sign >= 0) return E.sign() != 0 ? E.sign() : term_sign;
  return E.sign() * (E * E - term_squared).sign();
}

bool contains(const LatticeBall &ball, const LatticePoint &point) {
  return squared_distance(ball, ball_around(point, 0)) <= Int128{ball.radius} * ball.radius;
}

}  // namespace

int compare_entries(const LatticeBall &first, const LatticeBall &second, const LatticePoint &origin,
                    const LatticePoint &direction) {
  const Chord a = chord_of(first, origin, direction);
  const Chord b = chord_of(second, origin, direction);
  // (E + sqrt(b)) against sqrt(a), squared if both are positive.
  const BigInteger E = a.foot - b.foot;
  if (const int side = sign_with_root(E, b.squared); side <= 0) return side < 0 || a.squared.sign() > 0 ? -1 : 0;
  const int term_sign = b.squared.sign() == 0 ? 0 : E.sign();
  return sign_with_term(E * E + b.squared - a.squared, BigInteger(4) * E * E * b.squared, term_sign);
}

uint32_t first_on_ray(const Balls &balls, const LatticePoint &origin, const LatticePoint &direction) {
  for (uint32_t i = 0; i < balls.size(); ++i)
    if (contains(balls[i], origin)) return i;
  uint32_t first = no_ball;
  for (uint32_t i = 0; i < balls.size(); ++i) {
    const Chord chord = chord_of(balls[i], origin, direction);
    if (chord.foot.sign() < 0 || chord.squared.sign() < 0) continue;
    if (first == no_ball || compare_entries(balls[i], balls[first], origin, direction) < 0) first = i;
  }
  return first;
}

std::vector<uint32_t> balls_meeting(const Balls &balls, const LatticeBall &query) {
  std::vector<uint32_t> hits;
  for (uint32_t i = 0; i < balls.size(); ++i)
    if (squared_distance(balls[i], query) <= squared_radius_sum(balls[i], query)) hits.push_back(i);
  return hits;
}

std::vector<uint32_t> neighbours(const Balls &balls, uint32_t ball) {
  std::vector<uint32_t> hits = balls_meeting(balls, balls[ball]);
  hits.erase(std::find(hits.begin(), hits.end(), ball));
  return hits;
}

Figures brute_figures(const Balls &balls) {
  Figures figures;
  const size_t n = balls.size();
  const auto [smallest, largest] = std::minmax_element(
      balls.begin(), balls.end(), [](const LatticeBall &a, const LatticeBall &b) { return a.radius < b.radius; });
  figures.zero_radius = n > 0 && smallest->radius == 0;
  figures.no_pair = n < 2 || largest->radius == 0;
  if (n > 0 && !figures.zero_radius)
    figures.k = static_cast<long double>(largest->radius) / static_cast<long double>(smallest->radius);

  std::vector<uint32_t> overlaps(n, 0);
  long double rho = INFINITY;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < i; ++j) {
      const Int128 distance = squared_distance(balls[i], balls[j]);
      if (distance == 0) figures.coincident = true;
      if (distance < squared_radius_sum(balls[i], balls[j])) {
        ++overlaps[i];
        ++overlaps[j];
      }
      const int64_t larger = std::max(balls[i].radius, balls[j].radius);
      if (larger > 0)
        rho = std::min(rho, std::sqrt(static_cast<long double>(distance)) / static_cast<long double>(larger));
    }
  if (!figures.no_pair && !figures.coincident) figures.rho = rho;
  for (const uint32_t count : overlaps) {
    figures.max_overlaps = std::max(figures.max_overlaps, count);
    figures.mean_overlaps += static_cast<long double>(count) / static_cast<long double>(n);
  }
  if (!figures.zero_radius && !figures.coincident && !figures.no_pair)
    figures.neighbour_bound = 216 * std::pow(figures.k / figures.rho, 3.0L);
  return figures;
}

}  // namespace oracle
