// All visible arcs of a map, each curve on its own: first the arcs of a ball's silhouette in ascending order of their
// parameters, then those of its creases with nearer balls, ball after ball.
#pragma once

#include "maps/ball_scene.hpp"
#include "maps/disc_grid.hpp"
#include "maps/hidden_intervals.hpp"

namespace hsp {

inline constexpr uint32_t most_hidden_per_occluder = 6;

// The visible arcs of the crease of two balls. near: as DiscGrid::gather finds them for ball `far`, `nearer` among
// them. Uses `hidden` [6 near]. hider: a ball that may hide all of it, or no_id; becomes the last one of many that were
// tried, if it hid the rest. False if the crease coincides with a front or silhouette, so that roundings decide what is
// seen.
bool find_crease_arcs(SeenBalls &seen, uint32_t far, uint32_t nearer, Span<const uint32_t> near,
                      FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs, uint32_t &hider);

// The visible arcs of one ball's silhouette. near: as DiscGrid::gather finds them. Uses `hidden` [2 near]. False if
// where one ball ceases to hide it another one begins to, so that roundings decide whether something is seen between
// them.
bool find_silhouette_arcs(SeenBalls &seen, uint32_t ball, Span<const uint32_t> near,
                          FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs);

class ArcFinder {
 public:
  void carve(Workspace &workspace, const MapLimits &limits);

  // If the neighbours of a ball are too many, arcs are incomplete.
  // False if that is stopped.
  bool find(SeenBalls &seen, const DiscGrid &grid, Patience &patience);

  Span<const MapArc> arcs() const { return arcs_.items(); }
  // False if roundings decided whether some whole curve is seen.
  bool certain() const { return certain_; }
  // False if roundings decided that nothing is seen between two hidden parts of some silhouette.
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
