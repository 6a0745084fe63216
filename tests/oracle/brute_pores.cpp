#include "brute_pores.hpp"

#include <cmath>

#include "big_integer.hpp"

namespace oracle {
namespace {

using Real = long double;
using Point = std::array<Real, 3>;

Real distance(const LatticeBall &ball, const Point &x) {
  const Real dx = x[0] - static_cast<Real>(ball.x), dy = x[1] - static_cast<Real>(ball.y),
             dz = x[2] - static_cast<Real>(ball.z);
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

// Three equations with two right-hand sides, by elimination with pivots. False if they are nearly dependent.
bool solve(Real (&M)[3][5]) {
  for (int c = 0; c < 3; ++c) {
    int best = c;
    for (int r = c; r < 3; ++r) {
      if (std::fabs(M[r][c]) > std::fabs(M[best][c])) best = r;
    }
    if (std::fabs(M[best][c]) < 1e-9L) return false;
    for (int k = 0; k < 5; ++k) std::swap(M[c][k], M[best][k]);
    for (int r = 0; r < 3; ++r) {
      if (r == c) continue;
      const Real factor = M[r][c] / M[c][c];
      for (int k = c; k < 5; ++k) M[r][k] -= factor * M[c][k];
    }
  }
  for (int r = 0; r < 3; ++r) {
    for (int k = 3; k < 5; ++k) M[r][k] /= M[r][r];
  }
  return true;
}

// Whether three or four balls have a critical point, in units in which the largest difference is about 1.
bool is_critical(const Balls &balls, const std::array<uint32_t, 4> &id, int count, Real unit, bool &decided) {
  constexpr Real doubt = 1e-11L;
  const auto sign = [&](Real value) {
    if (std::fabs(value) < doubt) decided = false;
    return value > 0;
  };
  const LatticeBall &base = balls[id[0]];
  const Point origin{static_cast<Real>(base.x), static_cast<Real>(base.y), static_cast<Real>(base.z)};
  Real C[3][3], e[3] = {0, 0, 0}, M[3][5];
  for (int i = 1; i < count; ++i) {
    const LatticeBall &ball = balls[id[static_cast<size_t>(i)]];
    const Point c{static_cast<Real>(ball.x), static_cast<Real>(ball.y), static_cast<Real>(ball.z)};
    Real square = 0;
    for (size_t k = 0; k < 3; ++k) {
      C[i - 1][k] = (c[k] - origin[k]) / unit;
      M[i - 1][k] = 2 * C[i - 1][k];
      square += C[i - 1][k] * C[i - 1][k];
    }
    e[i - 1] = static_cast<Real>(ball.radius - base.radius) / unit;
    M[i - 1][3] = square - e[i - 1] * e[i - 1];
    M[i - 1][4] = -2 * e[i - 1];
  }
  if (count == 3) {
    for (size_t k = 0; k < 3; ++k) {
      C[2][k] = C[0][(k + 1) % 3] * C[1][(k + 2) % 3] - C[0][(k + 2) % 3] * C[1][(k + 1) % 3];
      M[2][k] = C[2][k];
    }
    M[2][3] = M[2][4] = 0;
  }
  if (!solve(M)) {
    decided = false;
    return false;
  }
  Real A = -1, b = 0, c = 0;
  for (auto &row : M) {
    A += row[4] * row[4];
    b += row[3] * row[4];
    c += row[3] * row[3];
  }
  if (std::fabs(A) < doubt) decided = false;
  const Real D = b * b - A * c;
  if (!sign(D)) return false;
  for (const int root : {-1, 1}) {
    const Real s = (-b + root * std::sqrt(D)) / A;
    if (!sign(s)) continue;
    bool fits = true;
    for (int i = 1; i < count; ++i) fits = sign(s + e[i - 1]) && fits;
    if (!fits) continue;
    // In barycentric coordinates of the centres.
    Real B[3][5];
    Point x{};
    for (size_t k = 0; k < 3; ++k) {
      const Real at = M[k][3] + M[k][4] * s;
      x[k] = origin[k] + at * unit;
      for (size_t i = 0; i < 3; ++i) B[k][i] = C[i][k];
      B[k][3] = at;
      B[k][4] = 0;
    }
    if (!solve(B)) {
      decided = false;
      return false;
    }
    Real rest = 1;
    for (int i = 0; i + 1 < count; ++i) {
      fits = sign(B[i][3]) && fits;
      rest -= B[i][3];
    }
    if (!(sign(rest) && fits)) continue;
    const Real t = s - static_cast<Real>(base.radius) / unit;
    for (uint32_t l = 0; l < balls.size() && fits; ++l) {
      bool own = false;
      for (int i = 0; i < count; ++i) own = own || id[static_cast<size_t>(i)] == l;
      if (!own) fits = sign((distance(balls[l], x) - static_cast<Real>(balls[l].radius)) / unit - t);
    }
    if (fits) return true;
  }
  return false;
}

// Sign of the distance of a ball less that of the middle of a gap: of a + b sqrt(D).
int nearness_to_gap(const LatticeBall &i, const LatticeBall &j, const LatticeBall &ball) {
  const Vector u = centre_difference(i, j), v = centre_difference(i, ball);
  const auto product = [](const Vector &p, const Vector &q) {
    BigInteger sum;
    for (size_t k = 0; k < 3; ++k) sum = sum + BigInteger(p[k]) * BigInteger(q[k]);
    return sum;
  };
  const BigInteger D = product(u, u), p = product(u, v), e(Int128{j.radius} - i.radius),
                   f(Int128{ball.radius} - i.radius);
  const BigInteger a = e * p - f * D, b = product(v, v) - f * f - p + e * f;
  if (a.sign() * b.sign() >= 0) return a.sign() != 0 ? a.sign() : b.sign();
  return a.sign() * (a * a - b * b * D).sign();
}

// The same, in doubles where it is many steps.
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

CriticalSets critical_sets(const Balls &outer) {
  CriticalSets sets;
  const auto n = static_cast<uint32_t>(outer.size());
  Real unit = 1;
  for (const LatticeBall &ball : outer) {
    for (const int64_t v : {ball.x - outer[0].x, ball.y - outer[0].y, ball.z - outer[0].z, ball.radius}) {
      unit = std::max(unit, std::fabs(static_cast<Real>(v)));
    }
  }
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      for (uint32_t k = j + 1; k < n; ++k) {
        if (is_critical(outer, {i, j, k, no_ball}, 3, unit, sets.decided)) sets.gates.insert({i, j, k});
        for (uint32_t l = k + 1; l < n; ++l) {
          if (is_critical(outer, {i, j, k, l}, 4, unit, sets.decided)) sets.maxima.insert({i, j, k, l});
        }
      }
    }
  }
  return sets;
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
