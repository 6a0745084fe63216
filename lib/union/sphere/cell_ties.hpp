// On which side of a cap's plane the vertices of a polyhedron are, by integers, where doubles are not sure: planes that
// go through one point, as those of spheres that do. All balls are inflated as in exact/PROOFS.md, section 3, so that
// there is always an answer; the polyhedron is that of the inflated balls (section 7).
#pragma once

#include "sphere/caps.hpp"
#include "sphere/outer_cell.hpp"

namespace hsp {

// Bits of vertices.
struct VertexBits {
  uint64_t word[2] = {0, 0};

  bool empty() const { return (word[0] | word[1]) == 0; }
  bool contains(const VertexBits &other) const {
    return ((other.word[0] & ~word[0]) | (other.word[1] & ~word[1])) == 0;
  }
};

class CellTies {
 public:
  // All |v|^2 of the caps are at most so large.
  CellTies(const Caps &caps, double length_squared)
      : caps_(caps), predicates_(caps.sphere, length_squared > of_sides ? length_squared : of_sides) {}

  // Decides about the vertices of which `sides` is unsure, for a cap whose plane is no face, and finds those through
  // which the plane goes before the inflation. Cold: few sets get here, and nearly all of it is exact questions.
  [[gnu::cold]] void decide(const OuterCell &cell, uint32_t cap, VertexSides &sides, VertexBits &on_plane) const;

 private:
  static constexpr double of_sides = OuterCell::side_numerator * OuterCell::side_numerator;  // then h <= L^2, too

  const Caps &caps_;
  exact::Predicates predicates_;
};

// The sets of vertices that planes go through.
class TiedSets {
 public:
  static constexpr uint32_t most = 16;

  // The number of a set; `most` if there are too many.
  uint32_t number_of(const VertexBits &set);
  // Whether a plane goes through all of them that is kept.
  bool is_kept(uint32_t number) const { return (kept_ >> number & 1U) != 0; }
  // Keeps a plane through these.
  void keep(uint32_t number);

 private:
  VertexBits set_[most];
  uint32_t count_ = 0;
  uint32_t kept_ = 0;  // bits
};

}  // namespace hsp
