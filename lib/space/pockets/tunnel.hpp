// Tunnels: a path from one point to another, or to the outside, through maxima and gates, and its points.
//
// A tree of maxima grows from the maximum above the start. By width: the next gate is the widest one that leads out of
// the tree; of equally wide gates the one that makes the shorter way. So on the way to each maximum, and on each part
// of it, the tightest gate is as wide as on any path. By cost: the next gate is the one of the least cost. A straight
// line from a maximum to a gate costs the integral of 1 / radius^2 along it for a radius that changes linearly: its
// length divided by the product of both radii. Gates may be avoided. If the tightest gates of the paths before are
// avoided, the next path is the best one that goes elsewhere.
//
// In a periodic box the path may end at any copy of the point. Instead of to the outside it leads to another copy of
// its start: it is closed by the first gate, in the order in which the tree grows, that leads from one maximum of the
// tree to another copy of one. That path is the best: of two ways to one maximum that differ only in the copy one is at
// least as good as the other.
#pragma once

#include "pockets/class_tree.hpp"

namespace hsp {

// Named by nearest balls, of which there may be one alone; shifts are relative to `copy`.
struct TunnelPoint : PointName {
  Vec3 position;
  double level;
  BoxShift copy;     // which copy of the gate or maximum it is, or of the point that the way leads up from
  uint32_t gate;     // the gate at this point, or no_id
  uint32_t maximum;  // the maximum at this point, or no_id
};

// The question: the ends of a tunnel, and how to choose it.
struct TunnelEnds {
  exact::Vector from;
  const exact::Vector *to;  // null: the outside; in a box another copy of `from`
  Span<const uint32_t> avoided;
  int64_t floor;
  bool by_cost;  // by the least cost; else by the largest width
};

struct TunnelSummary {
  bool there;
  bool outside;          // whether it leads to the outside; points between leaving and coming back are not known
  double level;          // of the widest probe that gets through; infinite without balls
  double length;         // of the polyline
  double cost;           // of the gates passed; infinite if one is no wider than 0
  uint32_t gate;         // the tightest gate; no_id without gates
  uint32_t gates;        // how many gates it passes
  BoxShift shift;        // in a box: from the given end to the copy at which it ends
  PoreLocation ends[2];  // of its first and its last point; the outside has the location of a point in it
};

class TunnelFinder {
 public:
  void carve(Workspace &workspace, uint32_t maxima, uint32_t gates, uint32_t points);
  // Finds a tunnel. A point is left out if it is nearer to the one before than `nearness` times its level, except for
  // gates, maxima and ends. An end that is a maximum or gate but for rounding counts as that, and keeps its own
  // position. Status::capacity: there is no room for the points; needed_points() would have sufficed. Status::range:
  // the tunnel leads so many boxes away that positions overflow. Status::stopped: patience has ended.
  Status find(PoresBuilder &pores, const BallsAround &balls, const TunnelEnds &ends, TunnelSummary &summary,
              Patience patience = Patience());
  void forget() {
    points_.clear();
    needed_ = 0;
    summary_ = {};
  }

  Span<const TunnelPoint> points() const { return points_.items(); }
  // The summary of the last tunnel; all is 0 if there is none.
  const TunnelSummary &summary() const { return summary_; }
  uint32_t capacity() const { return points_.capacity(); }
  uint32_t needed_points() const { return needed_; }

 private:
  static constexpr double nearness = 0x1p-8, rounding = 2.0;
  // A step through a gate from one of its ends to the other: twice the gate's number, plus the end it begins at.
  struct Step {
    uint32_t gate_and_end;
    uint32_t gate() const { return gate_and_end / 2; }
    uint32_t end() const { return gate_and_end % 2; }
    Step back() const { return {gate_and_end ^ 1}; }
  };
  // A node of the tree, or one next to it: 0 is the outside, m + 1 maximum m.
  struct Node {
    double cost;     // of the way to it
    Step by;         // the last step of that way
    uint32_t slot;   // its slot in the heap; no_id: not seen; in_tree: in the tree
    BoxShift shift;  // the copy that the way leads to
  };
  static constexpr uint32_t in_tree = no_id - 1;
  void list_steps(const PoresBuilder &pores);
  double cost_of_half(const PoresBuilder &pores, uint32_t gate, uint32_t end, bool by_length) const;
  bool search(const PoresBuilder &pores, const TunnelEnds &ends, uint32_t from, uint32_t to, Patience &patience,
              Step &closing);
  void take_route(const PoresBuilder &pores, uint32_t from, uint32_t to);
  void close_route(const PoresBuilder &pores, uint32_t from, Step closing);
  Status add_way_up(const BallsAround &balls, const exact::Vector &start, const Vec3 &by, const BoxShift &copy,
                    Patience &patience);
  Status add_way(PoresBuilder &pores, uint32_t gate, uint32_t end, const BoxShift &copy);
  Status follow_route(PoresBuilder &pores, const BallsAround &balls, const TunnelEnds &ends, Patience &patience);
  void reverse(uint64_t first);
  void leave_out_near_points();
  void add_point(const PoresBuilder &pores, const CriticalPoint &point, const BoxShift &copy, uint32_t gate,
                 uint32_t maximum);

  Span<Node> nodes_;             // [maxima + 1]
  Span<uint32_t> first_, heap_;  // [maxima + 2] the first step of each node; [maxima + 1]
  Span<uint32_t> first_alike_;   // [gates] the first gate of the same level
  Span<Step> steps_, route_;     // [2 gates] by the node at which they begin; [2 maxima + 3]
  FixedVector<TunnelPoint> points_;
  FixedVector<WayPoint> way_;
  TunnelSummary summary_{};
  uint32_t route_count_ = 0, needed_ = 0;
  bool too_far_ = false;  // whether steps were left out that lead too many boxes away
};

}  // namespace hsp
