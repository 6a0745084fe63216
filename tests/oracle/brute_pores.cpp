#include "brute_pores.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

#include "big_integer.hpp"

namespace oracle {
namespace {

constexpr size_t most_balls = 16, most_edges = most_balls * (most_balls - 1) / 2;
size_t edge(uint32_t i, uint32_t j) {
  return j * (j - 1) / 2 + i;
}
struct Triangle {
  std::array<uint32_t, 3> ball;
  size_t level;
};
using Chain = std::bitset<most_edges *(most_balls - 2) / 3>;  // of triangles by their places in a list

BigInteger product(const Vector &p, const Vector &q) {
  BigInteger sum;
  for (size_t k = 0; k < 3; ++k) sum = sum + BigInteger(p[k]) * BigInteger(q[k]);
  return sum;
}

// Sign of a + b sqrt(D).
int surd_sign(const BigInteger &a, const BigInteger &b, const BigInteger &D) {
  if (a.sign() * b.sign() >= 0) return a.sign() != 0 ? a.sign() : b.sign() * D.sign();
  return a.sign() * (a * a - b * b * D).sign();
}

// The point x in the convex hull of two to four centres that is equally far from their balls. Let c be the first
// centre, and C_i and e_i the differences of the other centres and radii from the first. With x = c + sum m_i C_i and
// the distance s = |x - c|,
//   2 C_i.(x - c) + 2 e_i s = |C_i|^2 - e_i^2 = w_i for every i.
// Gram's matrix of the C_i gives m = (alpha - 2 eta s) / (2 det), and |x - c|^2 = s^2 becomes a quadratic equation in
// s. The level of the point is its distance from the balls, s less the first radius.
class HullPoint {
 public:
  HullPoint(const Balls &balls, const std::vector<uint32_t> &ids) : balls_(&balls), ids_(ids) {
    // For two or three balls rows of the unit matrix fill the matrix up.
    BigInteger G[3][3];
    const size_t rows = ids.size() - 1;
    for (size_t i = 0; i < 3; ++i) {
      if (i < rows) {
        C_[i] = centre_difference(first(), balls[ids[i + 1]]);
        e_[i] = Int128{balls[ids[i + 1]].radius} - first().radius;
        w_[i] = dot(C_[i], C_[i]) - e_[i] * e_[i];
      }
      for (size_t j = 0; j <= i; ++j) G[i][j] = G[j][i] = BigInteger(i < rows ? dot(C_[i], C_[j]) : Int128{i == j});
    }
    BigInteger c, e_eta, e_alpha;
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = 0; j < 3; ++j) {
        const size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const BigInteger cofactor = G[i1][j1] * G[i2][j2] - G[i1][j2] * G[i2][j1];
        alpha_[i] = alpha_[i] + cofactor * BigInteger(w_[j]);
        eta_[i] = eta_[i] + cofactor * BigInteger(e_[j]);
        if (i == 0) det_ = det_ + cofactor * G[0][j];
      }
      c = c + alpha_[i] * BigInteger(w_[i]);
      e_alpha = e_alpha + alpha_[i] * BigInteger(e_[i]);
      e_eta = e_eta + eta_[i] * BigInteger(e_[i]);
    }
    if (det_.sign() == 0) return;
    a_ = BigInteger(4) * (e_eta - det_);
    b_ = BigInteger(-2) * e_alpha;
    c_ = c;
    D_ = b_ * b_ - a_ * c_;
    // Both roots are tried.
    for (const int root : {-1, 1}) {
      if (D_.sign() < 0 || there_) break;
      if (a_.sign() != 0) {
        d_ = a_;
        p_ = -b_;
        q_ = BigInteger(root);
      } else {
        d_ = BigInteger(2) * b_;
        p_ = -c_;
        q_ = BigInteger();
      }
      if (d_.sign() == 0) break;
      if (d_.sign() < 0) {
        d_ = -d_;
        p_ = -p_;
        q_ = -q_;
      }
      there_ = is_in_hull();
    }
  }

