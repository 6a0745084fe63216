// The part of a boundary whose smooth surface is asked for: all of it, or some of its shells, such as those of one
// region of the complement. That region is then all the room that a probe has. The other part of the boundary has its
// own surface, as if it were alone: no probe of one part cuts a patch of the other.
#pragma once

#include "boundary/boundary.hpp"
#include "core/ranked_bits.hpp"

namespace hsp {

class ChosenFaces {
 public:
  void carve(Workspace &workspace, uint32_t faces) { faces_.carve(workspace, faces); }

  void choose_all() { all_ = true; }
  // The faces of these shells. scratch [shells of the boundary]
  void choose(const Boundary &boundary, Span<const uint32_t> shells, Span<uint32_t> scratch) {
    all_ = false;
    for (uint32_t s = 0; s < boundary.shell_count(); ++s) scratch[s] = 0;
    for (const uint32_t s : shells) scratch[s] = 1;
    faces_.clear(boundary.face_count());
    for (uint32_t f = 0; f < boundary.face_count(); ++f) {
      if (scratch[boundary.face(f).shell] != 0) faces_.set(f);
    }
  }

  bool all() const { return all_; }
  bool has(uint32_t face) const { return all_ || faces_.has(face); }
  // Whether both are chosen, or neither is.
  bool together(uint32_t face, uint32_t other) const { return has(face) == has(other); }

 private:
  bool all_ = true;
  RankedBits faces_;
};

// One of the faces at a vertex. All of them are of one shell.
inline uint32_t face_at_vertex(const Boundary &boundary, uint32_t vertex) {
  return boundary.face_of(boundary.half_edge_at(vertex, 0));
}

// Whether the probe at `other` has to be considered for the patch of `vertex`. Probes of other components of the union
// cut nothing that no probe of this one cuts (PROOFS.md, section 5).
inline bool may_cut(const Boundary &boundary, const ChosenFaces &chosen, uint32_t vertex, uint32_t other) {
  return boundary.component(boundary.vertex(other).ball[0]) == boundary.component(boundary.vertex(vertex).ball[0]) &&
         (chosen.all() || chosen.together(face_at_vertex(boundary, other), face_at_vertex(boundary, vertex)));
}

}  // namespace hsp
