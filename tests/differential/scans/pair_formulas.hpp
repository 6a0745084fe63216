// Closed forms for two balls at a distance, and how fast they change.
#pragma once

#include <array>
#include <cstddef>

// Two balls of radii r >= 0 at distance d. With s the sum of the radii and t their difference there are three pieces:
//   d <= |t|       one ball holds the other: nothing depends on d
//   |t| <= d <= s  the spheres meet in a circle; its plane is h_i = (d^2 + r_i^2 - r_j^2) / (2 d) from centre i,
//                  A_i = 2 pi r_i (r_i + h_i), and the volume is that of the balls less their two caps
//   d >= s         two whole spheres
// On the middle piece, with e_0 = r_0^2 - r_1^2 = -e_1,
//   dA_i/dd = pi r_i (1 - e_i / d^2),  d(A_0 + A_1)/dd = pi s (1 - t^2 / d^2),  dV/dd = pi (r_0^2 - h_0^2).
class PairFormulas {
 public:
  PairFormulas(long double radius_0, long double radius_1) : r_{radius_0, radius_1} {}

  [[nodiscard]] long double sum() const { return r_[0] + r_[1]; }
  [[nodiscard]] long double difference() const { return r_[0] > r_[1] ? r_[0] - r_[1] : r_[1] - r_[0]; }

  // Of equal balls at one place the first has the area.
  [[nodiscard]] std::array<long double, 2> areas(long double d) const;
  [[nodiscard]] long double volume(long double d) const;

  // On the middle piece, both ends included: one-sided limits there.
  [[nodiscard]] std::array<long double, 2> areas_by_distance(long double d) const;
  [[nodiscard]] long double volume_by_distance(long double d) const;

  // Bounds of the fifth derivatives on the middle piece from `least` on, for the error of Simpson's rule:
  // the terms in 1/d^2 make 120 / d^6, and dV/dd = pi (r_0^2 - (d + e_0/d)^2 / 4) has -e_0^2 / (4 d^2) of that kind.
  [[nodiscard]] std::array<long double, 2> fifth_derivatives_of_areas(long double least) const;
  [[nodiscard]] long double fifth_derivative_of_total(long double least) const;
  [[nodiscard]] long double fifth_derivative_of_volume(long double least) const;

 private:
  [[nodiscard]] long double excess(size_t i) const { return r_[i] * r_[i] - r_[1 - i] * r_[1 - i]; }
  [[nodiscard]] long double height(size_t i, long double d) const { return (d + excess(i) / d) / 2; }

  std::array<long double, 2> r_;
};
