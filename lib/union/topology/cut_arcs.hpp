// Cut arcs: faces with several loops are cut along pieces of great circles in planes that contain the direction z
// (Section 4.2, Step 3).
//
// For one cap on every loop of a face take the great circle through the cap's axis and the poles. Together the pieces
// of these circles inside the face join all its loops (faces.cpp): most often directly, else through a pole that
// several of them pass. Circles are tried in an order that does not depend on ids. A circle that joins loops is used,
// with all its pieces inside the face. Circles that join a loop to a pole only are used if the others do not suffice. A
// circle is closed, so its pieces inside the face form closed trails together with parts outside the face: no piece is
// a bridge, and each has different faces on its two sides.
//
// Two great circles meet in the poles and nowhere else. A free pole that two or more cut arcs of a face pass becomes a
// vertex.
#pragma once

#include "boundary/point_location.hpp"
#include "core/patience.hpp"
#include "sphere/great_circles.hpp"

namespace hsp {

// The end of a cut arc: a subdivision vertex, and the side of the host edge on which the arc lies (subdivision.hpp).
class CutArcEnd {
 public:
  CutArcEnd() = default;
  constexpr CutArcEnd(uint32_t point, uint32_t side) : code_(2 * point + side) {}

  constexpr uint32_t point() const { return code_ / 2; }
  constexpr uint32_t side() const { return code_ % 2; }  // 0: the host's ball a; 1: its ball b

 private:
  uint32_t code_;
};

// A cut arc runs counter-clockwise about the normal of its plane, from end[0] to end[1]; the normal points to its left.
struct CutArc {
  uint32_t ball;
  uint32_t cap;  // the ball through the axis of whose circle the plane goes
  uint32_t face;
  LoopElement end[2];  // the arcs or circles on which it ends
  uint32_t poles;      // bits passes_*, south_first, vertex_at_*
  CutArcEnd ends[2];   // set by Subdivision::insert

  static constexpr uint32_t passes_north = 1;
  static constexpr uint32_t passes_south = 2;
  static constexpr uint32_t south_first = 4;  // if it passes both: the south pole comes first
  static constexpr uint32_t vertex_at_north = 8;
  static constexpr uint32_t vertex_at_south = 16;

  // The number of edges into which vertices at poles divide it.
  uint32_t pieces() const {
    return 1U + ((poles & vertex_at_north) != 0 ? 1U : 0U) + ((poles & vertex_at_south) != 0 ? 1U : 0U);
  }
};

class CutArcFinder {
 public:
  void carve(Workspace &workspace, uint32_t neighbours);

  // Finds the cut arcs of all balls, in the order of balls and then of faces. There must be room for the neighbours of
  // every ball. scratch: three numbers for each loop of the face with most loops, and two more.
  void find(const CubeGrid &grid, const Boundary &boundary, GatheredBall &gathered, Span<uint32_t> scratch,
            Patience &patience, FixedVector<CutArc> &arcs);

 private:
  void cut_face(const Boundary &boundary, uint32_t face, GatheredBall &gathered, FixedVector<CutArc> &arcs);
  // Finds the pieces of one great circle inside a face, and stores them in pending_.
  void find_pieces(const Boundary &boundary, uint32_t face, uint32_t cap, GatheredBall &gathered);
  // Joins the loops at the ends of the pieces in pending_, and the poles they pass. Returns what was not joined before.
  struct Joined {
    bool loops;
    bool poles;
  };
  Joined join_pieces(const Boundary &boundary);
  bool joins_nothing(const GatheredBall &gathered, uint32_t cap) const;
  void mark_caps_to_join(const Boundary &boundary, uint32_t face, const GatheredBall &gathered);
  void push_pieces(FixedVector<CutArc> &arcs) const;
  void reset_nodes(const Boundary &boundary, uint32_t face);

  Span<CutArc> pending_;  // [neighbours]
  uint32_t pending_count_ = 0;
  // nodes_: the loops of one face and the two poles, joined by all circles tried so far. direct_: the loops alone,
  // joined directly by the circles that are used.
  DisjointSets nodes_, direct_;
  bool pole_joined_[2] = {false, false};
  // Whether the index of meridians has marks at the loops of this face that are not joined yet. It is marked again
  // after most_in_vain circles that joined nothing, if half of these loops have been joined meanwhile: marking costs
  // more than a few circles.
  bool has_marks_ = false;
  uint32_t to_join_when_marked_ = 0, in_vain_ = 0;
  static constexpr uint32_t most_in_vain = 16;
  uint32_t to_join_ = 0, to_join_directly_ = 0;  // how many joins are missing until the face's loops are one set
  Span<uint32_t> reserve_;                       // loops whose circles join them to poles only
  Span<uint32_t> scratch_;
};

}  // namespace hsp
