// Pieces and arcs as they are added, and more of them than there is room for.
#pragma once

#include "cases.hpp"
#include "surface/cut_patches.hpp"

namespace cases {

inline void add_three_patches(hsp::CutPatches &patches) {
  patches.clear();
  patches.begin_vertex(0);  // whole
  patches.begin_vertex(1);  // two pieces, the first with two loops
  patches.begin_piece(1, 2.0, 3.0);
  patches.add_arc(hsp::PatchArc::side(2), 0.5, false);
  patches.add_arc(7, 0.25, true);
  patches.add_arc(8, 0.75, true);
  patches.begin_piece(1, 1.0, 1.5);
  patches.add_arc(9, 0.5, true);
  patches.begin_vertex(2);  // a piece without arcs
  patches.begin_piece(2, 0.0, 0.0);
  patches.finish(3);
}

inline uint32_t pieces_and_their_arcs() {
  alignas(64) unsigned char memory[1024];
  hsp::Workspace workspace(memory, sizeof memory);
  hsp::CutPatches patches;
  patches.carve(workspace, 3, 3, 4);
  add_three_patches(patches);
  const bool conditions[] = {
      !patches.overflowed() && patches.required_pieces() == 3 && patches.required_arcs() == 4,
      !patches.is_cut(0) && patches.is_cut(1) && patches.is_cut(2),
      patches.pieces(1).size() == 2 && patches.pieces(2).first == 2 && patches.pieces(2).size() == 1,
      patches.arcs(0).size() == 3 && patches.arcs(1).first == 3 && patches.arcs(1).size() == 1,
      patches.arcs(2).empty() && patches.arcs_of_vertex(1).size() == 4 && patches.arcs_of_vertex(0).empty(),
      patches.arc(0).next == 1 && patches.arc(1).next == 0 && patches.arc(2).next == 2 && patches.arc(3).next == 3,
      patches.arc(0).is_side() && patches.arc(0).slot() == 2 && !patches.arc(1).is_side(),
      patches.piece_of_arc(0) == 0 && patches.piece_of_arc(2) == 0 && patches.piece_of_arc(3) == 1,
      patches.piece(1).area == 1.0 && patches.piece(0).volume == 3.0 && patches.piece(2).vertex == 2};
  return first_false(conditions);
}

inline uint32_t too_many_are_counted_too() {
  for (uint32_t room = 0; room < 4; ++room) {
    alignas(64) unsigned char memory[1024];
    hsp::Workspace workspace(memory, sizeof memory);
    hsp::CutPatches patches;
    patches.carve(workspace, 3, room, room);
    add_three_patches(patches);
    if (!patches.overflowed() || patches.required_pieces() != 3 || patches.required_arcs() != 4) return room;
  }
  return all_hold;
}

inline constexpr Check surface_cut_patches[] = {{"pieces_and_their_arcs", pieces_and_their_arcs},
                                                {"too_many_are_counted", too_many_are_counted_too}};

}  // namespace cases
