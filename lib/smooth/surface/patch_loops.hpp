// The loops around what other probes leave of a concave patch: which of them bound one piece, and the angles and
// heights of arcs, from which areas of pieces follow. A number is rounded to a double only if its value is certain.
#pragma once

#include "core/fixed_vector.hpp"
#include "surface/actual_balls.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {

// A part of the border of the patch of a vertex. It runs counter-clockwise about the axis of the cap that bounds the
// patch there: seen from the probe's centre the patch lies on its left.
struct BorderArc {
  uint32_t across;       // the other vertex of a crease, or a side, as in PatchArc
  uint32_t start, end;   // numbers of corners (cut_patches.hpp); no_id of a whole circle
  uint32_t next;         // in its loop
  uint32_t loop;         // the first arc of its loop
  uint32_t piece;        // the first arc of the first loop of its piece
  BorderPoint from, to;  // names of the two ends; not of a whole circle

  bool is_whole() const { return start == no_id; }
  bool is_side() const { return (across & PatchArc::side_bit) != 0; }
};

// Figures of an arc on the unit sphere about the vertex.
struct ArcFigures : SphereArc {
  double exterior;  // angle at its end, positive for a turn to the right; 0 of a whole circle
};

class PatchLoops {
 public:
  PatchLoops(const ActualBalls &actual, uint32_t vertex, Span<BorderArc> arcs)
      : actual_(actual), vertex_(vertex), arcs_(arcs) {}

  // Chains arcs to loops: sets next and loop. False if an arc ends where none starts, or where several do.
  bool chain();
  // Measures an arc. False if no width is certain of all figures.
  bool measure(uint32_t arc, ArcFigures &figures) const;
  // The area on the left of a loop, on the unit sphere.
  double steradians(uint32_t loop, Span<const ArcFigures> figures) const;
  bool is_around_hole(uint32_t loop, Span<const ArcFigures> figures) const {
    return steradians(loop, figures) > 2 * pi;
  }
  // Sets piece. False if no width tells which loops bound one piece.
  bool group(Span<const ArcFigures> figures);

 private:
  const ActualBalls &actual_;
  const uint32_t vertex_;
  Span<BorderArc> arcs_;
};

}  // namespace hsp
