// A double with a bound of its error: of its distance from the exact number that it stands for. It is the filter stage
// of predicates whose values differ too much in size for one static bound. Every operation updates the bound (running
// error analysis: Higham, Accuracy and Stability of Numerical Algorithms, section 3.3).
//
// The bound is itself rounded a few times. It is enlarged by a relative 2^-50 and the smallest normal double to cover
// that.
#pragma once

#include <bit>
#include <cstdint>

#include "lanes/floating_point.hpp"

namespace hsp {

struct BoundedDouble {
  double value = 0.0;
  double error = 0.0;

  BoundedDouble() = default;
  // An integer of at most 53 bits, exactly.
  BoundedDouble(double exact_value) : value(exact_value) {}
  BoundedDouble(double rounded, double bound) : value(rounded), error(bound) {}

  // +1 or -1 if that is certain, else 0.
  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }

  // How many words store() writes; the argument, a width, is there because wide floats have one.
  static constexpr uint32_t words_of(uint32_t) { return 2; }
  void store(uint64_t *to) const {
    to[0] = std::bit_cast<uint64_t>(value);
    to[1] = std::bit_cast<uint64_t>(error);
  }
  void load(const uint64_t *from) {
    value = std::bit_cast<double>(from[0]);
    error = std::bit_cast<double>(from[1]);
  }

  BoundedDouble operator-() const { return {-value, error}; }
  // This number times 2^k, k of one digit or two.
  BoundedDouble scaled(int32_t k) const {
    const double factor = k < 0 ? 1.0 / static_cast<double>(UINT64_C(1) << -k) : static_cast<double>(UINT64_C(1) << k);
    return {value * factor, error * factor};
  }
  friend BoundedDouble operator+(const BoundedDouble &a, const BoundedDouble &b) {
    const double sum = a.value + b.value;
    return {sum, covered(a.error + b.error + unit_roundoff * std::fabs(sum))};
  }
  friend BoundedDouble operator-(const BoundedDouble &a, const BoundedDouble &b) { return a + -b; }
  friend BoundedDouble operator*(const BoundedDouble &a, const BoundedDouble &b) {
    const double product = a.value * b.value;
    return {product, covered((std::fabs(a.value) + a.error) * b.error + std::fabs(b.value) * a.error +
                             unit_roundoff * std::fabs(product))};
  }
  // If the divisor may be 0, the error of the quotient is infinite.
  friend BoundedDouble operator/(const BoundedDouble &a, const BoundedDouble &b) {
    const double least = std::fabs(b.value) - b.error;
    if (!(least > 0.0)) return uncertain();
    const double quotient = a.value / b.value;
    return {quotient, covered((a.error + std::fabs(quotient) * b.error) / (least * (1.0 - 0x1p-52)) +
                              unit_roundoff * std::fabs(quotient))};
  }
  // For a number that is certainly positive, else the error is infinite. |sqrt(a) - sqrt(b)| = |a - b| / (sqrt(a) +
  // sqrt(b)).
  friend BoundedDouble square_root(const BoundedDouble &a) {
    if (!(a.value > a.error)) return uncertain();
    const double root = std::sqrt(a.value);
    return {root, covered(a.error / root + unit_roundoff * root)};
  }

 private:
  static double covered(double error) { return error * (1.0 + 0x1p-50) + std::numeric_limits<double>::min(); }
  static BoundedDouble uncertain() { return {0.0, std::numeric_limits<double>::infinity()}; }
};

}  // namespace hsp
