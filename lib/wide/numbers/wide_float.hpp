// Binary floats of many bits, each with a bound of its distance from the exact number that it stands for. They decide
// questions that doubles leave open. The number of bits is chosen at run time, up to a capacity, so that one piece of
// code serves several widths. No heap, no exceptions. Limbs of any width give the same bits.
//
// A number is sign * mantissa * 2^exponent; the mantissa is an integer of exactly `bits` bits with its highest bit set.
// Results are truncated behind the last bit, never rounded up. Bounds are powers of two: |error| <= 2^error_exponent.
#pragma once

#include <bit>
#include <cmath>

#include "exact/wide_integer.hpp"
#include "numbers/bounded_double.hpp"

namespace hsp {

template <class Limb>
class WideFloatOf {
 public:
  static constexpr uint32_t most_bits = 2048;

  WideFloatOf() {}  // 0, exactly
  // value * 2^exponent, exactly. bits: the width, a multiple of 64, the same for all numbers of one expression.
  WideFloatOf(int64_t value, uint32_t bits, int32_t exponent = 0)
      : exponent_(exponent), bits_(static_cast<uint16_t>(bits)), sign_(static_cast<int8_t>((value > 0) - (value < 0))) {
    const uint64_t magnitude = value < 0 ? uint64_t{0} - static_cast<uint64_t>(value) : static_cast<uint64_t>(value);
    for (uint32_t k = 0; k < limbs(); ++k) limb_[k] = 0;
    for (uint32_t shift = 0; shift < 64; shift += limb_bits)
      limb_[limbs() - 64 / limb_bits + shift / limb_bits] = static_cast<Limb>(magnitude >> shift);
    exponent_ -= static_cast<int32_t>(bits - 64);
    normalise();
  }
  WideFloatOf(const WideFloatOf &other) { *this = other; }
  WideFloatOf &operator=(const WideFloatOf &other) {
    copy_scale(other);
    if (sign_ != 0) {
      for (uint32_t k = 0; k < limbs(); ++k) limb_[k] = other.limb_[k];
    }
    return *this;
  }

  // +1 or -1 if that is certain, else 0.
  int sign() const { return sign_ != 0 && top() - 1 > error_ ? sign_ : 0; }

  // The mantissa in words of 64 bits, the highest first; 0 has none.
  uint32_t words() const { return sign_ != 0 ? bits_ / 64 : 0; }
  uint64_t word(uint32_t k) const {
    uint64_t word = 0;
    for (uint32_t j = 0; j < 64 / limb_bits; ++j)
      word |= static_cast<uint64_t>(limb_[limbs() - 1 - k * (64 / limb_bits) - j]) << (64 - limb_bits * (j + 1));
    return word;
  }

  // So many words hold a number of so many bits.
  static constexpr uint32_t words_of(uint32_t bits) { return 2 + bits / 64; }
  void store(uint64_t *to) const {
    to[0] = static_cast<uint64_t>(static_cast<uint32_t>(exponent_)) << 32 | static_cast<uint32_t>(error_);
    to[1] = uint64_t{bits_} << 8 | static_cast<uint8_t>(sign_);
    for (uint32_t k = 0; k < words(); ++k) to[2 + k] = word(k);
  }
  void load(const uint64_t *from) {
    exponent_ = static_cast<int32_t>(from[0] >> 32);
    error_ = static_cast<int32_t>(static_cast<uint32_t>(from[0]));
    bits_ = static_cast<uint16_t>(from[1] >> 8);
    sign_ = static_cast<int8_t>(static_cast<uint8_t>(from[1]));
    for (uint32_t k = 0; k < words(); ++k) {
      for (uint32_t j = 0; j < 64 / limb_bits; ++j)
        limb_[limbs() - 1 - k * (64 / limb_bits) - j] = static_cast<Limb>(from[2 + k] >> (64 - limb_bits * (j + 1)));
    }
  }

  // The value without its error as mantissa 2^exponent; returns the mantissa, 1/2 <= |mantissa| <= 1. For 0: 0 and the
  // least exponent.
  double leading(int32_t &exponent) const {
    exponent = sign_ != 0 ? top() : exact;
    if (sign_ == 0) return 0.0;
    const double mantissa = static_cast<double>(word(0)) * 0x1p-64;
    return sign_ < 0 ? -mantissa : mantissa;
  }
  // The exponent e of the bound: |error| <= 2^e; `exact` or less if there is no error.
  int32_t error_exponent() const { return error_; }
  static constexpr int32_t exact = -(INT32_C(1) << 28);

