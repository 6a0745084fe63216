#include "dual_complex.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "big_integer.hpp"
#include "disjoint_sets.hpp"

namespace oracle {
namespace {

constexpr int64_t largest = int64_t{1} << 20;

using Difference = std::array<int64_t, 3>;

Difference difference(const LatticeBall &from, const LatticeBall &to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

// For differences of at most 2^20 steps no intermediate result exceeds 6 * 2^60.
int64_t triple(const Difference &a, const Difference &b, const Difference &c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

int sign_of_triple(const Difference &a, const Difference &b, const Difference &c) {
  return sign_of(Int128{triple(a, b, c)});
}

BigInteger big(Int128 value) {
  return BigInteger(value);
}

BigInteger determinant(const std::vector<std::vector<BigInteger>> &m) {
  if (m.size() == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The point of the affine hull of three or four affinely independent centres from which their balls have one power.
class RadicalCentre {
 public:
  explicit RadicalCentre(const Balls &members) : origin_(members.front()) {
    // c_0 + sum lambda_m v_m with 2 v_k . sum lambda_m v_m = |v_k|^2 + w_0 - w_k for every k.
    std::vector<Vector> edges;
    for (size_t m = 1; m < members.size(); ++m) edges.push_back(centre_difference(origin_, members[m]));
    std::vector<std::vector<BigInteger>> gram(edges.size(), std::vector<BigInteger>(edges.size()));
    std::vector<BigInteger> right;
    for (size_t k = 0; k < edges.size(); ++k) {
      for (size_t m = 0; m < edges.size(); ++m) gram[k][m] = big(2 * dot(edges[k], edges[m]));
      right.push_back(big(dot(edges[k], edges[k]) + Int128{origin_.radius} * origin_.radius -
                          Int128{members[k + 1].radius} * members[k + 1].radius));
    }
    denominator_ = determinant(gram);
    for (size_t m = 0; m < edges.size(); ++m) {
      std::vector<std::vector<BigInteger>> replaced = gram;
      for (size_t k = 0; k < edges.size(); ++k) replaced[k][m] = right[k];
      const BigInteger lambda = determinant(replaced);
      for (size_t k = 0; k < 3; ++k) centre_[k] = centre_[k] + lambda * big(edges[m][k]);
    }
  }

  // |x - c|^2 - r^2 at the radical centre x, times the square of a common denominator.
  [[nodiscard]] BigInteger power(const LatticeBall &ball) const {
    const Vector to_ball = centre_difference(origin_, ball);
    BigInteger sum = -(big(Int128{ball.radius} * ball.radius) * denominator_ * denominator_);
    for (size_t k = 0; k < 3; ++k) {
      const BigInteger difference = centre_[k] - denominator_ * big(to_ball[k]);
      sum = sum + difference * difference;
    }
    return sum;
  }

  [[nodiscard]] BigInteger own_power() const { return power(origin_); }

 private:
  LatticeBall origin_;
  BigInteger denominator_;
  std::array<BigInteger, 3> centre_;
};

// The triangle that a tetrahedron has opposite one of its balls; ascending, as the four are.
std::array<uint32_t, 3> without(const std::array<uint32_t, 4> &balls, size_t left_out) {
  std::array<uint32_t, 3> triangle{};
  for (size_t k = 0, place = 0; k < 4; ++k)
    if (k != left_out) triangle[place++] = balls[k];
  return triangle;
}

}  // namespace

DualComplex::DualComplex(Balls balls) : balls_(std::move(balls)) {
  for (const LatticeBall &ball : balls_)
    for (const Int128 difference : centre_difference(balls_.front(), ball))
      if (difference > largest / 2 || difference < -largest / 2 || ball.radius > largest)
        throw std::out_of_range("balls too large for 128 bits");
  find_tetrahedra();
  join_cells();
}

int DualComplex::orientation(const std::array<uint32_t, 4> &balls) const {
  const LatticeBall &last = balls_[balls[3]];
  return sign_of_triple(difference(last, balls_[balls[0]]), difference(last, balls_[balls[1]]),
                        difference(last, balls_[balls[2]]));
}

// Does a ball have a smaller power at the tetrahedron's radical centre than its own four? With the weights r^2
// inflated by eps_0 >> eps_1 >> ... there is always an answer.
bool DualComplex::conflicts(const std::array<uint32_t, 4> &tetrahedron, int orientation, uint32_t ball) const {
  std::array<Difference, 4> row;
  for (size_t k = 0; k < 4; ++k) row[k] = difference(balls_[ball], balls_[tetrahedron[k]]);
  // The determinant of the rows (v, |v|^2 - w + w_ball), by its last column.
  const std::array<int64_t, 4> cofactor = {-triple(row[1], row[2], row[3]), triple(row[0], row[2], row[3]),
                                           -triple(row[0], row[1], row[3]), triple(row[0], row[1], row[2])};
  const int64_t own_radius = balls_[ball].radius;
  Int128 value = 0;
  for (size_t k = 0; k < 4; ++k) {
    const int64_t radius = balls_[tetrahedron[k]].radius;
    value += Int128{cofactor[k]} * (row[k][0] * row[k][0] + row[k][1] * row[k][1] + row[k][2] * row[k][2] -
                                    radius * radius + own_radius * own_radius);
  }
  if (value != 0) return sign_of(value) * orientation > 0;

  std::vector<std::pair<uint32_t, Int128>> terms = {{ball, 0}};  // of the infinitesimals
  for (size_t k = 0; k < 4; ++k) {
    terms.front().second += cofactor[k];
    terms.emplace_back(tetrahedron[k], -Int128{cofactor[k]});
  }
  std::sort(terms.begin(), terms.end());
  for (const auto &[index, coefficient] : terms)
    if (coefficient != 0) return sign_of(coefficient) * orientation > 0;
  throw std::logic_error("a flat tetrahedron");
}

bool DualComplex::is_empty(const std::array<uint32_t, 4> &tetrahedron) const {
  const int side = orientation(tetrahedron);
  if (side == 0) return false;
  for (uint32_t e = 0; e < balls_.size(); ++e)
    if (std::find(tetrahedron.begin(), tetrahedron.end(), e) == tetrahedron.end() && conflicts(tetrahedron, side, e))
      return false;
  return true;
}

// A first tetrahedron: some ball and three of the 24 centres nearest to its own (itself among them). Up to 24 balls all
// sets of four are tried so.
std::optional<std::array<uint32_t, 4>> DualComplex::find_first() const {
  constexpr size_t nearest = 24;
  std::vector<uint32_t> order(balls_.size());
  std::iota(order.begin(), order.end(), 0U);
  for (uint32_t a = 0; a < balls_.size(); ++a) {
    const auto squared_distance = [&](uint32_t i) {
      const Vector v = centre_difference(balls_[a], balls_[i]);
      return dot(v, v);
    };
    const size_t count = std::min(nearest, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<ptrdiff_t>(count), order.end(),
                      [&](uint32_t i, uint32_t k) { return squared_distance(i) < squared_distance(k); });
    for (size_t b = 0; b < count; ++b)
      for (size_t c = b + 1; c < count; ++c)
        for (size_t d = c + 1; d < count; ++d) {
          const std::array<uint32_t, 4> found = {a, order[b], order[c], order[d]};
          if (is_empty(found)) return found;
        }
  }
  return std::nullopt;
}

// The ball that makes a tetrahedron of the triangulation with a triangle, on the side away from a fourth ball: no other
// ball of that side is in conflict with the tetrahedron. Nothing if the triangle is on the hull.
std::optional<uint32_t> DualComplex::beyond(const std::array<uint32_t, 3> &triangle, uint32_t opposite) const {
  const std::array<uint32_t, 4> known = {triangle[0], triangle[1], triangle[2], opposite};
  const int side = -orientation(known);
  std::optional<uint32_t> best;
  for (uint32_t e = 0; e < balls_.size(); ++e) {
    if (orientation({triangle[0], triangle[1], triangle[2], e}) != side) continue;
    if (!best || conflicts({triangle[0], triangle[1], triangle[2], *best}, side, e)) best = e;
  }
  return best;
}

// From the first tetrahedron across triangle after triangle to all others.
void DualComplex::find_tetrahedra() {
  const auto first = find_first();
  if (!first) {
    // All centres lie in a plane, or too many of them in one place.
    const Balls &b = balls_;
    for (size_t i = 0; i + 3 < b.size(); ++i)
      for (size_t k = i + 1; k + 2 < b.size(); ++k)
        for (size_t m = k + 1; m + 1 < b.size(); ++m)
          for (size_t n = m + 1; n < b.size(); ++n)
            if (orientation({static_cast<uint32_t>(i), static_cast<uint32_t>(k), static_cast<uint32_t>(m),
                             static_cast<uint32_t>(n)}) != 0)
              throw std::logic_error("no first tetrahedron found");
    return;
  }
  std::map<std::array<uint32_t, 3>, int> sides_seen;
  std::vector<std::array<uint32_t, 4>> to_visit = {*first};
  std::set<std::array<uint32_t, 4>> seen;
  std::sort(to_visit.front().begin(), to_visit.front().end());
  seen.insert(to_visit.front());
  while (!to_visit.empty()) {
    const std::array<uint32_t, 4> members = to_visit.back();
    to_visit.pop_back();
    const RadicalCentre centre({balls_[members[0]], balls_[members[1]], balls_[members[2]], balls_[members[3]]});
    tetrahedra_.push_back({members, centre.own_power().sign() <= 0, 0});
    for (size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<uint32_t, 3> triangle = without(members, left_out);
      if (++sides_seen[triangle] > 1) continue;  // both its tetrahedra are known
      const auto ball = beyond(triangle, members[left_out]);
      if (!ball) continue;
      std::array<uint32_t, 4> next = {triangle[0], triangle[1], triangle[2], *ball};
      std::sort(next.begin(), next.end());
      if (seen.insert(next).second) to_visit.push_back(next);
    }
  }
}

void DualComplex::join_cells() {
  // The tetrahedra on both sides of each triangle.
  struct Sides {
    std::vector<size_t> tetrahedra;
    std::vector<uint32_t> opposite;
  };
  std::map<std::array<uint32_t, 3>, Sides> triangles;
  for (size_t t = 0; t < tetrahedra_.size(); ++t)
    for (size_t left_out = 0; left_out < 4; ++left_out) {
      Sides &sides = triangles[without(tetrahedra_[t].ball, left_out)];
      sides.tetrahedra.push_back(t);
      sides.opposite.push_back(tetrahedra_[t].ball[left_out]);
    }

  DisjointSets sets(tetrahedra_.size() + 1);
  const size_t outside = 0;
  for (const auto &[triangle, sides] : triangles) {
    if (sides.tetrahedra.size() > 2) throw std::logic_error("three tetrahedra at one triangle");
    if (sides.tetrahedra.size() == 1) hull_.insert(triangle.begin(), triangle.end());
    bool closed = false;
    for (const size_t t : sides.tetrahedra) closed = closed || tetrahedra_[t].in_complex;
    if (closed && sides.tetrahedra.size() == 2) continue;
    if (!closed) {
      // The triangle is closed by itself if its balls meet at their radical centre and no other ball has less power
      // there. If any ball has, one of the two opposite the triangle has. (In a tie its tetrahedron has the same
      // radical centre.)
      const RadicalCentre centre({balls_[triangle[0]], balls_[triangle[1]], balls_[triangle[2]]});
      const BigInteger power = centre.own_power();
      closed = power.sign() <= 0;
      for (const uint32_t ball : sides.opposite) closed = closed && (centre.power(balls_[ball]) - power).sign() >= 0;
    }
    if (closed) continue;
    sets.join(sides.tetrahedra[0] + 1, sides.tetrahedra.size() == 2 ? sides.tetrahedra[1] + 1 : outside);
  }

  std::map<size_t, uint32_t> number = {{outside, 0}};
  for (size_t t = 0; t < tetrahedra_.size(); ++t) {
    if (tetrahedra_[t].in_complex) continue;
    const auto next = static_cast<uint32_t>(number.size());
    tetrahedra_[t].cell = number.try_emplace(sets.find(t + 1), next).first->second;
  }
  cells_ = static_cast<uint32_t>(number.size());
}

// Whether a point is in a tetrahedron, boundary included.
bool DualComplex::contains(const Tetrahedron &tetrahedron, const LatticeBall &point) const {
  std::array<Difference, 4> corner;
  for (size_t k = 0; k < 4; ++k) corner[k] = difference(point, balls_[tetrahedron.ball[k]]);
  const std::array<int, 4> side = {
      sign_of_triple(corner[1], corner[2], corner[3]), -sign_of_triple(corner[0], corner[2], corner[3]),
      sign_of_triple(corner[0], corner[1], corner[3]), -sign_of_triple(corner[0], corner[1], corner[2])};
  return std::none_of(side.begin(), side.end(), [](int s) { return s < 0; }) ||
         std::none_of(side.begin(), side.end(), [](int s) { return s > 0; });
}

uint32_t DualComplex::cell_of(int64_t x, int64_t y, int64_t z) const {
  const LatticeBall point = {x, y, z, 0};
  for (const LatticeBall &ball : balls_) {
    const Vector difference = centre_difference(ball, point);
    if (dot(difference, difference) <= Int128{ball.radius} * ball.radius)
      throw std::domain_error("a point of the union");
  }
  if (tetrahedra_.empty()) return 0;
  for (const Int128 d : centre_difference(balls_.front(), point))
    if (d > largest / 2 || d < -largest / 2) return 0;  // beyond all centres
  bool in_hull = false;
  for (const Tetrahedron &tetrahedron : tetrahedra_) {
    if (!contains(tetrahedron, point)) continue;
    if (!tetrahedron.in_complex) return tetrahedron.cell;
    in_hull = true;
  }
  if (in_hull) throw std::logic_error("a free point in the dual complex");
  return 0;
}

std::vector<uint32_t> DualComplex::balls_around(uint32_t cell) const {
  std::set<uint32_t> around;
  if (cell == 0) {
    around = hull_;
    for (uint32_t i = 0; tetrahedra_.empty() && i < balls_.size(); ++i) around.insert(i);
  }
  for (const Tetrahedron &tetrahedron : tetrahedra_)
    if (!tetrahedron.in_complex && tetrahedron.cell == cell)
      around.insert(tetrahedron.ball.begin(), tetrahedron.ball.end());
  return {around.begin(), around.end()};
}

}  // namespace oracle
