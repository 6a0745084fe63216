#include "maps/trigonometric_roots.hpp"

namespace hsp {
namespace {

constexpr int most_halvings = 40;

// A quartic on [low, low + width] by its Bernstein coefficients.
struct Piece {
  double b[5];
  double low, width;
  int halvings;
};

int sign_changes(const double b[5]) {
  int count = 0;
  for (int k = 0; k < 4; ++k) count += (b[k] > 0.0) != (b[k + 1] > 0.0) ? 1 : 0;
  return count;
}

// De Casteljau's algorithm at the middle: `left` becomes the left half.
Piece halve(Piece &left) {
  Piece right = left;
  double *b = right.b;
  for (int step = 0; step < 4; ++step) {
    left.b[step] = b[0];
    for (int k = 0; k < 4 - step; ++k) b[k] = 0.5 * (b[k] + b[k + 1]);
  }
  left.b[4] = b[0];
  left.width = right.width = 0.5 * left.width;
  right.low = left.low + left.width;
  ++left.halvings;
  right.halvings = left.halvings;
  return right;
}

double value_at(const Piece &piece, double s) {
  double b[5];
  for (int k = 0; k < 5; ++k) b[k] = piece.b[k];
  for (int step = 4; step > 0; --step) {
    for (int k = 0; k < step; ++k) b[k] += s * (b[k + 1] - b[k]);
  }
  return b[0];
}

// Whether the sign changes next to s, for a < s < b; the signs at a and b are known.
bool changes_next_to(const Piece &piece, double s, double a, double b) {
  constexpr double beside = 1e-6;
  const bool low = s - beside > a ? value_at(piece, s - beside) > 0.0 : piece.b[0] > 0.0;
  const bool high = s + beside < b ? value_at(piece, s + beside) > 0.0 : piece.b[4] > 0.0;
  return low != high;
}

// The only root of a piece, by the Illinois variant of false position; Newton's method finishes it.
double only_root(const Piece &piece) {
  double a = 0.0, b = 1.0;
  double at_a = piece.b[0], at_b = piece.b[4];
  double s = 0.5;
  int last_side = 0;
  for (int step = 0; step < 60; ++step) {
    const double previous = s;
    s = (at_a * b - at_b * a) / (at_a - at_b);
    if (b - a < 1e-7) break;
    if (step > 0 && std::fabs(s - previous) < 1e-7) {
      // Steps are also short next to an end where the value is nearly 0.
      if (changes_next_to(piece, s, a, b)) break;
      s = 0.5 * (a + b);
    }
    double value = value_at(piece, s);
    if (value == 0.0) {
      // A value that rounds to 0 next to such an end is no root either.
      if (changes_next_to(piece, s, a, b)) break;
      s = 0.5 * (a + b);
      value = value_at(piece, s);
    }
    if ((value > 0.0) == (at_b > 0.0)) {
      b = s;
      at_b = value;
      if (last_side == -1) at_a *= 0.5;
      last_side = -1;
    } else {
      a = s;
      at_a = value;
      if (last_side == 1) at_b *= 0.5;
      last_side = 1;
    }
  }
  return piece.low + s * piece.width;
}

double refined(const TrigonometricPolynomial &f, double t) {
  for (int step = 0; step < 2; ++step) {
    const SinCos at = sin_cos(t);
    const double slope = f.slope_at(at);
    if (slope == 0.0) break;
    const double move = f.at(at) / slope;
    if (std::fabs(move) < 1e-4) t -= move;
  }
  return t;
}

// The roots in [from, to], at most half a turn. The quartic in u = tan((t - middle) / 2), |u| <= U = tan((to - from) /
// 4) <= 1, is the polynomial times (1 + u^2)^2. at_from, at_to: null, or the values at an end where another interval
// goes on, so that both use the same sign.
uint32_t roots_of_half_turn(const TrigonometricPolynomial &f, double from, double to, const double *at_from,
                            const double *at_to, double *root) {
  const double middle = 0.5 * (from + to);
  const SinCos m = sin_cos(middle);
  const SinCos quarter = sin_cos(0.25 * (to - from));
  const double U = quarter.sine / quarter.cosine;
  const double A0 = f.constant + 0.5 * f.square;
  const double A1 = f.cosine * m.cosine + f.sine * m.sine;
  const double B1 = f.sine * m.cosine - f.cosine * m.sine;
  const double A2 = 0.5 * f.square * (m.cosine * m.cosine - m.sine * m.sine);
  const double B2 = -f.square * m.sine * m.cosine;
  const double c0 = A0 + A1 + A2;
  const double c1 = (2 * B1 + 4 * B2) * U;
  const double c2 = (2 * A0 - 6 * A2) * (U * U);
  const double c3 = (2 * B1 - 4 * B2) * (U * U * U);
  const double c4 = (A0 - A1 + A2) * (U * U * U * U);
  // Each halving keeps at most four sign changes in all, so that few pieces wait.
  Piece waiting[most_halvings + 4];
  waiting[0] = {{c0 - c1 + c2 - c3 + c4, c0 - 0.5 * c1 + 0.5 * c3 - c4, c0 - c2 / 3 + c4, c0 + 0.5 * c1 - 0.5 * c3 - c4,
                 c0 + c1 + c2 + c3 + c4},
                -U,
                2 * U,
                0};
  const double scale = (1.0 + U * U) * (1.0 + U * U);
  if (at_from != nullptr) waiting[0].b[0] = *at_from * scale;
  if (at_to != nullptr) waiting[0].b[4] = *at_to * scale;
  uint32_t left = 1;
  uint32_t count = 0;
  while (left > 0) {
    Piece piece = waiting[--left];
    const int changes = sign_changes(piece.b);
    if (changes == 1 && count < 4) {
      root[count++] = refined(f, middle + 2 * arc_tangent(only_root(piece), 1.0));
    } else if (changes > 1 && piece.halvings < most_halvings) {
      waiting[left + 1] = piece;
      waiting[left] = halve(waiting[left + 1]);
      left += 2;
    }
  }
  return count;
}

}  // namespace

uint32_t find_roots(const TrigonometricPolynomial &f, double from, double to, double root[most_trigonometric_roots]) {
  if (!(from < to)) return 0;
  uint32_t count;
  if (to - from > pi) {
    const double middle = 0.5 * (from + to);
    const double at_middle = f.at(sin_cos(middle));
    count = roots_of_half_turn(f, from, middle, nullptr, &at_middle, root);
    count += roots_of_half_turn(f, middle, to, &at_middle, nullptr, root + count);
  } else {
    count = roots_of_half_turn(f, from, to, nullptr, nullptr, root);
  }
  // Refinement may carry a root past the end of the interval.
  uint32_t kept = 0;
  for (uint32_t k = 0; k < count; ++k) {
    if (root[k] > from && root[k] < to) root[kept++] = root[k];
  }
  return kept;
}

}  // namespace hsp
