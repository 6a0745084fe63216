#include "power_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "big_integer.hpp"
#include "brute_boundary.hpp"
#include "sphere_predicates.hpp"

namespace oracle {
namespace {

using Four = std::array<uint32_t, 4>;

Int128 triple(const Vector &a, const Vector &b, const Vector &c) {
  return dot(cross(a, b), c);
}

// Has a fifth ball less power than four balls at the point where the four have equal power? The sign is that of the
// determinant of the rows (v, |v|^2 - w + w_fifth), expanded by its last column. If it is 0, its derivatives by the
// weights decide, in the order of the infinitesimals.
bool is_nearer(const TiedBalls &set, const Four &four, uint32_t fifth) {
  const Balls &balls = set.balls();
  std::array<Vector, 4> row;
  for (size_t k = 0; k < 4; ++k) row[k] = centre_difference(balls[fifth], balls[four[k]]);
  const std::array<Int128, 4> cofactor = {-triple(row[1], row[2], row[3]), triple(row[0], row[2], row[3]),
                                          -triple(row[0], row[1], row[3]), triple(row[0], row[1], row[2])};
  // The orientation of the four centres, seen from the last one.
  const int orientation = sign_of(cofactor[0] + cofactor[1] + cofactor[2] + cofactor[3]);
  if (orientation == 0) throw std::logic_error("a flat tetrahedron");
  const auto weight = [&](uint32_t ball) { return Int128{balls[ball].radius} * balls[ball].radius; };
  Int128 value = 0;
  for (size_t k = 0; k < 4; ++k) value += cofactor[k] * (dot(row[k], row[k]) - weight(four[k]) + weight(fifth));
  if (value != 0) return sign_of(value) * orientation > 0;
  for (unsigned level = 0; level < TiedBalls::levels; ++level) {
    BigInteger sum;
    for (size_t k = 0; k < 4; ++k)
      sum = sum + BigInteger(cofactor[k]) * BigInteger(set.growth(level, fifth) - set.growth(level, four[k]));
    if (sum.sign() != 0) return sum.sign() * orientation > 0;
  }
  std::vector<std::pair<uint32_t, Int128>> terms = {
      {set.rank(fifth), cofactor[0] + cofactor[1] + cofactor[2] + cofactor[3]}};
  for (size_t k = 0; k < 4; ++k) terms.emplace_back(set.rank(four[k]), -cofactor[k]);
  std::sort(terms.begin(), terms.end());
  for (const auto &[rank, coefficient] : terms)
    if (coefficient != 0) return sign_of(coefficient) * orientation > 0;
  throw std::logic_error("undecided");
}

// Whether the point of equal power of four balls lies in them: just one of the two points of three spheres is in the
// fourth.
bool has_inner_vertex(const TiedBalls &set, const Four &four) {
  for (size_t k = 0; k < 4; ++k)
    for (size_t m = k + 1; m < 4; ++m)
      if (set.pair(four[k], four[m]) != PairRelation::circle) return false;
  const Cap P = set.cap(four[0], four[1]);
  const Cap Q = set.cap(four[0], four[2]);
  const Cap R = set.cap(four[0], four[3]);
  if (!set.circles_cross(four[0], P, Q)) return false;
  return set.crossing_inside(four[0], {P, Q, +1}, R) != set.crossing_inside(four[0], {P, Q, -1}, R);
}

template <size_t n>
std::array<uint32_t, n - 1> without(const std::array<uint32_t, n> &balls, size_t left_out) {
  std::array<uint32_t, n - 1> result{};
  for (size_t k = 0, place = 0; k < n; ++k)
    if (k != left_out) result[place++] = balls[k];
  return result;
}

struct Real3 {
  double x, y, z;
};

double power(const LatticeBall &ball, const Real3 &at) {
  const double x = at.x - static_cast<double>(ball.x);
  const double y = at.y - static_cast<double>(ball.y);
  const double z = at.z - static_cast<double>(ball.z);
  return x * x + y * y + z * z - static_cast<double>(ball.radius) * static_cast<double>(ball.radius);
}

}  // namespace

DualSimplices dual_simplices(const Balls &balls) {
  const BoundaryRecord boundary = brute_boundary(balls);
  const TiedBalls set(balls);
  DualSimplices result;
  for (const BoundaryRecord::Face &face : boundary.faces) result.balls.insert(face.ball);
  for (const BoundaryRecord::Circle &circle : boundary.circles) result.edges.insert(circle.ball);
  for (const BoundaryRecord::Vertex &vertex : boundary.vertices) result.triangles.insert(vertex.ball);
  const uint32_t n = set.size();
  for (uint32_t a = 0; a < n; ++a)
    for (uint32_t b = a + 1; b < n; ++b)
      for (uint32_t c = b + 1; c < n; ++c)
        for (uint32_t d = c + 1; d < n; ++d) {
          const Four four = {a, b, c, d};
          if (!has_inner_vertex(set, four)) continue;
          bool is_empty = true;
          for (uint32_t e = 0; e < n && is_empty; ++e)
            is_empty = std::find(four.begin(), four.end(), e) != four.end() || !is_nearer(set, four, e);
          if (is_empty) result.tetrahedra.insert(four);
        }
  for (const auto &tetrahedron : result.tetrahedra)
    for (size_t k = 0; k < 4; ++k) result.triangles.insert(without(tetrahedron, k));
  for (const auto &triangle : result.triangles)
    for (size_t k = 0; k < 3; ++k) result.edges.insert(without(triangle, k));
  for (const auto &edge : result.edges) result.balls.insert(edge.begin(), edge.end());
  return result;
}

double contact_area_by_slices(const Balls &balls, uint32_t a, uint32_t b, uint32_t slices) {
  const LatticeBall &first = balls[a];
  const Vector exact = centre_difference(first, balls[b]);
  const Real3 v{static_cast<double>(exact[0]), static_cast<double>(exact[1]), static_cast<double>(exact[2])};
  const double d = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const Real3 u{v.x / d, v.y / d, v.z / d};
  const double r = static_cast<double>(first.radius);
  const double other = static_cast<double>(balls[b].radius);
  const double height = (d * d + r * r - other * other) / (2 * d);
  const double radius = std::sqrt(std::max(0.0, r * r - height * height));
  const Real3 centre{static_cast<double>(first.x) + height * u.x, static_cast<double>(first.y) + height * u.y,
                     static_cast<double>(first.z) + height * u.z};
  // Two directions across the axis.
  const Real3 away = std::fabs(u.x) < 0.6 ? Real3{1, 0, 0} : Real3{0, 1, 0};
  const double along = away.x * u.x + away.y * u.y + away.z * u.z;
  Real3 s{away.x - along * u.x, away.y - along * u.y, away.z - along * u.z};
  const double length = std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
  s = {s.x / length, s.y / length, s.z / length};
  const Real3 t{u.y * s.z - u.z * s.y, u.z * s.x - u.x * s.z, u.x * s.y - u.y * s.x};

  constexpr double pi = 3.14159265358979323846;
  double area = 0;
  for (uint32_t k = 0; k < slices; ++k) {
    // Across by the sine of an angle, so that the widths have no steep ends.
    const double angle = (k + 0.5) * pi / slices - pi / 2;
    const double across = radius * std::sin(angle);
    const Real3 foot{centre.x + across * s.x, centre.y + across * s.y, centre.z + across * s.z};
    double low = -radius * std::cos(angle);
    double high = -low;
    for (uint32_t l = 0; l < balls.size(); ++l) {
      if (l == a || l == b) continue;
      // The difference of powers is linear along the slice.
      const double at_foot = power(balls[l], foot) - power(first, foot);
      const Vector w = centre_difference(balls[l], first);
      const double slope =
          2 * (static_cast<double>(w[0]) * t.x + static_cast<double>(w[1]) * t.y + static_cast<double>(w[2]) * t.z);
      if (std::fabs(slope) < 1e-12 * d) {
        if (at_foot < 0) high = low;
      } else if (slope > 0) {
        low = std::max(low, -at_foot / slope);
      } else {
        high = std::min(high, -at_foot / slope);
      }
    }
    if (high > low) area += (high - low) * radius * std::cos(angle) * pi / slices;
  }
  return area;
}

std::vector<double> cell_volumes_by_points(const Balls &balls, uint32_t points) {
  std::vector<double> volumes(balls.size());
  for (size_t i = 0; i < balls.size(); ++i) {
    const LatticeBall &own = balls[i];
    const double step = 2.0 * static_cast<double>(own.radius) / points;
    const auto place = [&](int64_t centre, uint32_t k) {
      return static_cast<double>(centre) - static_cast<double>(own.radius) + (k + 0.5) * step;
    };
    std::vector<double> powers(balls.size());
    uint64_t inside = 0;
    for (uint32_t x = 0; x < points; ++x)
      for (uint32_t y = 0; y < points; ++y)
        for (uint32_t z = 0; z < points; ++z) {
          const Real3 at{place(own.x, x), place(own.y, y), place(own.z, z)};
          // By one piece of code: fused instructions in one of two would make equal balls differ.
          for (size_t k = 0; k < balls.size(); ++k) powers[k] = power(balls[k], at);
          const double least = powers[i];
          bool is_own = least <= 0;
          for (size_t k = 0; k < balls.size() && is_own; ++k) {
            // Of two equal balls the first one has the cell.
            is_own = least < powers[k] || (least == powers[k] && i <= k);
          }
          inside += is_own ? 1 : 0;
        }
    volumes[i] = static_cast<double>(inside) * step * step * step;
  }
  return volumes;
}

}  // namespace oracle
