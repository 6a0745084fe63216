// The search for probes that may cut one probe's triangle, in floats: no probe that does is left out, and few others
// are found.
//
// Lengths are in units of the side of the cubes that the probes are sorted by, positions relative to one point. With q
// the vector from this vertex to the other one, t the probe's diameter, g the normals of the triangle's sides and d its
// corners: the other probe overlaps this one iff |q| < t, and cuts off the directions w with w.q/|q| > |q|/t. No corner
// is ever cut off, as it lies on a ball. So something of the triangle is cut off only
//   if q lies over it, q.g_k >= 0 for all k, or
//   if for some side k with ends a and b  q.g_k < 0, (q.g_k)^2 < q^2 (1 - q^2/t^2), so that the cap reaches it, and
//      what is nearest to q lies between the ends: q.(d_b - (d_a.d_b) d_a) > 0 and q.(d_a - (d_a.d_b) d_b) > 0.
// Each coordinate of q has an error of at most `error`, and other numbers have errors of that order. The margins below
// cover these errors and the roundings (lengths are at most 1.1):
//   q.g, q.d            2 error + 8e, e = 2^-24                   less than margin = 4 error + 2^-19
//   combinations        twice that and two roundings              2 margin
//   squares             2.2 (2 error + 8e) + 8e twice             8 margin
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

struct ProbeRange {
  uint32_t first, last;
};

struct ProbeSearch {
  // How many probes one call finds at most, and how many more places it may write behind them.
  static constexpr uint32_t room = 64;
  static constexpr uint32_t spare = 8;

  const float *x, *y, *z;  // of all probes, by cubes
  const uint32_t *vertex;

  float own[3];
  float square_of_reach;          // probes at least so far away certainly do not overlap this one
  float inverse_square_of_reach;  // 1/t^2
  float margin;
  float inward[3][3], corner[3][3], cosine[3];

  // Where to look. A row of cubes may be two ranges.
  ProbeRange range[18];
  uint32_t ranges = 0;
  uint32_t at = 0;  // the range at hand, whose first moves on

  bool done() const { return at == ranges; }
};

// Searches on until all ranges are done or `found` has no more room. Returns how many vertices are in `found`. found
// [room + spare].
HSP_KERNEL(uint32_t, find_near_probes, (ProbeSearch & search, uint32_t *found), (search, found))

// Calls visit(vertex) for all of them.
template <class Visit>
void for_each_near_probe(Target target, ProbeSearch &search, Visit visit) {
  uint32_t found[ProbeSearch::room + ProbeSearch::spare];
  while (!search.done()) {
    const uint32_t count = find_near_probes(target, search, found);
    for (uint32_t k = 0; k < count; ++k) visit(found[k]);
  }
}

}  // namespace hsp
