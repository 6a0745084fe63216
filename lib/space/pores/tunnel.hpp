// The widest path from one place to another, or to the outside, with the points that it leads through.
//
// It leads from maximum to maximum through gates, in the spanning forest that gates in descending order make: so its
// tightest gate is as wide as that of any path, and so is that of every part of it. Gates may be avoided: without the
// tightest ones of paths before, the next one is the widest that gets by elsewhere.
#pragma once

#include "pores/class_tree.hpp"

namespace hsp {

struct TunnelPoint {
  Vec3 place;
  double level;
  uint32_t ball[4];  // nearest ones, of the caller; no_id behind the last one
  uint32_t gate;     // that it is, or no_id
  uint32_t maximum;  // likewise
};

// The question.
struct TunnelEnds {
  exact::Vector from;
  const exact::Vector *to;  // null: the outside
  Span<const uint32_t> avoided;
  int64_t floor;
};

struct TunnelSummary {
  bool there;
  bool outside;       // whether it comes to the outside; from there to where it comes back no points are known
  double level;       // of the widest probe that gets through; infinite without balls
  double length;      // of the polyline
  uint32_t gate;      // the tightest one; no_id without gates
  uint32_t gates;     // that it passes
  PorePlace ends[2];  // where it begins and ends; of the outside the place of one
};

class TunnelFinder {
 public:
  void carve(Workspace &workspace, uint32_t maxima, uint32_t points);
  // Status::capacity: there is no room for so many points; needed_points() would have sufficed.
  Status find(PoresBuilder &pores, const CubeGrid &grid, const TunnelEnds &ends, TunnelSummary &summary);
  void forget() {
    points_.clear();
    needed_ = 0;
  }

  Span<const TunnelPoint> points() const { return points_.items(); }
  uint32_t capacity() const { return points_.capacity(); }
  uint32_t needed_points() const { return needed_; }

 private:
  struct Step {
    uint32_t gate, end;  // that it goes in at
  };
  bool connect(const PoresBuilder &pores, const TunnelEnds &ends, uint32_t from, uint32_t to);
  void root_at(uint32_t node);
  void take_route(const PoresBuilder &pores, uint32_t from, uint32_t to);
  Status add_way_up(const CubeGrid &grid, const exact::Vector &start, uint32_t maximum, const PoresBuilder &pores);
  Status add_way(PoresBuilder &pores, uint32_t gate, uint32_t end);
  void reverse(uint64_t first);
  void add_point(const CriticalPoint &point, uint32_t gate, uint32_t maximum);

  Span<uint32_t> parents_, sizes_;  // [maxima + 1] of sets; the outside is 0
  Span<uint32_t> next_, by_;        // [maxima + 1] towards the root of a tree, and the gate on that way
  Span<Step> route_;                // [maxima + 1]
  FixedVector<TunnelPoint> points_;
  FixedVector<WayPoint> way_;
  uint32_t route_count_ = 0, needed_ = 0;
};

}  // namespace hsp
