#include "nerve.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace oracle {
namespace {

constexpr int64_t largest_difference = 100;

using Simplex = std::vector<uint32_t>;
// Lexicographic order of simplices. operator< is not used: on big-endian processors libstdc++ 12 compares first bytes
// only.
struct InDictionaryOrder {
  bool operator()(const Simplex &a, const Simplex &b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};
using Matrix = std::vector<std::vector<Int128>>;

// Determinant of a matrix of at most three rows, by the first row.
Int128 determinant(const Matrix &m) {
  if (m.empty()) return 1;
  Int128 sum = 0;
  for (size_t column = 0; column < m.size(); ++column) {
    Matrix minor;
    for (size_t row = 1; row < m.size(); ++row) {
      minor.emplace_back();
      for (size_t k = 0; k < m.size(); ++k)
        if (k != column) minor.back().push_back(m[row][k]);
    }
    const Int128 term = m[0][column] * determinant(minor);
    sum += column % 2 == 0 ? term : -term;
  }
  return sum;
}

enum class Minimum { elsewhere, not_positive, positive };

// Is the minimum over all balls attained at the radical centre of a subset, and is it positive?
Minimum minimum_at_radical_centre(const std::vector<LatticeBall> &balls, const std::vector<LatticeBall> &subset) {
  const LatticeBall &origin = subset.front();
  const Int128 origin_weight = Int128{origin.radius} * origin.radius;
  std::vector<Vector> edges;
  for (size_t m = 1; m < subset.size(); ++m) edges.push_back(centre_difference(origin, subset[m]));

  // The radical centre is c_0 + sum lambda_m v_m with 2 v_k . sum lambda_m v_m = |v_k|^2 + w_0 - w_k for every k.
  Matrix gram(edges.size(), std::vector<Int128>(edges.size()));
  std::vector<Int128> right(edges.size());
  for (size_t k = 0; k < edges.size(); ++k) {
    for (size_t m = 0; m < edges.size(); ++m) gram[k][m] = 2 * dot(edges[k], edges[m]);
    right[k] = dot(edges[k], edges[k]) + origin_weight - Int128{subset[k + 1].radius} * subset[k + 1].radius;
  }
  const Int128 denominator = determinant(gram);
  if (denominator == 0) return Minimum::elsewhere;  // affinely dependent
  Int128 sum = 0;
  Vector centre = {0, 0, 0};  // times the denominator
  for (size_t m = 0; m < edges.size(); ++m) {
    Matrix replaced = gram;
    for (size_t k = 0; k < edges.size(); ++k) replaced[k][m] = right[k];
    const Int128 numerator = determinant(replaced);
    if (numerator < 0) return Minimum::elsewhere;
    sum += numerator;
    for (size_t k = 0; k < 3; ++k) centre[k] += numerator * edges[m][k];
  }
  if (sum > denominator) return Minimum::elsewhere;

  const auto power = [&](const LatticeBall &ball) {  // times the denominator squared
    const Vector to_ball = centre_difference(origin, ball);
    Vector difference;
    for (size_t k = 0; k < 3; ++k) difference[k] = centre[k] - denominator * to_ball[k];
    return dot(difference, difference) - Int128{ball.radius} * ball.radius * denominator * denominator;
  };
  const Int128 value = power(origin);
  for (const LatticeBall &ball : balls)
    if (power(ball) > value) return Minimum::elsewhere;
  return value > 0 ? Minimum::positive : Minimum::not_positive;
}

// Rank modulo 2 of a matrix given by its columns, each the set of its ones.
size_t rank_modulo_2(std::vector<std::set<uint32_t>> columns) {
  std::map<uint32_t, std::set<uint32_t>> by_lowest_one;
  for (std::set<uint32_t> &column : columns) {
    while (!column.empty()) {
      const auto [pivot, is_new] = by_lowest_one.try_emplace(*column.rbegin(), column);
      if (is_new) break;
      for (const uint32_t row : pivot->second)
        if (!column.insert(row).second) column.erase(row);
    }
  }
  return by_lowest_one.size();
}

}  // namespace

bool have_common_point(const std::vector<LatticeBall> &balls) {
  if (balls.size() > 4) throw std::out_of_range("more than four balls");
  for (const LatticeBall &ball : balls)
    for (const Int128 difference : centre_difference(balls.front(), ball))
      if (difference > largest_difference || difference < -largest_difference || ball.radius > largest_difference)
        throw std::out_of_range("balls too large for 128 bits");
  for (unsigned members = 1; members < 1U << balls.size(); ++members) {
    std::vector<LatticeBall> subset;
    for (unsigned k = 0; k < balls.size(); ++k)
      if ((members >> k & 1U) != 0) subset.push_back(balls[k]);
    const Minimum minimum = minimum_at_radical_centre(balls, subset);
    if (minimum != Minimum::elsewhere) return minimum == Minimum::not_positive;
  }
  throw std::logic_error("no minimum: " + to_text(balls));
}

std::array<int64_t, 3> nerve_betti_numbers(const Balls &balls) {
  std::array<std::map<Simplex, uint32_t, InDictionaryOrder>, 4> simplices;
  for (uint32_t i = 0; i < balls.size(); ++i) simplices[0].emplace(Simplex{i}, i);
  std::array<size_t, 5> rank = {0, 0, 0, 0, 0};  // of the boundary map from dimension d to d - 1
  for (size_t d = 1; d < 4; ++d) {
    std::vector<std::set<uint32_t>> boundary_map;
    for (const auto &[lower, number] : simplices[d - 1])
      for (uint32_t next = lower.back() + 1; next < balls.size(); ++next) {
        Simplex simplex = lower;
        simplex.push_back(next);
        std::set<uint32_t> boundary;
        for (size_t k = 0; k <= d; ++k) {
          Simplex facet = simplex;
          facet.erase(facet.begin() + static_cast<ptrdiff_t>(k));
          const auto found = simplices[d - 1].find(facet);
          if (found == simplices[d - 1].end()) break;
          boundary.insert(found->second);
        }
        if (boundary.size() != d + 1) continue;
        std::vector<LatticeBall> members;
        for (const uint32_t i : simplex) members.push_back(balls[i]);
        if (!have_common_point(members)) continue;
        simplices[d].emplace(simplex, static_cast<uint32_t>(simplices[d].size()));
        boundary_map.push_back(boundary);
      }
    rank[d] = rank_modulo_2(boundary_map);
  }
  std::array<int64_t, 3> betti{};
  for (size_t d = 0; d < 3; ++d)
    betti[d] =
        static_cast<int64_t>(simplices[d].size()) - static_cast<int64_t>(rank[d]) - static_cast<int64_t>(rank[d + 1]);
  return betti;
}

}  // namespace oracle
