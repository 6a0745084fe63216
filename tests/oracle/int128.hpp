// Integers of 128 bits, with and without a sign: those of the compiler, or two words where it has none, as for
// processors with 32 bits. The oracles are then slower, and the same.
#pragma once

#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>

namespace oracle {

// Modulo 2^128 like the compiler's own; there is no division. Shifts are by 0 to 127 bits.
template <bool has_sign>
class TwoWords {
 public:
  constexpr TwoWords() = default;
  template <std::integral Number>
  constexpr TwoWords(Number value) : low_(static_cast<uint64_t>(value)), high_(value < 0 ? ~uint64_t{0} : 0) {}
  template <std::floating_point Number>
  explicit TwoWords(Number value) {  // what stands before the point; its size is below 2^127
    Number left = std::fabs(value);
    for (int bit = 127; bit-- > 0;) {
      const Number place = std::ldexp(Number{1}, bit);
      if (left < place) continue;
      left -= place;
      *this += TwoWords(1) << bit;
    }
    if (value < 0) *this = -*this;
  }
  constexpr explicit TwoWords(const TwoWords<!has_sign> &other)
      : low_(static_cast<uint64_t>(other)), high_(static_cast<uint64_t>(other >> 64)) {}

  template <std::integral Number>
  constexpr explicit operator Number() const {
    return static_cast<Number>(low_);
  }
  template <std::floating_point Number>
  explicit operator Number() const {
    if (is_negative()) return -static_cast<Number>(TwoWords<false>(-*this));
    // The lower word may round, and then the sum: within one unit in the last place.
    return std::ldexp(static_cast<Number>(high_), 64) + static_cast<Number>(low_);
  }

  friend constexpr bool operator==(const TwoWords &a, const TwoWords &b) = default;
  friend constexpr std::strong_ordering operator<=>(const TwoWords &a, const TwoWords &b) {
    if (a.is_negative() != b.is_negative()) {
      return a.is_negative() ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    return a.high_ != b.high_ ? a.high_ <=> b.high_ : a.low_ <=> b.low_;
  }

  constexpr TwoWords operator-() const { return TwoWords() - *this; }
  friend constexpr TwoWords operator+(const TwoWords &a, const TwoWords &b) {
    const uint64_t low = a.low_ + b.low_;
    return of_words(low, a.high_ + b.high_ + (low < a.low_ ? 1 : 0));
  }
  friend constexpr TwoWords operator-(const TwoWords &a, const TwoWords &b) {
    return of_words(a.low_ - b.low_, a.high_ - b.high_ - (a.low_ < b.low_ ? 1 : 0));
  }
  friend constexpr TwoWords operator*(const TwoWords &a, const TwoWords &b) {
    const uint64_t half = 0xFFFFFFFFU;
    const uint64_t across = (a.low_ >> 32) * (b.low_ & half), lowest = (a.low_ & half) * (b.low_ & half);
    const uint64_t middle = (a.low_ & half) * (b.low_ >> 32) + (across & half) + (lowest >> 32);
    const uint64_t carried = (a.low_ >> 32) * (b.low_ >> 32) + (across >> 32) + (middle >> 32);
    return of_words(middle << 32 | (lowest & half), carried + a.high_ * b.low_ + a.low_ * b.high_);
  }
  friend constexpr TwoWords operator<<(const TwoWords &a, int64_t bits) {
    if (bits == 0) return a;
    if (bits >= 64) return of_words(0, a.low_ << (bits - 64));
    return of_words(a.low_ << bits, a.high_ << bits | a.low_ >> (64 - bits));
  }
  friend constexpr TwoWords operator>>(const TwoWords &a, int64_t bits) {
    const uint64_t fill = a.is_negative() ? ~uint64_t{0} : 0;
    if (bits == 0) return a;
    if (bits == 64) return of_words(a.high_, fill);
    if (bits > 64) return of_words(a.high_ >> (bits - 64) | fill << (128 - bits), fill);
    return of_words(a.low_ >> bits | a.high_ << (64 - bits), a.high_ >> bits | fill << (64 - bits));
  }
  constexpr TwoWords &operator+=(const TwoWords &other) { return *this = *this + other; }
  constexpr TwoWords &operator-=(const TwoWords &other) { return *this = *this - other; }
  constexpr TwoWords &operator*=(const TwoWords &other) { return *this = *this * other; }
  constexpr TwoWords &operator<<=(int64_t bits) { return *this = *this << bits; }
  constexpr TwoWords &operator>>=(int64_t bits) { return *this = *this >> bits; }

 private:
  static constexpr TwoWords of_words(uint64_t low, uint64_t high) {
    TwoWords result;
    result.low_ = low;
    result.high_ = high;
    return result;
  }
  [[nodiscard]] constexpr bool is_negative() const { return has_sign && high_ >> 63 != 0; }

  uint64_t low_ = 0, high_ = 0;
};

#ifdef __SIZEOF_INT128__
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;
#else
using Int128 = TwoWords<true>;
using UInt128 = TwoWords<false>;
#endif

}  // namespace oracle
