#include "surface/cut_patches.hpp"

#include "core/first_index.hpp"

namespace hsp {

void CutPatches::carve(Workspace &workspace, uint32_t vertices, uint32_t pieces, uint32_t arcs) {
  first_piece_ = workspace.take<uint32_t>(uint64_t{vertices} + 1);
  patch_ = workspace.take<ConcavePatch>(pieces);
  pieces_ = FixedVector(workspace.take<PatchPiece>(pieces));
  arcs_ = FixedVector(workspace.take<PatchArc>(arcs));
  creases_.carve(workspace, arcs);
  crease_corners_.carve(workspace, arcs);
  extra_pieces_.carve(workspace, pieces);
}

void CutPatches::clear() {
  pieces_.clear();
  arcs_.clear();
  loop_ = 0;
  creases_.clear(0);
  crease_corners_.clear(0);
  extra_pieces_.clear(0);
}

void CutPatches::begin_piece(uint32_t vertex, double area, double volume, const CreaseSums &creases) {
  pieces_.push({vertex, clamped_count(arcs_.required()), area, volume, creases});
}

void CutPatches::add_arc(uint32_t across, double angle, bool last_of_loop) {
  const uint32_t next = clamped_count(arcs_.required() + 1);
  arcs_.push({across, no_id, last_of_loop ? loop_ : next, no_id, angle});
  if (last_of_loop) loop_ = next;
}

void CutPatches::finish(uint32_t vertices) {
  first_piece_[vertices] = pieces_.size();
  creases_.clear(arcs_.size());
  crease_corners_.clear(arcs_.size());
  extra_pieces_.clear(pieces_.size());
  for (uint32_t k = 1; k < pieces_.size(); ++k) {
    if (pieces_[k].vertex == pieces_[k - 1].vertex) extra_pieces_.set(k);
  }
  creases_.count();
  crease_corners_.count();
  extra_pieces_.count();
}

void CutPatches::number_joints(uint32_t first_crease_corner) {
  for (uint32_t a = 0; a < arcs_.size(); ++a) {
    creases_.set_if(a, arcs_[a].twin != no_id && arcs_[a].twin > a);
    crease_corners_.set_if(a, arcs_[a].corner == first_crease_corner + a);
  }
  creases_.count();
  crease_corners_.count();
  for (PatchArc &arc : arcs_.items()) {
    if (arc.corner == no_id || arc.corner < first_crease_corner) continue;
    arc.corner = first_crease_corner + crease_corners_.rank(arc.corner - first_crease_corner);
  }
}

// The arcs of a loop are stored one after the other.
uint32_t CutPatches::previous(uint32_t arc) const {
  if (arc > 0 && arcs_[arc - 1].next == arc) return arc - 1;
  uint32_t last = arc;
  while (arcs_[last].next != arc) last = arcs_[last].next;
  return last;
}

uint32_t CutPatches::piece_of_arc(uint32_t arc) const {
  return first_index(1, piece_count(), [this, arc](uint32_t k) { return piece(k).first_arc > arc; }) - 1;
}

}  // namespace hsp
