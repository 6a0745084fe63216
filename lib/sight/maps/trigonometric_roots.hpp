// The roots of a trigonometric polynomial of degree 2, and how many there are. The tangent of half the angle turns it
// into a quartic. The Bernstein coefficients of the quartic over an interval have as many sign changes as it has roots
// there, or an even number more (Descartes' rule). The interval is halved until each part has at most one sign change.
// The count is certain up to the rounding of the coefficients. Two roots that coincide to 2^-40 of the interval count
// as none, as where a curve touches without crossing.
#pragma once

#include <cstdint>

#include "core/elementary.hpp"

namespace hsp {

// constant + cosine cos t + sine sin t + square cos^2 t
struct TrigonometricPolynomial {
  double constant, cosine, sine, square;

  double at(const SinCos &t) const { return constant + t.cosine * (cosine + square * t.cosine) + sine * t.sine; }
  double slope_at(const SinCos &t) const { return -t.sine * (cosine + 2 * square * t.cosine) + sine * t.cosine; }
};

inline constexpr uint32_t most_trigonometric_roots = 8;  // over a whole turn, four in each half

// Writes the roots in (from, to) in ascending order, and returns how many there are. to - from: at most 2 pi.
uint32_t find_roots(const TrigonometricPolynomial &f, double from, double to, double root[most_trigonometric_roots]);

}  // namespace hsp