  // The nearest double with its error bound. A value far below the range of doubles becomes 0, one far above uncertain.
  explicit operator BoundedDouble() const {
    int32_t exponent;
    const double mantissa = leading(exponent);
    const double value = exponent > 1000 ? std::numeric_limits<double>::infinity() : power_of_two(mantissa, exponent);
    const double error = error_ > 1000 ? std::numeric_limits<double>::infinity() : power_of_two(1.0, error_);
    return {value, error + std::fabs(value) * 0x1p-52 + std::numeric_limits<double>::min()};
  }

  WideFloatOf operator-() const {
    WideFloatOf result = *this;
    result.sign_ = static_cast<int8_t>(-sign_);
    return result;
  }
  // This number times 2^k, exactly.
  WideFloatOf scaled(int32_t k) const {
    WideFloatOf result = *this;
    result.exponent_ += k;
    if (error_ > exact) result.error_ += k;
    return result;
  }

  // The same number with more or fewer bits, and without error: for numbers that are exact.
  WideFloatOf exact_in(uint32_t bits) const {
    WideFloatOf result;
    result.copy_scale(*this);
    result.bits_ = static_cast<uint16_t>(bits);
    result.exponent_ = top() - static_cast<int32_t>(bits);
    result.error_ = exact;
    for (uint32_t k = 1; k <= result.limbs(); ++k)
      result.limb_[result.limbs() - k] = sign_ != 0 && k <= limbs() ? limb_[limbs() - k] : Limb{0};
    return result;
  }

  friend WideFloatOf operator+(const WideFloatOf &a, const WideFloatOf &b) { return sum(a, b, b.sign_); }
  friend WideFloatOf operator-(const WideFloatOf &a, const WideFloatOf &b) {
    return sum(a, b, static_cast<int8_t>(-b.sign_));
  }
  friend WideFloatOf operator*(const WideFloatOf &a, const WideFloatOf &b) { return product(a, b); }
  // If the divisor may be 0, nothing is known of the quotient.
  friend WideFloatOf operator/(const WideFloatOf &a, const WideFloatOf &b) {
    if (b.sign() == 0) return uncertain();
    return product(a, inverse(b));
  }
  // If the number may be 0 or negative, nothing is known of the root.
  friend WideFloatOf square_root(const WideFloatOf &a) {
    if (a.sign() <= 0) return uncertain();
    return root(a);
  }

 private:
  using Wide = typename exact::DoubleLimb<Limb>::type;
  static constexpr uint32_t limb_bits = sizeof(Limb) * 8, limbs_of_word = 64 / limb_bits;
  static constexpr int32_t hopeless = INT32_C(1) << 28;
  // How many bits are right at the start of Newton's method; and how many of the last bits may be wrong after its last
  // step, with room to spare.
  static constexpr uint32_t bits_of_start = 50;
  static constexpr int32_t bits_of_iteration = 12;

  uint32_t limbs() const { return bits_ / limb_bits; }
  // 2^(top - 1) <= |value| < 2^top.
  int32_t top() const { return exponent_ + bits_; }
  int32_t size() const { return sign_ != 0 ? top() : error_; }

  void copy_scale(const WideFloatOf &other) {
    exponent_ = other.exponent_;
    error_ = other.error_;
    bits_ = other.bits_;
    sign_ = other.sign_;
  }
  static WideFloatOf uncertain() {
    WideFloatOf result;
    result.error_ = hopeless;
    return result;
  }
  static int32_t larger(int32_t a, int32_t b) { return a > b ? a : b; }
  static int32_t in_range(int32_t error) { return error < exact ? exact : error > hopeless ? hopeless : error; }
  // value 2^exponent; 0 below the range of doubles.
  static double power_of_two(double value, int32_t exponent) {
    if (exponent < -1000) return 0.0;
    return value * std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << 52);
  }

  // Shifts the mantissa to the left, by whole limbs and bits, until its highest bit is set.
  void normalise() {
    uint32_t highest = limbs();
    while (highest > 0 && limb_[highest - 1] == 0) --highest;
    if (highest == 0) {
      sign_ = 0;
      return;
    }
    const uint32_t whole = limbs() - highest;
    const uint32_t bits = static_cast<uint32_t>(std::countl_zero(limb_[highest - 1]));
    if (whole == 0 && bits == 0) return;
    for (uint32_t k = limbs(); k-- > 0;) {
      const Limb high = k >= whole ? limb_[k - whole] : Limb{0};
      const Limb low = k >= whole + 1 ? limb_[k - whole - 1] : Limb{0};
      limb_[k] = joined(high, low, bits);
    }
    exponent_ -= static_cast<int32_t>(whole * limb_bits + bits);
  }
  // The upper half of (high, low) * 2^bits.
  static Limb joined(Limb high, Limb low, uint32_t bits) {
    return bits == 0 ? high : static_cast<Limb>(high << bits | low >> (limb_bits - bits));
  }

