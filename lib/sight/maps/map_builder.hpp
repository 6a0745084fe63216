// Builds the visibility map of balls along a direction, from the balls to the faces.
//
// In general position every step follows from signs that rounding does not change. If more balls, silhouettes or
// creases meet in a point than at a vertex of its kind, as in lattices seen along their axes, the arcs of different
// curves may not fit together. Linking and tracing notice that: every end must find its partners, and every T its
// silhouette; the balls named around a loop must agree, and, if rounding may have decided how edges are linked, must be
// those seen behind its edges; Euler's formula must hold. If something does not fit, all centres are moved a little and
// the map is built again: by at most 2^-20 of each ball's radius, then by 2^-17 and 2^-14, at last in other ways
// (seen_balls.hpp). The map is that of the moved balls, and says how far they were moved. If no move fits, there is a
// status and no map.
//
// If many balls are in one place, balls whose spheres others cover are left out (view/covered_balls.hpp), also when all
// balls are moved: then it is the map of the others. If some are found to be covered after a move, the same move is
// made again.
//
// A ball that reaches out of another one by less than 2^-40 of the other's radius counts as inside it. Balls that reach
// into each other by less than 2^-41 of the sum of their radii do not meet.
//
// Cost: O(n log n), and for each curve that may be seen the number of balls whose discs meet its disc and that reach
// higher. lib/sight/maps/THEORY.md has the worst case, and the bound of Section 5.2.
#pragma once

#include "maps/arc_finder.hpp"
#include "maps/ball_scene.hpp"
#include "maps/map_faces.hpp"
#include "maps/map_linker.hpp"

namespace hsp {

class MapBuilder : public Limited<MapLimits> {
 public:
  void carve(Workspace &workspace, const MapLimits &limits);

  // Status::capacity if a limit is too small; needed() then tells what suffices, with 0 for what is not known yet.
  // Status::degenerate if no move of the balls fits, Status::not_finite if a component of the direction is not finite,
  // Status::stopped if patience has ended.
  Status build(const CubeGrid &grid, const ViewDirection &direction, Patience patience = Patience());

  const VisibilityMap &structure() const { return map_; }
  const DiscGrid &discs() const { return discs_; }

  // The map for tests, which damage it.
  VisibilityMap &arrays() { return map_; }
  // Scratch memory for checks and pictures; [2 edges + 1] and [edges].
  Span<uint32_t> scratch() { return faces_.scratch(); }
  Span<uint32_t> more_scratch() { return faces_.more_scratch(); }

 private:
  Status build_moved(const BallSet &balls, const Perturbation &perturbation, Patience &patience);

  VisibilityMap map_;
  SeenBalls seen_;
  DiscGrid discs_;
  ArcFinder arcs_;
  MapLinker<BallScene> linker_;
  MapFaceFinder<BallScene> faces_;
};

}  // namespace hsp
