#include "surface/cut_patches.hpp"

namespace hsp {

void CutPatches::carve(Workspace &workspace, uint32_t vertices, uint32_t pieces, uint32_t arcs) {
  first_piece_ = workspace.take<uint32_t>(uint64_t{vertices} + 1);
  pieces_ = FixedVector(workspace.take<PatchPiece>(pieces));
  arcs_ = FixedVector(workspace.take<PatchArc>(arcs));
}

void CutPatches::clear() {
  pieces_.clear();
  arcs_.clear();
  loop_ = 0;
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
}

uint32_t CutPatches::piece_of_arc(uint32_t arc) const {
  uint32_t low = 0;
  uint32_t high = piece_count();
  while (high - low > 1) {
    const uint32_t middle = low + (high - low) / 2;
    if (piece(middle).first_arc <= arc) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace hsp
