// Signed integers of up to a fixed number of bits, as sign and magnitude of variable length. They are for polynomials
// of high degree: most values are far shorter than their bounds, and the cost of a product depends on the actual
// lengths. No heap, no exceptions. Overflow is not detected: the bounds in tangent_point.hpp prove that values fit.
#pragma once

#include <bit>

#include "exact/wide_integer.hpp"

namespace hsp {

template <uint32_t bits>
class LongInteger {
 public:
  using Limb = exact::FastLimb;

  LongInteger() = default;  // 0
  LongInteger(int64_t value) : negative_(value < 0) {
    const uint64_t magnitude = value < 0 ? uint64_t{0} - static_cast<uint64_t>(value) : static_cast<uint64_t>(value);
    for (uint32_t shift = 0; shift < 64; shift += limb_bits)
      limb_[shift / limb_bits] = static_cast<Limb>(magnitude >> shift);
    length_ = 64 / limb_bits;
    trim();
  }
  LongInteger(const LongInteger &other) { *this = other; }
  // From an integer of fewer bits.
  template <uint32_t fewer>
  requires(fewer < bits) LongInteger(const LongInteger<fewer> &other)
      : length_(other.length_), negative_(other.negative_) {
    for (uint32_t k = 0; k < length_; ++k) limb_[k] = other.limb_[k];
  }
  LongInteger &operator=(const LongInteger &other) {
    length_ = other.length_;
    negative_ = other.negative_;
    for (uint32_t k = 0; k < length_; ++k) limb_[k] = other.limb_[k];
    return *this;
  }

  int sign() const { return length_ == 0 ? 0 : negative_ ? -1 : 1; }

  LongInteger operator-() const {
    LongInteger result = *this;
    result.negative_ = length_ != 0 && !negative_;
    return result;
  }
  friend LongInteger operator+(const LongInteger &a, const LongInteger &b) { return sum(a, b, b.negative_); }
  friend LongInteger operator-(const LongInteger &a, const LongInteger &b) { return sum(a, b, !b.negative_); }
  [[gnu::noinline]] friend LongInteger operator*(const LongInteger &a, const LongInteger &b) {
    LongInteger result;
    if (a.length_ == 0 || b.length_ == 0) return result;
    result.length_ = a.length_ + b.length_;
    if (result.length_ > limbs) result.length_ = limbs;  // the leading limb is 0
    for (uint32_t k = 0; k < result.length_; ++k) result.limb_[k] = 0;
    for (uint32_t i = 0; i < a.length_; ++i) {
      Wide carry = 0;
      for (uint32_t j = 0; j < b.length_ && i + j < result.length_; ++j) {
        carry += static_cast<Wide>(a.limb_[i]) * b.limb_[j] + result.limb_[i + j];
        result.limb_[i + j] = static_cast<Limb>(carry);
        carry >>= limb_bits;
      }
      if (i + b.length_ < result.length_) result.limb_[i + b.length_] = static_cast<Limb>(carry);
    }
    result.negative_ = a.negative_ != b.negative_;
    result.trim();
    return result;
  }

  // The value as mantissa 2^exponent; returns the mantissa, rounded once from the leading 64 bits, the last of which is
  // set if any bit behind them is. The same for limbs of any width; 0 for 0.
  double leading(int &exponent) const {
    exponent = 0;
    if (length_ == 0) return 0.0;
    const int size = static_cast<int>(length_ * limb_bits) - std::countl_zero(limb_[length_ - 1]);
    exponent = size > 64 ? size - 64 : 0;
    uint64_t mantissa = 0;
    bool more_follows = false;
    for (uint32_t k = 0; k < length_; ++k) {
      const int position = static_cast<int>(k * limb_bits) - exponent;
      const uint64_t limb = limb_[k];
      if (position >= 0) {
        mantissa |= limb << position;
      } else if (position > -static_cast<int>(limb_bits)) {
        mantissa |= limb >> -position;
        more_follows = more_follows || limb << (64 + position) != 0;
      } else {
        more_follows = more_follows || limb != 0;
      }
    }
    const double rounded = static_cast<double>(mantissa | static_cast<uint64_t>(more_follows));
    return negative_ ? -rounded : rounded;
  }

 private:
  template <uint32_t>
  friend class LongInteger;
  using Wide = exact::DoubleLimb<Limb>::type;
  static constexpr uint32_t limb_bits = sizeof(Limb) * 8;
  static constexpr uint32_t limbs = bits / limb_bits;

  void trim() {
    while (length_ > 0 && limb_[length_ - 1] == 0) --length_;
    if (length_ == 0) negative_ = false;
  }
  // Compares magnitudes.
  static bool less(const LongInteger &a, const LongInteger &b) {
    if (a.length_ != b.length_) return a.length_ < b.length_;
    for (uint32_t k = a.length_; k-- > 0;) {
      if (a.limb_[k] != b.limb_[k]) return a.limb_[k] < b.limb_[k];
    }
    return false;
  }
  // The sum of a and of b with the given sign.
  [[gnu::noinline]] static LongInteger sum(const LongInteger &a, const LongInteger &b, bool negative) {
    LongInteger result;
    const bool swapped = less(a, b);
    const LongInteger &large = swapped ? b : a, &small = swapped ? a : b;
    const bool subtract = a.negative_ != negative;
    Wide carry = subtract ? 1 : 0;
    for (uint32_t k = 0; k < large.length_; ++k) {
      const Limb other = k < small.length_ ? small.limb_[k] : Limb{0};
      carry += static_cast<Wide>(large.limb_[k]) + (subtract ? static_cast<Limb>(~other) : other);
      result.limb_[k] = static_cast<Limb>(carry);
      carry >>= limb_bits;
    }
    result.length_ = large.length_;
    if (!subtract && carry != 0 && result.length_ < limbs) result.limb_[result.length_++] = static_cast<Limb>(carry);
    result.negative_ = swapped ? negative : a.negative_;
    result.trim();
    return result;
  }

  uint32_t length_ = 0;
  bool negative_ = false;
  Limb limb_[limbs];  // lowest first; only the first length_ are set
};

}  // namespace hsp
