// Derivatives by central differences and Richardson extrapolation, with bounds on their errors.
#pragma once

#include <array>
#include <cstddef>
#include <span>

struct DifferenceQuotient {
  long double value = 0;
  long double error = 0;  // of truncation and rounding together
};

// How many step lengths one extrapolation takes.
inline constexpr size_t quotient_levels = 4;

// differences[k] = f(x + h / 2^k) - f(x - h / 2^k), each wrong by at most `noise`. Their quotients have expansions in
// even powers of the step, of which three terms are eliminated (Richardson).
//
// The error of the extrapolation from four steps is taken to be its distance from the extrapolation that leaves the
// widest step out. This distance is h^6 / 4096 times the sixth Taylor coefficient of f', while the true error is h^8 /
// 4096 times the eighth: where f is analytic within 2 h of x the distance is the larger, as a rule by a factor of 4.
// If f is not analytic (an arc that is born within the steps makes a term like a power 3/2) the quotients do not
// settle, and the distance is as large as their error.
DifferenceQuotient extrapolated_quotient(std::span<const long double, quotient_levels> differences, long double h,
                                         long double noise);
