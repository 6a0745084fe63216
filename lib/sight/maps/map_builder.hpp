// The map of what is seen along a direction, from the balls to the faces.
//
// In general position every step follows from signs that roundings do not touch. Where balls, silhouettes or creases
// meet in more than their kind of vertex, as in lattices seen along their axes, the arcs of different curves may not
// fit together. Linking and tracing notice that: every end must find its partners, every T its silhouette, the balls
// named around a loop must agree, also with what is behind its edges where roundings may have decided how they are
// linked, and Euler's formula must hold. Then all centres are moved a little and the map is
// built again: by at most 2^-20 of each ball's radius, then by 2^-17 and 2^-14. The map says by how much; it is one of
// the moved balls. If none of them fits, there is a status and no map.
//
// Balls whose spheres others cover are left out where many balls are in one place (view/covered_balls.hpp), also where
// all are moved: it is the map of the others then. If it turns out after a move of some, the same move is made again.
//
// A ball that reaches less out of another one than 2^-40 of that one's radius counts as inside, and balls that reach
// less into each other than 2^-41 of both radii together do not meet.
//
// Cost: O(n log n) and, for each curve that may be seen, the balls whose discs meet its disc and that reach higher.
// lib/sight/maps/THEORY.md says what that is at worst, and beside the bound of Section 5.2.
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
  // Status::degenerate if roundings cannot be overcome, Status::not_finite if a component of the direction is not.
  // Status::stopped if that is no longer allowed.
  Status build(const CubeGrid &grid, const ViewDirection &direction, Patience patience = Patience());

  const VisibilityMap &structure() const { return map_; }
  const DiscGrid &discs() const { return discs_; }

  // For tests that break it.
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
