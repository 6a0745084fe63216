#include "root_sums.hpp"

#include <cmath>

#include "big_integer.hpp"

namespace {

using oracle::BigInteger;
using oracle::Int128;

// Roots are integers in units of 2^-places, rounded down, so that a sum of two of them is less than 2 units off. A sum
// that is not 0 is far larger than that. For the product of its at most four variants with all signs of the roots is an
// integer. Either this integer is not 0, and where terms cancel no variant exceeds 2^65 (2^33 if there are two roots);
// or a variant is 0, and then the roots are integers themselves.
constexpr unsigned places = 110;

/// The largest integer whose square is at most n 4^places, for n < 2^122.
BigInteger root(Int128 n) {
  const BigInteger square = BigInteger(n).times_power_of_two(2 * places);
  BigInteger result;
  BigInteger rest = square;  // square - result^2
  for (unsigned bit = places + 62; bit-- > 0;) {
    // (result + 2^bit)^2 = result^2 + result 2^(bit + 1) + 4^bit
    const BigInteger longer = result.times_power_of_two(bit + 1) + BigInteger(1).times_power_of_two(2 * bit);
    if ((rest - longer).sign() < 0) continue;
    rest = rest - longer;
    result = result + BigInteger(1).times_power_of_two(bit);
  }
  return result;
}

int sign_up_to_rounding(const BigInteger &units) {
  if ((units - BigInteger(2)).sign() > 0) return 1;
  if ((units + BigInteger(2)).sign() < 0) return -1;
  return 0;
}

BigInteger in_units(std::int64_t value) {
  return BigInteger(value).times_power_of_two(places);
}

}  // namespace

int sign_of_sum_with_root(std::int64_t E, std::int64_t T, std::int64_t b) {
  const BigInteger term = root(Int128{T} * T * b);
  return sign_up_to_rounding(in_units(E) + (T < 0 ? -term : term));
}

int sign_of_root_difference(std::int64_t z, std::int64_t b, std::int64_t a) {
  // Most questions need no digits: the error is far below 1.
  const long double estimate =
      static_cast<long double>(z) + std::sqrt(static_cast<long double>(b)) - std::sqrt(static_cast<long double>(a));
  if (std::fabs(estimate) > 1.0L) return estimate > 0.0L ? 1 : -1;
  return sign_up_to_rounding(in_units(z) + root(b) - root(a));
}
