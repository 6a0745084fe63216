#include "surface/surface_shells.hpp"

namespace hsp {

void SurfaceShells::find(const Boundary &boundary, const CuspedCircles &cusped, const CutPatches &cut,
                         Patience &patience) {
  faces_ = boundary.face_count();
  const uint32_t nodes = faces_ + cut.piece_count();
  DisjointSets sets(shell_.part(0, nodes));
  sets.reset();
  join_saddles(boundary, cusped, patience, sets);
  if (!patience.allows(100 * uint64_t{nodes})) return;
  join_pieces(boundary, cut, patience, sets);
  if (!patience.allows(50 * uint64_t{nodes})) return;
  sets.flatten();
  // No representative is larger than a member of its set, so it has its shell already.
  count_ = 0;
  for (uint32_t k = 0; k < nodes; ++k) {
    shell_[k] = shell_[k] == k ? count_++ : shell_[shell_[k]];
  }
}

// Circles are visited in the order in which those with cusps were found, so the next of those is always known.
void SurfaceShells::join_saddles(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience,
                                 DisjointSets &sets) {
  uint32_t next = 0;
  for (uint32_t i = 0; i < boundary.ball_count(); ++i) {
    if (!patience.allows(50 + 50 * uint64_t{boundary.half_edges(i).size()})) return;
    uint32_t last = no_id;
    bool whole = false;
    for (const uint32_t e : boundary.half_edges(i)) {
      const uint32_t other = boundary.half_edge(e).circle;
      if (other < i) continue;
      if (other != last) {
        whole = !cusped.begins_with(next, LoopElement::arc(e));
        next += whole ? 0 : 1;
      }
      last = other;
      if (whole) sets.join(boundary.face_of(e), boundary.face_of(boundary.twin(e)));
    }
  }
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    if (cusped.begins_with(next, LoopElement::circle({c, 0}))) {
      ++next;
      continue;
    }
    const CircleRecord &circle = boundary.circle(c);
    sets.join(boundary.face_of_loop(circle.loop[0]), boundary.face_of_loop(circle.loop[1]));
  }
}

void SurfaceShells::join_pieces(const Boundary &boundary, const CutPatches &cut, Patience &patience,
                                DisjointSets &sets) {
  for (uint32_t piece = 0; piece < cut.piece_count(); ++piece) {
    if (!patience.allows(100 * uint64_t{cut.arcs(piece).size()})) return;
    for (const uint32_t a : cut.arcs(piece)) {
      const PatchArc &arc = cut.arc(a);
      if (arc.corner < 3 * boundary.vertex_count()) {
        sets.join(faces_ + piece, boundary.face_of(boundary.half_edge_at(arc.corner / 3, arc.corner % 3)));
      }
      if (arc.twin != no_id) sets.join(faces_ + piece, faces_ + cut.piece_of_arc(arc.twin));
    }
  }
}

}  // namespace hsp
