// Pores, and the answers to questions about them: pockets, regions and a tunnel, in one piece of memory.
#pragma once

#include "pockets/plugs.hpp"
#include "pockets/pockets.hpp"
#include "pockets/region_finder.hpp"
#include "pockets/tunnel.hpp"

namespace hsp {

struct PoreQuestionLimits {
  PoreLimits pores;
  uint32_t points = 0;  // of a tunnel
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, PoreQuestionLimits &limits) {
  const Status status = default_limits(balls, limits.pores);
  if (status == Status::ok) limits.points = balls + 4096;
  return status;
}

class PoreQuestions {
 public:
  void carve(Workspace &workspace, const PoreQuestionLimits &limits) {
    builder_.carve(workspace, limits.pores);
    pockets_.carve(workspace, limits.pores);
    regions_.carve(workspace, limits.pores);
    tunnel_.carve(workspace, limits.pores.maxima, limits.pores.gates, limits.points);
  }
  // As PoresBuilder::build(). No level is below minus the largest radius: a lower floor counts as a step less than
  // that.
  Status build(const CubeGrid &grid, int64_t floor, Patience patience = Patience(),
               const PoreQuestions *before = nullptr) {
    return builder_.build(grid, begin(grid.balls().largest_radius, floor), patience,
                          before != nullptr ? &before->builder_ : nullptr);
  }
  // The same in a periodic box.
  Status build(const PeriodicImages &images, int64_t floor, Patience patience = Patience()) {
    return builder_.build(images, begin(images.largest_radius(), floor), patience);
  }
  // As TunnelFinder::find(). balls: those that the pores were built of.
  Status find_tunnel(const BallsAround &balls, const TunnelEnds &ends, TunnelSummary &summary,
                     Patience patience = Patience()) {
    return tunnel_.find(builder_, balls, ends, summary, patience);
  }
  // As PocketFinder::find.
  void find_pockets(double narrow, double wide) { pockets_.find(builder_, narrow, wide); }
  // As RegionFinder::find(). balls: those that the pores were built of.
  Status find_regions(const BallsAround &balls, const Boundary &boundary, const PeriodicUnion *periodic,
                      uint32_t first_plug = no_id, Patience patience = Patience()) {
    return regions_.find(builder_, balls, boundary, periodic, floor_, first_plug, patience);
  }
  // As PocketFinder::match(), with the regions that `plugged` has found. point_of(maximum, point) sets the place of a
  // maximum on the lattice of `plugged`; balls: those of `plugged`. Status::range: that place is too far away.
  // Status::stopped: patience has ended. Unless `plugged` is this object, its mouths become the leaks.
  template <class PointOf>
  Status match_pockets(PoreQuestions &plugged, const BallsAround &balls, PointOf point_of,
                       Patience patience = Patience()) {
    const bool others = this != &plugged;
    if (others) plugged.pockets_.begin_leaks(plugged.builder_);
    const auto region_at = [&](uint32_t maximum, uint32_t &region) {
      exact::Vector point;
      PoreLocation location;
      if (!patience.allows(50000)) return Status::stopped;
      Status status = point_of(maximum, point);
      if (status == Status::ok) status = locate(plugged.builder_, balls, point, plugged.floor_, location);
      const bool is_free = status == Status::ok && location.maximum != no_id && location.level > 0.0;
      if (is_free) region = plugged.regions_.region_of(plugged.builder_, location.maximum);
      if (region != no_id && others) plugged.pockets_.mark(location.maximum, pockets_.pocket_of(maximum));
      return status;
    };
    const Status status = pockets_.match(builder_, plugged.regions_, region_at);
    if (!others) return status;
    if (status == Status::ok) {
      plugged.pockets_.find_leaks(plugged.builder_);
    } else {
      plugged.pockets_.forget();
    }
    return status;
  }
  // As PoresBuilder::join_above.
  uint32_t join_above(double level) { return builder_.join_above(level); }
  void forget_pockets() { pockets_.forget(); }
  void forget_regions() { regions_.forget(); }
  void forget_tunnel() { tunnel_.forget(); }

  const PoresBuilder &pores() const { return builder_; }
  const PocketFinder &pockets() const { return pockets_; }
  const RegionFinder &regions() const { return regions_; }
  const TunnelFinder &tunnel() const { return tunnel_; }
  ClassTree tree() const { return ClassTree(builder_); }
  int64_t floor() const { return floor_; }

  // The limits that suffice for the pores and for the last tunnel.
  PoreQuestionLimits needed() const { return {builder_.needed(), tunnel_.needed_points()}; }
  // The limits to try again with after Status::capacity.
  PoreQuestionLimits retry_limits() const {
    return {builder_.retry_limits(), larger_count(tunnel_.capacity(), tunnel_.needed_points())};
  }

 private:
  // Forgets the answers. Returns the floor, or the lowest one that makes a difference.
  int64_t begin(int64_t largest_radius, int64_t floor) {
    pockets_.forget();
    regions_.forget();
    tunnel_.forget();
    floor_ = floor;
    const int64_t lowest = -largest_radius - 1;
    return floor < lowest ? lowest : floor;
  }

  PoresBuilder builder_;
  PocketFinder pockets_;
  RegionFinder regions_;
  TunnelFinder tunnel_;
  int64_t floor_ = 0;
};

}  // namespace hsp