  // The sum of a and of b with the given sign. Errors: those of both; less than the last bit of the larger one for the
  // bits cut off the smaller one; and as much again if the sum is longer. Together less than 4 times the largest of
  // these.
  [[gnu::noinline]] static WideFloatOf sum(const WideFloatOf &a, const WideFloatOf &b, int8_t sign_of_b) {
    const int32_t inherited = larger(a.error_, b.error_);
    if (a.sign_ == 0 || sign_of_b == 0) {
      WideFloatOf result = a.sign_ == 0 ? b : a;
      if (a.sign_ == 0) result.sign_ = sign_of_b;
      result.error_ = inherited <= exact ? exact : in_range(inherited + 1);
      return result;
    }
    const bool swapped = b.exponent_ > a.exponent_;
    const WideFloatOf &large = swapped ? b : a, &small = swapped ? a : b;
    const bool subtract = a.sign_ != sign_of_b;
    WideFloatOf result;
    result.copy_scale(large);
    result.sign_ = swapped ? sign_of_b : a.sign_;
    result.error_ = in_range(larger(inherited, large.exponent_ + 1) + 2);
    const uint32_t shift = static_cast<uint32_t>(large.exponent_ - small.exponent_);
    const uint32_t whole = shift / limb_bits, bits = shift % limb_bits;
    // To subtract is to add the complement and 1. If the difference is negative, it is negated below.
    const uint32_t n = large.limbs(), reaching = whole < n ? n - whole : 0;
    const Limb flip = subtract ? static_cast<Limb>(~Limb{0}) : Limb{0};
    Wide carry = subtract ? 1 : 0;
    for (uint32_t k = 0; k < reaching; ++k) {
      const Limb low = small.limb_[k + whole], high = k + 1 < reaching ? small.limb_[k + whole + 1] : Limb{0};
      const Limb other = static_cast<Limb>(low >> bits | static_cast<Limb>(high << 1) << (limb_bits - 1 - bits));
      carry += static_cast<Wide>(large.limb_[k]) + static_cast<Limb>(other ^ flip);
      result.limb_[k] = static_cast<Limb>(carry);
      carry >>= limb_bits;
    }
    for (uint32_t k = reaching; k < n; ++k) {
      carry += static_cast<Wide>(large.limb_[k]) + flip;
      result.limb_[k] = static_cast<Limb>(carry);
      carry >>= limb_bits;
    }
    if (!subtract) {
      if (carry != 0) {
        for (uint32_t k = 0; k < result.limbs(); ++k) {
          const Limb high = k + 1 < result.limbs() ? result.limb_[k + 1] : Limb{1};
          result.limb_[k] = static_cast<Limb>(result.limb_[k] >> 1 | high << (limb_bits - 1));
        }
        ++result.exponent_;
      }
      return result;
    }
    if (carry == 0) {
      result.sign_ = static_cast<int8_t>(-result.sign_);
      Wide one = 1;
      for (uint32_t k = 0; k < result.limbs(); ++k) {
        one += static_cast<Limb>(~result.limb_[k]);
        result.limb_[k] = static_cast<Limb>(one);
        one >>= limb_bits;
      }
    }
    result.normalise();
    return result;
  }

  // Errors: |a| db, |b| da, da db, and little more than the last bit for the part cut off: products of words whose
  // places are too low are left out, together less than 2^-58 of the last bit. If da is as large as |a|, |b| da is far
  // more than the last bit; else da db is at most half of |a| db. Together less than 4 times the largest of these.
  [[gnu::noinline]] static WideFloatOf product(const WideFloatOf &a, const WideFloatOf &b) {
    WideFloatOf result;
    const int32_t inherited = larger(larger(a.size(), a.error_) + b.error_, b.size() + a.error_);
    if (a.sign_ == 0 || b.sign_ == 0) {
      result.copy_scale(a.sign_ == 0 ? a : b);
      result.error_ = in_range(inherited + 2);
      return result;
    }
    const uint32_t n = a.limbs();
    Limb twice[2 * most_bits / limb_bits];
    for (uint32_t k = 0; k < 2 * n; ++k) twice[k] = 0;
    uint32_t first = 0;
    while (b.limb_[first] == 0) ++first;
    for (uint32_t i = 0; i < n; ++i) {
      const Limb factor = a.limb_[i];
      if (factor == 0) continue;  // as are most limbs of an integer
      const uint32_t lower = (i / limbs_of_word + 2) * limbs_of_word, least = lower < n ? n - lower : 0;
      Limb *const to = twice + i;
      Limb carry = 0;
      for (uint32_t j = first > least ? first : least; j < n; ++j) {
        const Wide term = static_cast<Wide>(factor) * b.limb_[j] + to[j] + carry;
        to[j] = static_cast<Limb>(term);
        carry = static_cast<Limb>(term >> limb_bits);
      }
      to[n] = carry;
    }
    result.bits_ = a.bits_;
    result.sign_ = static_cast<int8_t>(a.sign_ * b.sign_);
    const uint32_t bit = twice[2 * n - 1] >> (limb_bits - 1) != 0 ? 0 : 1;
    for (uint32_t k = 0; k < n; ++k) result.limb_[k] = joined(twice[n + k], twice[n + k - 1], bit);
    result.exponent_ = a.exponent_ + b.exponent_ + a.bits_ - static_cast<int32_t>(bit);
    result.error_ = in_range(larger(inherited, result.exponent_) + 2);
    return result;
  }