  // Whether there is such a point, within the hull or on its boundary.
  bool there() const { return there_; }
  // Sign of (the point's distance from a further ball - the point's level).
  int nearness(uint32_t ball) const {
    const LatticeBall &other = (*balls_)[ball];
    const Vector C = centre_difference(first(), other);
    const Int128 e = Int128{other.radius} - first().radius;
    BigInteger constant = det_ * BigInteger(dot(C, C) - e * e), slope = -(det_ * BigInteger(e));
    for (size_t j = 0; j < 3; ++j) {
      const BigInteger along(dot(C, C_[j]));
      constant = constant - alpha_[j] * along;
      slope = slope + eta_[j] * along;
    }
    return sign(constant, BigInteger(2) * slope);
  }
  // On which side of a plane the point lies: +1 where the normal points to. The plane goes through a ball's centre.
  int side(const Vector &normal, uint32_t through) const {
    BigInteger constant = -(det_ * product(normal, centre_difference(first(), (*balls_)[through]))), slope;
    constant = constant + constant;
    for (size_t j = 0; j < 3; ++j) {
      const BigInteger along = product(normal, C_[j]);
      constant = constant + alpha_[j] * along;
      slope = slope - eta_[j] * along;
    }
    return sign(constant, BigInteger(2) * slope);
  }
  // Sign of (this point's level - another point's level); `against` takes an integer level in place of the other one.
  int compare(const HullPoint &other) const {
    const Int128 shift = Int128{other.first().radius} - first().radius;
    // (p + q sqrt(D)) / d - (P + Q sqrt(E)) / F + shift: the part of sqrt(E) last.
    const BigInteger constant = p_ * other.d_ - other.p_ * d_ + BigInteger(shift) * d_ * other.d_;
    const BigInteger own = q_ * other.d_, others = -(other.q_ * d_);
    const int left = surd_sign(constant, own, D_), right = others.sign() * other.D_.sign();
    if (left * right >= 0) return left != 0 ? left : right;
    const BigInteger squares = constant * constant + own * own * D_ - others * others * other.D_;
    return left * surd_sign(squares, BigInteger(2) * constant * own, D_);
  }
  int against(int64_t level) const { return sign(BigInteger(-(Int128{first().radius} + level)), BigInteger(1)); }
  const std::vector<uint32_t> &ids() const { return ids_; }

 private:
  const LatticeBall &first() const { return (*balls_)[ids_[0]]; }
  // Sign of constant + slope s.
  int sign(const BigInteger &constant, const BigInteger &slope) const {
    return surd_sign(constant * d_ + slope * p_, slope * q_, D_);
  }
  bool is_in_hull() const {
    if (sign(BigInteger(), BigInteger(1)) <= 0) return false;
    const BigInteger minus_two(-2), two(2);
    BigInteger rest = two * det_, slope;
    for (size_t i = 0; i + 1 < ids_.size(); ++i) {
      if (sign(BigInteger(e_[i]), BigInteger(1)) <= 0 || sign(alpha_[i], minus_two * eta_[i]) < 0) return false;
      rest = rest - alpha_[i];
      slope = slope + two * eta_[i];
    }
    return sign(rest, slope) >= 0;
  }

  const Balls *balls_;
  std::vector<uint32_t> ids_;
  Vector C_[3]{};
  Int128 e_[3]{}, w_[3]{};
  BigInteger alpha_[3], eta_[3], det_, a_, b_, c_;
  BigInteger p_, q_, D_, d_;  // s = (p + q sqrt(D)) / d
  bool there_ = false;
};

// The dimension, 2 or 3, of the convex hull of the tied balls' centres if the point is in the hull's relative interior,
// else 0.
int dimension_around(const Balls &balls, const HullPoint &point, const std::vector<uint32_t> &tied) {
  const auto from = [&](uint32_t i, uint32_t j) { return centre_difference(balls[i], balls[j]); };
  // Whether this plane does not support the hull at the point. A supporting plane goes through the point, and has no
  // centre on one side and at least one centre on the other.
  const auto is_inside = [&](const Vector &normal, uint32_t through) {
    bool above = false, below = false;
    for (const uint32_t ball : tied) {
      const int side = product(normal, from(through, ball)).sign();
      above = above || side > 0;
      below = below || side < 0;
    }
    return above == below || point.side(normal, through) != 0;
  };
  Vector plane{};
  bool solid = false, inside = true;
  for (const uint32_t i : tied) {
    for (const uint32_t j : tied) {
      for (const uint32_t k : tied) {
        if (!(i < j && j < k) || is_zero(cross(from(i, j), from(i, k)))) continue;
        plane = cross(from(i, j), from(i, k));
        for (const uint32_t l : tied) solid = solid || dot(plane, from(i, l)) != 0;
        inside = inside && is_inside(plane, i);
      }
    }
  }
  if (is_zero(plane)) return 0;
  if (solid) return inside ? 3 : 0;
  for (const uint32_t i : tied) {
    for (const uint32_t j : tied) {
      if (i < j && !is_inside(cross(plane, from(i, j)), i)) return 0;
    }
  }
  return 2;
}

