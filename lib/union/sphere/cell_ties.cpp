// Sides of vertices by integers.
//
// As an example four balls of radius 5 around points 5 away from the origin, each of whose spheres goes through it.
// For the first of them the planes of the others meet in one point, and of the inflated ones any three in a point
// nearby, which the fourth plane leaves out or not.
#include "sphere/cell_ties.hpp"

namespace hsp {

void CellTies::decide(const OuterCell &cell, uint32_t cap, VertexSides &sides, VertexBits &on_plane) const {
  const exact::Plane plane = caps_.plane(cap);
  const auto plane_of = [&](uint32_t face) {
    if (cell.cap[face] != no_id) return caps_.plane(cell.cap[face]);
    const auto part = [](double u) { return static_cast<int64_t>(u) * OuterCell::side_denominator; };
    return exact::virtual_plane({part(cell.ux[face]), part(cell.uy[face]), part(cell.uz[face])},
                                2 * caps_.balls().ball(caps_.origin).radius * OuterCell::side_numerator);
  };
  for (uint32_t word = 0; word < 2; ++word) {
    for (uint64_t left = sides.unsure[word]; left != 0; left &= left - 1) {
      const uint64_t bit = left & (~left + 1);
      const uint8_t *const face = cell.face[64 * word + static_cast<uint32_t>(__builtin_ctzll(left))];
      const exact::Sign nearer = predicates_.near(plane_of(face[0]), plane_of(face[1]), plane_of(face[2]), plane);
      if (nearer.sign < 0) sides.outside[word] |= bit;
      if (nearer.tied) on_plane.word[word] |= bit;
    }
    sides.unsure[word] = 0;
  }
}

uint32_t TiedSets::number_of(const VertexBits &set) {
  for (uint32_t k = 0; k < count_; ++k) {
    if (set_[k].contains(set) && set.contains(set_[k])) return k;
  }
  if (count_ == most) return most;
  set_[count_] = set;
  return count_++;
}

void TiedSets::keep(uint32_t number) {
  for (uint32_t k = 0; k < count_; ++k) kept_ |= set_[number].contains(set_[k]) ? 1U << k : 0U;
}

}  // namespace hsp
