#include "difference_quotients.hpp"

#include <cmath>

DifferenceQuotient extrapolated_quotient(std::span<const long double, quotient_levels> differences, long double h,
                                         long double noise) {
  // column[k] holds the extrapolation from the steps k - m .. k; spread[k] the sum of the sizes of the weights of the
  // differences in it.
  std::array<long double, quotient_levels> column{};
  std::array<long double, quotient_levels> spread{};
  for (size_t k = 0; k < quotient_levels; ++k) {
    const long double step = std::ldexp(h, -static_cast<int>(k));
    column[k] = differences[k] / (2 * step);
    spread[k] = 1 / (2 * step);
  }
  long double without_widest = 0;
  for (size_t m = 1; m < quotient_levels; ++m) {
    const long double power = std::ldexp(1.0L, 2 * static_cast<int>(m));
    without_widest = column[quotient_levels - 1];
    for (size_t k = quotient_levels - 1; k >= m; --k) {
      column[k] = (power * column[k] - column[k - 1]) / (power - 1);
      spread[k] = (power * spread[k] + spread[k - 1]) / (power - 1);
    }
  }
  const long double best = column[quotient_levels - 1];
  return {best, std::abs(best - without_widest) + spread[quotient_levels - 1] * noise};
}
