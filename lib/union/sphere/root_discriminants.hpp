// sqrt(D) of vertices, four at a time with numbers of two doubles (lanes/twofold.hpp). A root has the same bits as from
// exact::discriminant(), whose D is rounded once; where that is not certain, there is none.
//
// With h, v of the planes 1 and 2, n = v1 x v2 and q = h1 v2 - h2 v1, D = W n.n - q.q. Errors in units of u^2 A, where
// u = 2^-53 and A = W |v1|^2 |v2|^2. As balls that meet have |h| <= 2 r |v|, P = |h1| |v2| + |h2| |v1| has P^2 <= 4 A;
// n.n <= |v1|^2 |v2|^2. All v, h, n and W are integers below 2^63 in size. As sums of two doubles they are exact; the
// second double is at most u times the number. The sum of two doubles is split exactly, a product by a fused operation.
// Operations on second doubles are rounded, and the product of two second doubles is left out.
//   n.n       each square: 1 left out, 3 by rounding; four sums of at most 5 u n.n: 20                          24
//   W n.n     6 left out, 15 by rounding, 24 from n.n                                                           45
//   q         components: 2 + 2 + 3 times u^2 (|h1 v2| + |h2 v1|), their second doubles below 4 u of the same
//   q.q       squares: 14 from q, 16 left out, 9 by rounding; four sums of at most 11 u P^2: 44; as P^2 <= 4 A  332
//   D         a difference of at most 52 u A and a sum of at most 57 u A                                        109
// Together 486 u^2 A < 2^-97 A. D is taken if D + 2^-96 A and D - 2^-96 A are rounded to the same number; the
// difference of the two bounds has room for the roundings of A and of this test. A D of 0 is left to integers. Nothing
// over- or underflows.
#pragma once

#include "sphere/near_balls.hpp"

namespace hsp {

inline constexpr double doubtful_root = -1.0;

// Writes sqrt(D), or doubtful_root, for the first of `count` vertices, as many as are a multiple of four. A vertex has
// four words, its balls first. Returns whether all of these are certain. done: how many these are; 0 where numbers of
// two doubles are not faster than integers.
HSP_KERNEL(bool, find_roots_in_lanes,
           (const BallArrays &balls, const uint32_t *vertices, uint32_t count, double *roots, uint32_t &done),
           (balls, vertices, count, roots, done))

}  // namespace hsp
