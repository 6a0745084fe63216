// Decides by integers on which side of a cap's plane a vertex of the polyhedron is, where doubles are not certain. This
// is so where many planes go through one point, as the planes of spheres through one point do. All balls are inflated
// as in exact/PROOFS.md, section 3, so that there is always an answer; the polyhedron is that of the inflated balls
// (section 7).
#pragma once

#include "sphere/caps.hpp"
#include "sphere/outer_cell.hpp"

namespace hsp {

// A set of vertices of a polyhedron, a bit for each.
struct VertexBits {
  uint64_t word[2] = {0, 0};

  bool empty() const { return (word[0] | word[1]) == 0; }
  bool contains(const VertexBits &other) const {
    return ((other.word[0] & ~word[0]) | (other.word[1] & ~word[1])) == 0;
  }
};

class CellTies {
 public:
  explicit CellTies(const Caps &caps) : caps_(caps) {}

  // For the caps with these numbers, of which none is a face: decides all vertices of which `sides` is unsure, and adds
  // to `on_plane` those that lie on the cap's plane before the inflation. `sides` and `on_plane` have an entry for each
  // cap. Cold: few sets get here, and nearly all of it is exact questions.
  [[gnu::cold]] void decide(const OuterCell &cell, Span<const uint32_t> numbers, VertexSides *sides,
                            VertexBits *on_plane) const;

 private:
  // The plane of a face: that of its cap, or a side of the cube.
  exact::Plane plane_of(const OuterCell &cell, uint32_t face) const;

  const Caps &caps_;
};

// Sets of vertices: each is all vertices that lie on the plane of some cap.
class TiedSets {
 public:
  static constexpr uint32_t most = 16;

  // The number of a set, which is added if it is new; `most` if there is no room.
  uint32_t number_of(const VertexBits &set);
  // Whether some cap is kept whose plane goes through all vertices of the set.
  bool is_kept(uint32_t number) const { return (kept_ >> number & 1U) != 0; }
  // Notes that a cap is kept whose plane goes through the vertices of the set.
  void keep(uint32_t number);

 private:
  VertexBits set_[most];
  uint32_t count_ = 0;
  uint32_t kept_ = 0;  // bits of sets
};

}  // namespace hsp
