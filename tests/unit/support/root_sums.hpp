// Signs of sums with square roots, by digits: roots are worked out in binary places until the rest cannot matter.
#ifndef HARDSPHERE_TESTS_INNER_ROOT_SUMS_HPP
#define HARDSPHERE_TESTS_INNER_ROOT_SUMS_HPP

#include <cstdint>

#include "lattice_ball.hpp"

/// Sign of E + T sqrt(b) for 64-bit numbers with |T| < 2^31 and 0 <= b < 2^60.
int sign_of_sum_with_root(std::int64_t E, std::int64_t T, std::int64_t b);

/// Sign of z + sqrt(b) - sqrt(a) for 0 <= a, b < 2^60.
int sign_of_root_difference(std::int64_t z, std::int64_t b, std::int64_t a);

#endif
