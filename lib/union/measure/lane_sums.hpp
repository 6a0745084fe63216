// Adds up the lanes of sums, in one order for registers of every width.
#pragma once

#include "lanes/wide.hpp"
#include "measure/arc_sums.hpp"

namespace hsp {
namespace {

inline double sum_of_lanes(const double (&lanes)[sum_lanes]) {
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

// Four sums; of each, n of its lanes.
template <uint32_t n>
struct FourSums {
  using L = Wide<double, n>;
  using Real = typename L::Real;

  Real a = L::all(0.0), b = L::all(0.0), c = L::all(0.0), d = L::all(0.0);
};
// Adds up all lanes of each sum, with the bits of sum_of_lanes().
template <uint32_t n>
void store_sums(const FourSums<n> (&parts)[sum_lanes / n], double (&sums)[4]) {
  using L = Wide<double, n>;
  if constexpr (n == sum_lanes) return L::store_sums_of_four(sums, parts[0].a, parts[0].b, parts[0].c, parts[0].d);
  double a[sum_lanes], b[sum_lanes], c[sum_lanes], d[sum_lanes];
  for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
    const FourSums<n> &part = parts[lane / n];
    L::store(a + lane, part.a);
    L::store(b + lane, part.b);
    L::store(c + lane, part.c);
    L::store(d + lane, part.d);
  }
  sums[0] = sum_of_lanes(a);
  sums[1] = sum_of_lanes(b);
  sums[2] = sum_of_lanes(c);
  sums[3] = sum_of_lanes(d);
}

}  // namespace
}  // namespace hsp
