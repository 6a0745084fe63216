// Signed integers of up to 12288 bits in place: sign and absolute by the methods taught at school, fast enough for
// millions of determinants. Shares no code with lib/; perturbation_test.cpp holds it against the integers of the
// oracle.
#pragma once

#include <cmath>
#include <cstdint>

#include "int128.hpp"

namespace perturbation {

using oracle::Int128;
using oracle::UInt128;

class Integer {
 public:
  static constexpr int capacity = 192;  // limbs of 64 bits

  Integer() = default;
  Integer(const Integer &other) { *this = other; }
  Integer &operator=(const Integer &other) {
    used_ = other.used_;
    negative_ = other.negative_;
    for (int k = 0; k < used_; ++k) limb_[k] = other.limb_[k];
    return *this;
  }
  explicit Integer(Int128 value) : negative_(value < 0) {
    UInt128 rest = negative_ ? UInt128{0} - static_cast<UInt128>(value) : static_cast<UInt128>(value);
    for (; rest != 0; rest >>= 64) limb_[used_++] = static_cast<uint64_t>(rest);
  }
  // An integral double.
  static Integer from_double(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);  // value = mantissa 2^exponent, 1/2 <= |mantissa| < 1
    const Integer digits(static_cast<Int128>(std::ldexp(mantissa, 53)));
    if (exponent < 53) return Integer(static_cast<Int128>(value));
    return digits.times_power_of_two(exponent - 53);
  }

  int sign() const { return used_ == 0 ? 0 : negative_ ? -1 : 1; }

  Integer operator-() const {
    Integer result = *this;
    result.negative_ = used_ != 0 && !negative_;
    return result;
  }
  friend Integer operator+(const Integer &a, const Integer &b) { return sum(a, b, b.negative_); }
  friend Integer operator-(const Integer &a, const Integer &b) { return sum(a, b, !b.negative_); }
  friend Integer operator*(const Integer &a, const Integer &b) {
    Integer result;
    if (a.used_ == 0 || b.used_ == 0) return result;
    result.used_ = a.used_ + b.used_;
    for (int k = 0; k < result.used_; ++k) result.limb_[k] = 0;
    for (int i = 0; i < a.used_; ++i) {
      if (a.limb_[i] == 0) continue;
      uint64_t carry = 0;
      for (int k = 0; k < b.used_; ++k) {
        const UInt128 place = static_cast<UInt128>(a.limb_[i]) * b.limb_[k] + result.limb_[i + k] + carry;
        result.limb_[i + k] = static_cast<uint64_t>(place);
        carry = static_cast<uint64_t>(place >> 64);
      }
      result.limb_[i + b.used_] = carry;
    }
    result.negative_ = a.negative_ != b.negative_;
    result.drop_leading_zeros();
    return result;
  }
  Integer times_power_of_two(int bits) const {
    Integer result;
    if (used_ == 0) return result;
    const int whole = bits / 64;
    const int rest = bits % 64;
    for (int k = 0; k < whole; ++k) result.limb_[k] = 0;
    uint64_t carry = 0;
    for (int k = 0; k < used_; ++k) {
      result.limb_[whole + k] = limb_[k] << rest | carry;
      carry = rest == 0 ? 0 : limb_[k] >> (64 - rest);
    }
    result.limb_[whole + used_] = carry;
    result.used_ = whole + used_ + 1;
    result.negative_ = negative_;
    result.drop_leading_zeros();
    return result;
  }
  // Correct to a few units in the last place; the value must not exceed the range of the type.
  long double to_long_double() const {
    long double result = 0.0L;
    const int lowest = used_ > 4 ? used_ - 4 : 0;
    for (int k = used_ - 1; k >= lowest; --k) result = result * 0x1p64L + static_cast<long double>(limb_[k]);
    if (lowest > 0) result = std::ldexp(result, 64 * lowest);
    return negative_ ? -result : result;
  }
  uint64_t limb(int k) const { return k < used_ ? limb_[k] : 0; }
  int limbs() const { return used_; }

 private:
  static Integer sum(const Integer &a, const Integer &b, bool b_negative) {
    Integer result;
    if (a.negative_ == b_negative || a.used_ == 0 || b.used_ == 0) {
      const Integer &longer = a.used_ >= b.used_ ? a : b;
      const Integer &shorter = a.used_ >= b.used_ ? b : a;
      uint64_t carry = 0;
      for (int k = 0; k < longer.used_; ++k) {
        const UInt128 place = static_cast<UInt128>(longer.limb_[k]) + shorter.limb(k) + carry;
        result.limb_[k] = static_cast<uint64_t>(place);
        carry = static_cast<uint64_t>(place >> 64);
      }
      result.used_ = longer.used_;
      if (carry != 0) result.limb_[result.used_++] = carry;
      result.negative_ = a.used_ == 0 ? b_negative : a.negative_;
    } else {
      const bool a_larger = a.magnitude_not_below(b);
      const Integer &larger = a_larger ? a : b;
      const Integer &smaller = a_larger ? b : a;
      uint64_t borrow = 0;
      for (int k = 0; k < larger.used_; ++k) {
        const UInt128 take = static_cast<UInt128>(smaller.limb(k)) + borrow;
        result.limb_[k] = static_cast<uint64_t>(larger.limb_[k] - take);
        borrow = larger.limb_[k] < take ? 1 : 0;
      }
      result.used_ = larger.used_;
      result.negative_ = a_larger ? a.negative_ : b_negative;
    }
    result.drop_leading_zeros();
    return result;
  }
  bool magnitude_not_below(const Integer &other) const {
    if (used_ != other.used_) return used_ > other.used_;
    for (int k = used_ - 1; k >= 0; --k) {
      if (limb_[k] != other.limb_[k]) return limb_[k] > other.limb_[k];
    }
    return true;
  }
  void drop_leading_zeros() {
    while (used_ > 0 && limb_[used_ - 1] == 0) --used_;
    if (used_ == 0) negative_ = false;
  }

  uint64_t limb_[capacity];  // those from used_ on have no value
  int used_ = 0;
  bool negative_ = false;
};

}  // namespace perturbation