// Whether a ray from a point crosses the triangle of three centres; no answer if it meets an edge or lies in the plane.
std::optional<bool> crosses(const Balls &balls, const HullPoint &point, const std::array<uint32_t, 3> &triangle,
                            const Vector &ray) {
  const auto side_of = [&](size_t i, size_t j) { return centre_difference(balls[triangle[i]], balls[triangle[j]]); };
  const Vector normal = cross(side_of(0, 1), side_of(0, 2));
  if (is_zero(normal)) return false;
  const int ahead = product(normal, ray).sign(), side = point.side(normal, triangle[0]);
  if (ahead == 0 && side == 0) return {};
  if (side != -ahead || ahead == 0) return false;
  bool left = false, right = false, on = false;
  for (size_t k = 0; k < 3; ++k) {
    const int turn = point.side(cross(side_of(k, (k + 1) % 3), ray), triangle[k]);
    left = left || turn > 0;
    right = right || turn < 0;
    on = on || turn == 0;
  }
  if (left && right) return false;
  if (on) return {};
  return true;
}

// The points of all sets of two to four balls that have one, ordered by level, the highest first. The level of a set is
// the growth at which its balls first have a common point. For a set that has a point it is the point's level, for any
// other set the level of one of its subsets.
struct RankedPoints {
  RankedPoints(const Balls &outer, int64_t above) {
    const auto n = static_cast<uint32_t>(outer.size());
    const auto add = [&](const std::vector<uint32_t> &ids) {
      HullPoint point(outer, ids);
      if (point.there()) points.push_back(std::move(point));
    };
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t j = i + 1; j < n; ++j) {
        add({i, j});
        for (uint32_t k = j + 1; k < n; ++k) {
          add({i, j, k});
          for (uint32_t l = k + 1; l < n; ++l) add({i, j, k, l});
        }
      }
    }
    std::sort(points.begin(), points.end(), [](const HullPoint &a, const HullPoint &b) { return a.compare(b) > 0; });
    floor = points.size();
    for (size_t p = 0, level = 0; p < points.size(); ++p) {
      if (points[p].compare(points[level]) != 0) level = p;
      rank[points[p].ids()] = level;
      if (floor == points.size() && points[p].against(above) <= 0) floor = level;
    }
  }
  // All triangles of n balls, the lowest level first. A triangle that has no point has the level of its highest edge.
  std::vector<Triangle> triangles(uint32_t n) const {
    std::vector<Triangle> all;
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t j = i + 1; j < n; ++j) {
        for (uint32_t k = j + 1; k < n; ++k) {
          const auto own = rank.find({i, j, k});
          all.push_back(
              {{i, j, k},
               own != rank.end() ? own->second : std::min({rank.at({i, j}), rank.at({i, k}), rank.at({j, k})})});
        }
      }
    }
    std::sort(all.begin(), all.end(), [](const Triangle &a, const Triangle &b) { return a.level > b.level; });
    return all;
  }

  std::vector<HullPoint> points;
  std::map<std::vector<uint32_t>, size_t> rank;
  size_t floor;  // the first rank whose level is not greater than `above`
};

// Which of the triangles whose level is below the point's a ray from the point crosses.
Chain crossed_triangles(const Balls &balls, const HullPoint &point, size_t level,
                        const std::vector<Triangle> &triangles) {
  const Vector rays[] = {{7919, 104729, 611953}, {-600011, 154858, 860281}, {982451, -324528, 499797}};
  for (const Vector &ray : rays) {
    Chain crossed;
    bool generic = true;
    for (size_t t = 0; t < triangles.size() && triangles[t].level > level && generic; ++t) {
      const std::optional<bool> once = crosses(balls, point, triangles[t].ball, ray);
      generic = once.has_value();
      crossed[t] = once.value_or(false);
    }
    if (generic) return crossed;
  }
  std::abort();
}

