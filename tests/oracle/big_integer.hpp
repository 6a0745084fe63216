// Signed integers of any size, by the methods taught at school.
#pragma once

#include <cstdint>
#include <string>

#include "lattice_ball.hpp"

namespace oracle {

// A sign and a magnitude in base 2^32, lowest limb first, without leading zero limbs; zero has no limbs.
class BigInteger {
 public:
  BigInteger() = default;
  explicit BigInteger(Int128 value);

  [[nodiscard]] int sign() const { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }

  BigInteger operator-() const;
  friend BigInteger operator+(const BigInteger &a, const BigInteger &b);
  friend BigInteger operator-(const BigInteger &a, const BigInteger &b) { return a + -b; }
  friend BigInteger operator*(const BigInteger &a, const BigInteger &b);
  friend bool operator==(const BigInteger &a, const BigInteger &b) = default;

  // This number times 2^bits.
  [[nodiscard]] BigInteger times_power_of_two(unsigned bits) const;

  // Decimal digits with a sign in front if negative.
  [[nodiscard]] std::string to_string() const;

 private:
  // A string, as it holds up to three limbs without memory from the heap: for small numbers allocation would take most
  // of the time.
  using Limbs = std::u32string;
  static int compare_magnitudes(const Limbs &a, const Limbs &b);
  static Limbs add_magnitudes(const Limbs &a, const Limbs &b);
  static Limbs subtract_magnitudes(const Limbs &larger, const Limbs &smaller);
  static void drop_leading_zeros(Limbs &limbs);

  bool negative_ = false;
  Limbs limbs_;
};

inline int sign_of(const BigInteger &value) {
  return value.sign();
}

}  // namespace oracle
