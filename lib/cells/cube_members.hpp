// The balls that meet one cube, as numbers side by side, for the questions about each of them and all others. For
// registers of n doubles: power_cell.cpp and wide_cells_avx2.cpp compile it, and both find the same bits.
#pragma once

#include "core/double_lanes.hpp"

namespace hsp {

// From the centre of the cube to that of a ball, its radius, and the square of the one less that of the other. Behind
// the last ball there is room for a multiple of four.
struct MemberArrays {
  const double *x, *y, *z, *radius, *power;
  uint32_t count;
};
// A plane that may cut a power cell. Its squared distance from the ball's centre, with the sign of that: negative if
// the centre is beyond.
struct PlaneCandidate {
  double distance;
  uint32_t member;
};

#if HSP_AVX2
uint32_t list_candidates_avx2(const MemberArrays &members, const uint64_t *in_game, uint32_t own, double limit,
                              PlaneCandidate *candidates);
uint64_t find_dominance_avx2(const MemberArrays &members, uint32_t a, uint32_t first, double side, double doubt);
#endif

namespace {

// The planes between a ball and all others in the game, of which in_game has bits, whose squared distance is no larger
// than a limit, in their order. Room for four more than all. Returns how many.
template <uint32_t n>
inline uint32_t list_candidates(const MemberArrays &members, const uint64_t *in_game, uint32_t own, double limit,
                                PlaneCandidate *candidates) {
  using L = DoubleLanes<n>;
  using Real = typename L::Real;
  const Real x = L::all(members.x[own]), y = L::all(members.y[own]), z = L::all(members.z[own]);
  const Real radius = L::all(members.radius[own]), most = L::all(limit);
  const uint32_t count = members.count;
  uint32_t found = 0;
  for (uint32_t first = 0; first < count; first += n) {
    const Real vx = L::load(members.x + first) - x, vy = L::load(members.y + first) - y;
    const Real vz = L::load(members.z + first) - z, other = L::load(members.radius + first);
    const Real length = vx * vx + vy * vy + vz * vz;
    const Real h = length + (radius - other) * (radius + other);
    const Real distance = h * L::absolute(h) / length;
    double distances[n];
    L::store(distances, distance);
    // That of the ball itself is not a number.
    const uint64_t near = L::set_lanes(distance <= most) & (in_game[first / 64] >> first % 64);
    for (uint32_t lane = 0; lane < n; ++lane) {
      candidates[found] = {distances[lane], first + lane};
      found += static_cast<uint32_t>(near >> lane & 1);
    }
  }
  return found;
}

// Of up to 64 balls from number `first` on a bit for each: whether one of it and ball a may have less power than the
// other all over the cube of this side, or both have one centre.
template <uint32_t n>
inline uint64_t find_dominance(const MemberArrays &members, uint32_t a, uint32_t first, double side, double doubt) {
  using L = DoubleLanes<n>;
  using Real = typename L::Real;
  const Real x = L::all(members.x[a]), y = L::all(members.y[a]), z = L::all(members.z[a]);
  const Real power = L::all(members.power[a]), sides = L::all(side), doubts = L::all(doubt), zero = L::all(0.0);
  const uint32_t left = members.count - first, count = left < 64 ? left : 64;
  uint64_t found = 0;
  for (uint32_t k = 0; k < count; k += n) {
    const uint32_t b = first + k;
    const Real mean = L::absolute(L::load(members.power + b) - power);
    const Real spread = sides * (L::absolute(L::load(members.x + b) - x) + L::absolute(L::load(members.y + b) - y) +
                                 L::absolute(L::load(members.z + b) - z));
    found |= (L::set_lanes(mean > spread + doubts) | L::set_lanes(spread == zero)) << k;
  }
  return found & (~UINT64_C(0) >> (64 - count));
}

}  // namespace
}  // namespace hsp
