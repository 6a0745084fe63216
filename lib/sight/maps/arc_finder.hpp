// Finds all visible arcs of a map, each curve on its own. Arcs come ball after ball: first those of the ball's
// silhouette in ascending order of their parameters, then those of its creases with nearer balls.
#pragma once

#include "maps/ball_scene.hpp"
#include "maps/disc_grid.hpp"
#include "maps/hidden_intervals.hpp"

namespace hsp {

inline constexpr uint32_t most_hidden_per_occluder = 6;

// Finds the visible arcs of the crease of two balls. near: the balls that DiscGrid::gather() finds for ball `far`;
// `nearer` is among them. Uses `hidden` [6 near]. hider: a ball that may hide the whole crease, or no_id; if many balls
// were tried it becomes the last one, if that has hidden the rest. False if the crease coincides with a front or a
// silhouette, so that rounding decides what is seen.
bool find_crease_arcs(SeenBalls &seen, uint32_t far, uint32_t nearer, Span<const uint32_t> near,
                      FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs, uint32_t &hider);

// Finds the visible arcs of one ball's silhouette. near: the balls that DiscGrid::gather() finds for it. Uses `hidden`
// [2 near]. False if one ball ceases to hide the silhouette at a point at which another one begins, so that rounding
// decides whether something is seen between them.
bool find_silhouette_arcs(SeenBalls &seen, uint32_t ball, Span<const uint32_t> near,
                          FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs);

class ArcFinder {
 public:
  void carve(Workspace &workspace, const MapLimits &limits);

  // False if patience ends. If a ball has too many neighbours, the arcs are not complete: see overflowed().
  bool find(SeenBalls &seen, const DiscGrid &grid, Patience &patience);

  Span<const MapArc> arcs() const { return arcs_.items(); }
  // False if rounding has decided whether some curve is seen.
  bool certain() const { return certain_; }
  // False if rounding has decided that nothing is seen between two hidden parts of some silhouette.
  bool complete() const { return complete_; }
  bool overflowed() const { return arcs_.overflowed() || needed_neighbours_ > near_.capacity(); }
  uint32_t needed_neighbours() const { return needed_neighbours_; }
  uint32_t needed_edges() const { return most_edges_of(arcs_, 0); }

 private:
  FixedVector<MapArc> arcs_;    // [edges]
  FixedVector<uint32_t> near_;  // [neighbours]
  FixedVector<HiddenInterval> hidden_;
  uint32_t needed_neighbours_ = 0;
  bool certain_ = true;
  bool complete_ = true;
};

}  // namespace hsp
