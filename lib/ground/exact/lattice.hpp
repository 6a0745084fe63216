// The decimal lattice: lengths are rounded to integers once, on input. If the step is a power of ten, decimal numbers
// of input texts are represented exactly. Multiplying or dividing by a power of ten that is a double is one IEEE
// operation, so rounding is the same everywhere.
//
// As an example a step of 0.1: 1.25 is 12.5 steps, which become 13, and -1.25 becomes -13.
#pragma once

#include "core/decimal.hpp"
#include "core/small_code.hpp"
#include "core/status.hpp"
#include "exact/plane.hpp"

namespace hsp::exact {

inline constexpr double coordinate_limit = 0x1p50;    // steps, inclusive
inline constexpr double radius_limit = 0x1p30;        // steps, exclusive
inline constexpr double query_radius_limit = 0x1p51;  // steps, inclusive
inline constexpr double fewest_steps = 0x1p20;        // the length for which a lattice is chosen has at least so many

class Lattice {
 public:
  // Step 1.
  Lattice() = default;

  // A given step, finite and > 0. A step that is the double nearest to a power of ten is taken for that power.
  static Lattice with_step(double step) {
    for (int k = 0; k <= largest_power_of_ten; ++k) {
      if (step == 1.0 / power_of_ten[k]) return Lattice(k);
      if (step == power_of_ten[k]) return Lattice(-k);
    }
    Lattice lattice;
    lattice.divisor_ = step;
    return lattice;
  }
  // Chooses as step the smallest power of ten for which the largest radius plus the probe, each rounded by itself, is
  // below radius_limit; 1e-8 if both are 0. Returns false if there is none, or if the lengths are too small even for
  // the finest. Out of line: called from several places, once for a set.
  [[gnu::noinline]] static bool for_largest_radius(double radius, double probe, Lattice &lattice) {
    if (radius == 0.0 && probe == 0.0) {
      lattice = Lattice(8);
      return true;
    }
    for (int digits = largest_power_of_ten; digits >= -largest_power_of_ten; --digits) {
      lattice = Lattice(digits);
      const double radius_steps = lattice.steps(radius);
      const double probe_steps = lattice.steps(probe);
      if (!(radius_steps < radius_limit && probe_steps < radius_limit)) continue;
      const auto all = static_cast<double>(nearest(radius_steps) + nearest(probe_steps));
      if (all < radius_limit) return all >= fewest_steps;
    }
    return false;
  }
  // The same for points. largest: no coordinate is larger in size. The step is at most 1e-8, unless the points do not
  // fit such a lattice. Returns false if all coordinates are too small even for the finest lattice. If some are too
  // large, round() says so.
  static bool for_points(double largest, Lattice &lattice) {
    const bool found = for_largest_radius(largest, 0.0, lattice);
    if (lattice.step() < 1e-8) return found;
    for (int digits = 8; digits >= -largest_power_of_ten; --digits) {
      lattice = Lattice(digits);
      if (lattice.steps(largest) <= coordinate_limit) break;
    }
    return true;
  }

  double step() const { return length(1.0); }
  // A length in steps, before it is rounded to an integer. It has one rounding.
  double steps(double length) const { return divisor_ == 1.0 ? length * factor_ : length / divisor_; }
  // steps(length) is length * factor(), bit for bit; 0 if lengths are divided instead.
  double factor() const { return divisor_ == 1.0 ? factor_ : 0.0; }
  // Finds the lattice point nearest to a position. False if there is none, as a coordinate is not finite or too large.
  // There is one branch for all coordinates; which one is at fault can be found afterwards.
  HSP_INLINE_UNLESS_SMALL bool round(const double *xyz, Vector &point) const {
    const double x = steps(xyz[0]), y = steps(xyz[1]), z = steps(xyz[2]);
    const bool on_lattice =
        (std::fabs(x) <= coordinate_limit) & (std::fabs(y) <= coordinate_limit) & (std::fabs(z) <= coordinate_limit);
    if (on_lattice) point = {nearest(x), nearest(y), nearest(z)};
    return on_lattice;
  }
  double length(double steps) const { return divisor_ == 1.0 ? steps / factor_ : steps * divisor_; }
  // The same for several numbers in lanes, as lanes/wide.hpp has them.
  template <class Lanes>
  Lanes lengths(const Lanes &steps) const {
    return divisor_ == 1.0 ? steps / factor_ : steps * divisor_;
  }
  double area(double square_steps) const { return length(length(square_steps)); }
  double volume(double cubic_steps) const { return length(length(length(cubic_steps))); }

 private:
  // The step 10^-digits. One of factor and divisor is 1, so that steps() rounds once.
  explicit Lattice(int digits)
      : factor_(digits > 0 ? power_of_ten[digits] : 1.0), divisor_(digits < 0 ? power_of_ten[-digits] : 1.0) {}

  double factor_ = 1.0;
  double divisor_ = 1.0;
};

}  // namespace hsp::exact
