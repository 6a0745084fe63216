// The records of a view: pieces in drawing order, their loops, and arcs in the view plane. Ids of balls are in grid
// order, lengths in lattice steps, positions relative to the frame's origin.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/limits.hpp"
#include "core/workspace.hpp"
#include "model/ball_set.hpp"
#include "view/view_frame.hpp"

namespace hsp {

struct ViewLimits {
  uint32_t balls = 0, neighbours = 0, arcs = 0;
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, ViewLimits &limits) {
  if (balls > (max_count - 64) / 12) return Status::range;
  limits = {balls, balls < 256 ? balls : 256, 12 * balls + 64};
  return Status::ok;
}

// The piece of one ball that is painted. The loops of a piece, and its arcs, are consecutive, loop after loop.
struct PieceRecord {
  uint32_t ball;
  uint32_t first_loop, loops;
  uint32_t first_arc, arcs;
};

struct ArcRecord {
  double from, to;      // parameters on the ellipse of projected_arcs.hpp
  double start[2];      // where it starts; it ends where the next arc of its loop starts
  uint32_t other_ball;  // the other ball on whose sphere it lies; no_id on the silhouette
};

struct View {
  ViewFrame frame;
  FixedVector<PieceRecord> pieces;  // farthest first
  FixedVector<uint32_t> loops;      // the first arc of each; loops and arcs are in the grid order of their balls
  FixedVector<ArcRecord> arcs;

  uint32_t end_of_loops(uint32_t piece) const { return pieces[piece].first_loop + pieces[piece].loops; }
  uint32_t end_of_arcs(uint32_t loop) const { return loop + 1 < loops.size() ? loops[loop + 1] : arcs.size(); }

  void carve(Workspace &workspace, const ViewLimits &limits) {
    pieces = FixedVector<PieceRecord>(workspace.take<PieceRecord>(limits.balls));
    loops = FixedVector<uint32_t>(workspace.take<uint32_t>(limits.arcs));
    arcs = FixedVector<ArcRecord>(workspace.take<ArcRecord>(limits.arcs));
  }
};

}  // namespace hsp