  // From a double between 1/2 and 2.
  static WideFloatOf of_double(double value, uint32_t bits) {
    return WideFloatOf(static_cast<int64_t>(value * 0x1p60), bits, -60);
  }
  // A step of Newton's method doubles the number of right bits, but for rounding. bits_of_step(): the bits that its
  // numbers need.
  static uint32_t bits_after_step(uint32_t right) { return 2 * right - 2; }
  static uint32_t bits_of_step(uint32_t right, uint32_t bits) {
    const uint32_t more = (2 * right / 64 + 1) * 64;
    return more < bits ? more : bits;
  }
  // 1 / b by Newton's method for the mantissa c, 1/2 <= c < 1, which as a number has the exponent -bits.
  [[gnu::noinline]] static WideFloatOf inverse(const WideFloatOf &b) {
    int32_t size;
    const double mantissa = b.leading(size);
    WideFloatOf x = of_double(std::fabs(1.0 / mantissa), 64);
    for (uint32_t right = bits_of_start; right < b.bits_; right = bits_after_step(right)) {
      const uint32_t bits = bits_of_step(right, b.bits_);
      x = x.exact_in(bits);
      WideFloatOf step = b.exact_in(bits);
      step.sign_ = 1;
      step.exponent_ = -static_cast<int32_t>(bits);
      step = product(step, x);
      step = WideFloatOf(2, bits) - step;
      x = product(x, step);
    }
    x.sign_ = b.sign_;
    x.exponent_ -= size;
    const int32_t own = x.exponent_ + bits_of_iteration;
    // |1/b - 1/b'| = |b - b'| / |b b'|, and |b'| is at least half of the least |b|.
    x.error_ = in_range(larger(own, b.error_ - 2 * (size - 1) + 1) + 1);
    return x;
  }
  // sqrt(a) for a = c 4^half with 1/2 <= c < 2: Newton's method finds 1 / sqrt(c), and sqrt(c) = c / sqrt(c).
  [[gnu::noinline]] static WideFloatOf root(const WideFloatOf &a) {
    int32_t size;
    double mantissa = a.leading(size);
    const bool odd = (size & 1) != 0;
    const int32_t half = (size - (odd ? 1 : 0)) / 2;
    if (odd) mantissa *= 2;
    WideFloatOf y = of_double(1.0 / std::sqrt(mantissa), 64);
    WideFloatOf c;
    for (uint32_t right = bits_of_start;; right = bits_after_step(right)) {
      const uint32_t bits = bits_of_step(right, a.bits_);
      c = a.exact_in(bits);
      c.exponent_ = -static_cast<int32_t>(bits) + (odd ? 1 : 0);
      if (right >= a.bits_) break;
      y = y.exact_in(bits);
      WideFloatOf step = product(y, y);
      step = product(c, step);
      step = WideFloatOf(3, bits) - step;
      y = product(y, step).scaled(-1);
    }
    y = product(c, y);
    y.exponent_ += half;
    // |sqrt(a) - sqrt(a')| = |a - a'| / (sqrt(a) + sqrt(a')).
    const int32_t own = y.exponent_ + bits_of_iteration;
    y.error_ = in_range(a.error_ <= exact ? own : larger(own, a.error_ - (y.top() - 1)) + 1);
    return y;
  }

  int32_t exponent_ = 0;
  int32_t error_ = exact;
  uint16_t bits_ = 64;
  int8_t sign_ = 0;
  Limb limb_[most_bits / limb_bits];  // lowest first; only those of bits_ are set, and none for 0
};

using WideFloat = WideFloatOf<exact::FastLimb>;

}  // namespace hsp