// Two points are apart for a probe if some closed surface within the balls, grown by the probe, has one of the points
// inside and the other outside. The nerve of the balls has the homology of their union, and the convex hulls of the
// nerve's sets lie in the union: so it is enough to look at cycles of triangles of the nerve. This visits the cycles
// with which new homology classes appear as the balls grow, each with its level, the lowest first.
template <class Visit>
void visit_cycles(const std::vector<Triangle> &triangles, const Visit &visit) {
  struct Column {
    std::bitset<most_edges> edges;
    Chain chain;
  };
  std::vector<Column> reduced(most_edges);  // by their first edges
  for (size_t t = 0; t < triangles.size(); ++t) {
    Column column;
    const auto &[i, j, k] = triangles[t].ball;
    column.edges.flip(edge(i, j)).flip(edge(i, k)).flip(edge(j, k));
    column.chain.set(t);
    for (size_t e = 0; e < most_edges; ++e) {
      if (!column.edges[e]) continue;
      if (reduced[e].edges.none()) {
        reduced[e] = column;
        break;
      }
      column.edges ^= reduced[e].edges;
      column.chain ^= reduced[e].chain;
    }
    if (column.edges.none()) visit(column.chain, triangles[t].level);
  }
}

// Sign of (the distance from the middle of the gap between balls i and j to a third ball - half the width of the gap),
// as the sign of a + b sqrt(D).
int nearness_to_gap(const LatticeBall &i, const LatticeBall &j, const LatticeBall &ball) {
  const Vector u = centre_difference(i, j), v = centre_difference(i, ball);
  const BigInteger D = product(u, u), p = product(u, v), e(Int128{j.radius} - i.radius),
                   f(Int128{ball.radius} - i.radius);
  const BigInteger a = e * p - f * D, b = product(v, v) - f * f - p + e * f;
  return surd_sign(a, b, D);
}

// The same sign: by doubles where the difference is more than 1000 steps, else exactly.
int quick_nearness_to_gap(const LatticeBall &i, const LatticeBall &j, const LatticeBall &ball) {
  const Vector u = centre_difference(i, j), v = centre_difference(i, ball);
  double length = 0.0, square = 0.0;
  for (const Int128 x : u) length += static_cast<double>(x) * static_cast<double>(x);
  length = std::sqrt(length);
  const double t = 0.5 * (length - static_cast<double>(i.radius) - static_cast<double>(j.radius));
  const double along = (static_cast<double>(i.radius) + t) / length;
  for (size_t k = 0; k < 3; ++k) {
    const double off = static_cast<double>(v[k]) - along * static_cast<double>(u[k]);
    square += off * off;
  }
  const double farther = std::sqrt(square) - static_cast<double>(ball.radius) - t;
  return std::fabs(farther) > 1000.0 ? (farther > 0.0 ? 1 : -1) : nearness_to_gap(i, j, ball);
}

}  // namespace

Balls outer_balls(const Balls &balls) {
  Balls outer;
  for (size_t i = 0; i < balls.size(); ++i) {
    bool inside = false;
    for (size_t j = 0; j < balls.size(); ++j) {
      const Vector d = centre_difference(balls[i], balls[j]);
      const Int128 room = Int128{balls[j].radius} - balls[i].radius;
      if (i == j || room < 0 || dot(d, d) > room * room) continue;
      inside = inside || room > 0 || j < i;
    }
    if (!inside) outer.push_back(balls[i]);
  }
  return outer;
}

BrutePores brute_pores(const Balls &outer, int64_t floor) {
  if (outer.size() > most_balls) std::abort();
  BrutePores pores;
  const RankedPoints ranked(outer, floor);
  std::vector<const HullPoint *> tops;
  for (const HullPoint &point : ranked.points) {
    const size_t level = ranked.rank.at(point.ids());
    if (level >= ranked.floor || point.ids().size() < 3) continue;
    std::vector<uint32_t> tied;
    bool nearest = true;
    for (uint32_t l = 0; l < outer.size() && nearest; ++l) {
      const int sign = point.nearness(l);
      nearest = sign >= 0;
      if (sign == 0) tied.push_back(l);
    }
    // Each set of tied balls has one such point: the one where the largest of their distances is least.
    if (!nearest || pores.gates.count(tied) + pores.maxima.count(tied) > 0) continue;
    const int dimension = dimension_around(outer, point, tied);
    if (dimension == 2) pores.gates[tied] = {level, 0};
    if (dimension != 3) continue;
    pores.maxima[tied] = {level, tops.size()};
    tops.push_back(&point);
  }
  pores.meet.assign(tops.size() + 1, std::vector<size_t>(tops.size() + 1, BrutePores::never));
  const std::vector<Triangle> triangles = ranked.triangles(static_cast<uint32_t>(outer.size()));
  std::vector<Chain> crossed;
  for (const HullPoint *const top : tops) {
    crossed.push_back(crossed_triangles(outer, *top, ranked.rank.at(top->ids()), triangles));
  }
  crossed.emplace_back();  // the outside
  std::vector<std::pair<size_t, size_t>> together;
  for (size_t a = 0; a < crossed.size(); ++a) {
    for (size_t b = 0; b < a; ++b) together.emplace_back(a, b);
  }
  visit_cycles(triangles, [&](const Chain &cycle, size_t level) {
    std::erase_if(together, [&](const auto &pair) {
      const auto &[a, b] = pair;
      const bool parted = ((crossed[a] ^ crossed[b]) & cycle).count() % 2 != 0;
      if (parted && level < ranked.floor) pores.meet[a][b] = pores.meet[b][a] = level;
      return parted;
    });
  });
  return pores;
}

