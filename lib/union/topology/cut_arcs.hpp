// Cut arcs: faces with several loops are cut along pieces of great circles in planes that contain the direction z
// (Section 4.2, Step 3).
//
// For one cap on every loop of a face take the great circle through the cap's axis and the poles. Together their pieces
// inside the face join all its loops (faces.cpp): most often directly, else through a pole that several of them
// pass. Circles are tried in an order that does not depend on ids. One that joins loops is used, with all its pieces
// inside the face; those that join nothing but poles are used if the others do not suffice. A circle is closed, so its
// pieces inside the face form closed trails together with what the face leaves out: none of them is a bridge, and each
// has different faces on its sides.
//
// Two great circles meet in the poles and nowhere else. A free pole that two or more of a face's circles pass becomes a
// vertex.
#pragma once

#include "boundary/point_location.hpp"
#include "core/patience.hpp"
#include "sphere/great_circles.hpp"

namespace hsp {

// Where a cut arc ends: a subdivision vertex, and the side of the host edge it comes to (subdivision.hpp).
class CutArcEnd {
 public:
  CutArcEnd() = default;
  constexpr CutArcEnd(uint32_t point, uint32_t side) : code_(2 * point + side) {}

  constexpr uint32_t point() const { return code_ / 2; }
  constexpr uint32_t side() const { return code_ % 2; }  // 0 that of the host's ball a, 1 that of b

 private:
  uint32_t code_;
};

// Counter-clockwise about the normal of its plane, from `end[0]` to `end[1]`; its left side is that of the normal.
struct CutArc {
  uint32_t ball;
  uint32_t cap;  // the ball whose circle's axis the plane goes through
  uint32_t face;
  LoopElement end[2];
  uint32_t poles;     // passes_*, vertex_at_*
  CutArcEnd ends[2];  // once their vertices are inserted

  static constexpr uint32_t passes_north = 1;
  static constexpr uint32_t passes_south = 2;
  static constexpr uint32_t south_first = 4;  // if it passes both
  static constexpr uint32_t vertex_at_north = 8;
  static constexpr uint32_t vertex_at_south = 16;

  // Edges that it is cut into.
  uint32_t pieces() const {
    return 1U + ((poles & vertex_at_north) != 0 ? 1U : 0U) + ((poles & vertex_at_south) != 0 ? 1U : 0U);
  }
};

class CutArcFinder {
 public:
  void carve(Workspace &workspace, uint32_t neighbours);

  // Finds the cut arcs of all balls, those of one ball consecutive, balls ascending. There must be room for the
  // neighbours of every ball. scratch: three numbers for each loop of the face that has most, and two more.
  void find(const CubeGrid &grid, const Boundary &boundary, GatheredBall &gathered, Span<uint32_t> scratch,
            Patience &patience, FixedVector<CutArc> &arcs);

 private:
  void cut_face(const Boundary &boundary, uint32_t face, GatheredBall &gathered, FixedVector<CutArc> &arcs);
  // The pieces of one great circle inside a face, in pending_.
  void find_pieces(const Boundary &boundary, uint32_t face, uint32_t cap, GatheredBall &gathered);
  // Joins the ends of the pieces in pending_, and the poles they pass.
  struct Joined {
    bool loops;  // that were not joined before
    bool poles;
  };
  Joined join_pieces(const Boundary &boundary);
  bool joins_nothing(const GatheredBall &gathered, uint32_t cap) const;
  void mark_caps_to_join(const Boundary &boundary, uint32_t face, const GatheredBall &gathered);
  void push_pieces(FixedVector<CutArc> &arcs) const;
  void reset_nodes(const Boundary &boundary, uint32_t face);

  Span<CutArc> pending_;  // [neighbours]
  uint32_t pending_count_ = 0;
  // The loops of one ball, and its two poles: what the circles tried so far join, and what those that join loops
  // directly do without the poles.
  DisjointSets nodes_, direct_;
  bool pole_joined_[2] = {false, false};
  // Whether the index of meridians is marked where loops of this face are to be joined. It is marked again only for
  // half of them, after so many circles that joined nothing: before, these cost less.
  bool has_marks_ = false;
  uint32_t to_join_when_marked_ = 0, in_vain_ = 0;
  static constexpr uint32_t most_in_vain = 16;
  uint32_t to_join_ = 0, to_join_directly_ = 0;  // until the face's loops are one set
  Span<uint32_t> reserve_;                       // loops whose circles join nothing but poles
  Span<uint32_t> scratch_;
};

}  // namespace hsp
