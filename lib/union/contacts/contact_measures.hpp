// Areas and rims of contacts, and the volumes that they add to shares, from the sums over their chords and arcs. These
// need exact polynomials, each rounded once: computed in integers, or for four contacts at a time with numbers of two
// doubles (lanes/twofold.hpp), if it is certain that these give the same bits.
//
// Errors of the numbers of two doubles in units of u^2 S, where u = 2^-53, for Delta = W v.v - h^2 and S = W v.v + h^2:
// products 1 and 1 left out, 5 and 3 by rounding; a difference of at most 6 u S and a sum of at most 7 u S. 256 = 2^-98
// / u^2 is used.
#pragma once

#include "model/ball_set.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

struct ContactMeasures {
  static constexpr uint32_t capacity = 4;

  uint32_t ball[2][capacity];
  // On entry: half the sum of distance times length over the chords, times the distance of the balls. Then: the area.
  double area[capacity];
  // On entry: the angle of the free part of the circle. Then: its length.
  double rim[capacity];
  // Three times the volumes of the cones over the contact, with their tips in the two centres.
  double cone[2][capacity];
};

// Measures contact s. Returns whether the two balls only touch.
bool measure_contact_in_integers(const BallSet &balls, ContactMeasures &contacts, uint32_t s);
// Measures all four. False if one of them is not certain, or numbers of two doubles are not faster than integers; then
// all are left as they were.
HSP_KERNEL(bool, measure_contacts_in_lanes, (const BallArrays &balls, ContactMeasures &contacts), (balls, contacts))

}  // namespace hsp