std::string first_difference(const BrutePores &expected, const ListedPores &listed) {
  using Points = std::vector<BrutePores::Point>;
  const auto find_all = [](const auto &lists, const auto &points, Points &found) {
    for (const auto &balls : lists) {
      const auto point = points.find(balls);
      if (point == points.end() || (!found.empty() && found.back().level > point->second.level)) return false;
      found.push_back(point->second);
    }
    return lists.size() == points.size() && std::set(lists.begin(), lists.end()).size() == lists.size();
  };
  Points maxima, gates;
  if (!find_all(listed.maxima, expected.maxima, maxima)) return "maxima or their order";
  if (!find_all(listed.gates, expected.gates, gates)) return "gates or their order";
  const auto meet = [&](size_t a, size_t b) {
    const auto number = [&](size_t end) { return end == maxima.size() ? end : maxima[end].number; };
    return expected.meet[number(a)][number(b)];
  };
  for (size_t a = 0; a <= maxima.size(); ++a) {
    for (size_t b = 0; b < a; ++b) {
      const uint32_t gate = listed.gate_between(a, b);
      if ((gate == no_ball ? BrutePores::never : gates[gate].level) != meet(a, b)) return "where classes meet";
    }
  }
  for (size_t k = 0; k < gates.size(); ++k) {
    const auto &[a, b] = listed.ends[k];
    if (a != b && meet(a, b) > gates[k].level) return "ends of gates";
  }
  return {};
}

int count_gaps(const Balls &outer) {
  int gaps = 0;
  for (size_t i = 0; i < outer.size(); ++i) {
    for (size_t j = i + 1; j < outer.size(); ++j) {
      bool open = true;
      for (size_t l = 0; l < outer.size() && open; ++l) {
        open = l == i || l == j || nearness_to_gap(outer[i], outer[j], outer[l]) > 0;
      }
      gaps += open ? 1 : 0;
    }
  }
  return gaps;
}

LatticeBall moved_by(const LatticeBall &ball, const BoxRows &box, const std::array<int, 3> &times) {
  LatticeBall moved = ball;
  for (size_t k = 0; k < 3; ++k) {
    moved.x += times[k] * box[k][0];
    moved.y += times[k] * box[k][1];
    moved.z += times[k] * box[k][2];
  }
  return moved;
}

int count_gaps(const Balls &outer, const BoxRows &box, int copies) {
  Balls all = outer;
  const auto n = static_cast<uint32_t>(outer.size());
  std::vector<uint32_t> of(n);
  std::vector<std::array<int, 3>> times(n, {0, 0, 0});
  for (uint32_t i = 0; i < n; ++i) of[i] = i;
  for (int a = -copies; a <= copies; ++a) {
    for (int b = -copies; b <= copies; ++b) {
      for (int c = -copies; c <= copies; ++c) {
        if (a == 0 && b == 0 && c == 0) continue;
        for (uint32_t i = 0; i < n; ++i) {
          all.push_back(moved_by(outer[i], box, {a, b, c}));
          of.push_back(i);
          times.push_back({a, b, c});
        }
      }
    }
  }
  int gaps = 0;
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < all.size(); ++j) {
      const bool first = of[j] > i || (of[j] == i && times[j] > std::array<int, 3>{0, 0, 0});
      bool open = first;
      for (size_t l = 0; l < all.size() && open; ++l) {
        open = l == i || l == j || quick_nearness_to_gap(all[i], all[j], all[l]) > 0;
      }
      gaps += open ? 1 : 0;
    }
  }
  return gaps;
}

}  // namespace oracle
