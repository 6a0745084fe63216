// Where faces with several loops are cut: along pieces of great circles in planes that contain the direction z, as the
// paper has it (Section 4.2, Step 3).
//
// For one cap of every cluster of a ball take the great circle through the cap's axis and the poles. Its pieces inside
// a face, together with those of the others, join all loops of the face (meridians.cpp). A circle that joins nothing
// new in a face is not used there; of one that does, all pieces inside the face are. The circle is closed, so its
// pieces inside the face form closed trails together with what the face leaves out: none of them is a bridge, and each
// has different faces on its sides. Circles are tried in the rank of their caps' balls, so the cuts do not depend on
// ids.
//
// Two great circles meet in the poles and nowhere else. A free pole that two or more of a face's circles pass becomes a
// vertex.
#pragma once

#include "boundary/structure.hpp"
#include "topology/gathered_ball.hpp"

namespace hsp {

// Counter-clockwise about the normal of its plane, from `end[0]` to `end[1]`; its left side is that of the normal.
struct ExtraArc {
  uint32_t ball;
  uint32_t cap;  // the ball whose circle's axis the plane goes through
  uint32_t face;
  uint32_t end[2];  // uses of `ball`, or circle sides + circle_bit
  uint32_t poles;   // passes_*, vertex_at_*

  static constexpr uint32_t circle_bit = UINT32_C(1) << 31;
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

class ExtraArcFinder {
 public:
  void carve(Workspace &workspace, uint32_t neighbours, uint32_t edges);

  // Finds the extra arcs of all balls, those of one ball consecutive, balls ascending. There must be room for the
  // neighbours of every ball and for as many edges as the boundary has arcs and circles.
  void find(const CubeGrid &grid, const BoundaryStructure &boundary, GatheredBall &gathered,
            FixedVector<ExtraArc> &arcs);

 private:
  void cut_ball(const BoundaryStructure &boundary, const GatheredBall &gathered, FixedVector<ExtraArc> &arcs);
  uint32_t sort_representatives(const GatheredBall &gathered);

  Span<uint32_t> representative_;  // [neighbours] a cap of every cluster, the one of lowest rank
  Span<ExtraArc> pending_;         // [neighbours] the free arcs of one great circle
  Span<uint32_t> loop_parent_;     // [edges + 2] the loops of one ball, and its poles
  Span<uint32_t> joined_by_;       // [edges] by face of the ball: the last circle that joined loops of it
};

}  // namespace hsp
