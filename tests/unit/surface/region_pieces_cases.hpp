// Pieces of an octant that caps cut, and the holes in them.
#pragma once

#include "circles_in_doubles_cases.hpp"
#include "surface/region_pieces.hpp"

namespace cases {

struct PiecesCase {
  uint32_t n;
  UnitCap cap[6];
  uint32_t pieces, loops;
  uint32_t most_loops;  // of one piece
};
constexpr PiecesCase pieces_cases[] = {
    {3, {octant_sides[0], octant_sides[1], octant_sides[2]}, 1, 1, 1},
    // A hole in the middle; a cap over the middles of all sides leaves three corners; one of these has a hole.
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.96}}, 1, 2, 2},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.8}}, 3, 3, 1},
    {5, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.8}, {1, 0.12, 0.12, 0.9986}}, 3, 4, 2},
    // Two holes of one piece, the other piece has none.
    {6,
     {octant_sides[0],
      octant_sides[1],
      octant_sides[2],
      {1, 0, 1, 0.72},
      {0.2, 1, 0.2, 0.9995},
      {0.3, 1, 0.1, 0.99995}},
     1,
     3,
     3},
    {4, {octant_sides[0], octant_sides[1], octant_sides[2], {1, 1, 1, 0.1}}, 0, 0, 0}};

inline uint32_t pieces_and_loops() {
  return first_failing(pieces_cases, [](const PiecesCase &c) {
    SmallCaps caps(c.cap, c.n);
    hsp::FreeRegion region;
    if (!found_in_doubles(caps, region)) return false;
    const hsp::Span<hsp::RegionArc> arcs = caps.arcs.items();
    if (!hsp::find_pieces(caps.caps, caps.corners.items(), arcs)) return false;
    uint32_t pieces = 0;
    uint32_t loops = 0;
    uint32_t most_loops = 0;
    for (uint32_t piece = 0; piece < arcs.size(); ++piece) {
      if (arcs[arcs[piece].next].loop != arcs[piece].loop) return false;
      if (arcs[piece].piece != piece) continue;
      ++pieces;
      uint32_t own = 0;
      for (uint32_t loop = 0; loop < arcs.size(); ++loop) {
        if (arcs[loop].loop == loop && arcs[loop].piece == piece) ++own;
      }
      loops += own;
      if (own > most_loops) most_loops = own;
    }
    return pieces == c.pieces && loops == c.loops && most_loops == c.most_loops;
  });
}

// The hole near (1, 0, 0) lies in the piece there.
inline uint32_t holes_lie_in_their_pieces() {
  const PiecesCase &c = pieces_cases[3];
  SmallCaps caps(c.cap, c.n);
  hsp::FreeRegion region;
  if (!found_in_doubles(caps, region)) return 0;
  const hsp::Span<hsp::RegionArc> arcs = caps.arcs.items();
  if (!hsp::find_pieces(caps.caps, caps.corners.items(), arcs)) return 1;
  for (const hsp::RegionArc &hole : arcs) {
    if (hole.start != hsp::no_id) continue;
    const hsp::RegionArc &around = arcs[hole.piece];
    return caps.corners[around.start].point.x > 0.7 ? all_hold : 2;
  }
  return 3;
}

inline constexpr Check surface_region_pieces[] = {{"pieces_and_loops", pieces_and_loops},
                                                  {"holes_lie_in_their_pieces", holes_lie_in_their_pieces}};

}  // namespace cases
