// The terms of chords in areas of their three contacts, from exact polynomials that are rounded once (chord_line.hpp):
// in integers, or four at a time with numbers of two doubles (lanes/twofold.hpp), which gives the same bits, or none
// where that is not certain.
//
// With the polynomials of chord_line.hpp, errors of the numbers of two doubles in units of u^2, where u = 2^-53. All h,
// dot products, n and z are exact. M = N + |h_P v.v| + |h_Q u.v| + |h_Q u.u| + |h_P u.v| bounds N, alpha and beta.
//   N             each square: 1 left out, 3 by rounding; four sums of at most 5 u N                            24 M
//   alpha, beta   products: 1 left out, 5 by rounding; sums of at most 6 and 8 u M                              20 M
//   2 N - alpha - beta   at most 64 M from its terms, sums of at most 4, 8, 10 and 16 u M                      102 M
//   A = N h_R - alpha u.z - beta v.z, with S = M (|h_R| + |u.z| + |v.z|):
//                 30 from its terms and products, sums of at most 3, 4, 5 and 6 u S                             48 S
//   B = n.z       with T = |n_x z_x| + |n_y z_y| + |n_z z_z|: products 2, sums of at most 4 u T in all          12 T
// All are taken to be below 256 = 2^-98 / u^2, which has room for the roundings of M, S and T and of the test.
#pragma once

#include "model/ball_set.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

struct ChordBatch {
  static constexpr uint32_t capacity = 16;  // a multiple of four

  uint32_t count = 0;
  uint32_t ball[3][capacity];     // the two later ones last
  uint32_t clipper[2][capacity];  // the ball that clips the end at the side of p- and of p+, or any other ball
  double free_end[2][capacity];   // where the chord ends if nothing clips it, -sqrt(D) or sqrt(D); else not a number
  uint32_t vertex[capacity];      // the caller's, of the boundary, at a free end
  uint32_t contact[3][capacity];  // the caller's, of the balls 0 1, 0 2 and 1 2

  // Terms that the chord adds to half the sum of distance times length over the chords of each contact, times the
  // distance of the two balls.
  double part[3][capacity];

  // Makes chord `to` the same as another one, but for its contacts.
  void repeat(uint32_t from, uint32_t to) {
    for (auto &of_chord : ball) of_chord[to] = of_chord[from];
    for (auto &of_chord : clipper) of_chord[to] = of_chord[from];
    for (auto &of_chord : free_end) of_chord[to] = of_chord[from];
  }
};

// Chord s of a batch.
void measure_in_integers(const BallSet &balls, ChordBatch &batch, uint32_t s);
// The first `count` ones, a multiple of four, which may be more than there are but of balls that are there. A bit for
// each that is not certain: for all where numbers of two doubles are not faster than integers.
HSP_KERNEL(uint32_t, measure_in_lanes, (const BallArrays &balls, ChordBatch &batch, uint32_t count),
           (balls, batch, count))

}  // namespace hsp
