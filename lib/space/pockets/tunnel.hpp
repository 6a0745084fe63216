// A path from one point to another, or to the outside, through maxima and gates, with the points that it leads through.
//
// From the maximum above the start a tree of maxima grows, by the widest gate first that leads out of it, of gates as
// wide the one that makes the shorter way. So the tightest gate on the way to each of them is as wide as that of any
// path, and so is that of every part of the way. Or by the least cost first: a straight line from a maximum to a gate
// costs the integral of 1 / radius^2 along it, if the radius changes evenly: its length over the product of both radii.
// Gates may be avoided: without the tightest ones of paths before, the next one is the best that gets by elsewhere.
//
// In a periodic box the end may be any copy of the point, and instead of to the outside the path leads to another copy
// of its start: the first gate, in the order of the tree's, that joins two maxima of the tree, but for a copy, closes
// it. It is the best one, since of two ways to one copy that differ in nothing but a copy one is at least as good as
// the other.
#pragma once

#include "pockets/class_tree.hpp"

namespace hsp {

struct TunnelPoint {
  Vec3 position;
  double level;
  uint32_t ball[4];     // nearest ones, of the caller; no_id behind the last one
  SmallShift shift[4];  // in a box: of their images, from the copy on
  BoxShift copy;        // of the gate or maximum, or of what the way leads up from
  uint32_t gate;        // that it is, or no_id
  uint32_t maximum;     // likewise
};

// The question.
struct TunnelEnds {
  exact::Vector from;
  const exact::Vector *to;  // null: the outside, in a box another copy of the start
  Span<const uint32_t> avoided;
  int64_t floor;
  bool by_cost;  // rather than by width
};

struct TunnelSummary {
  bool there;
  bool outside;          // whether it comes to the outside; from there to where it comes back no points are known
  double level;          // of the widest probe that gets through; infinite without balls
  double length;         // of the polyline
  double cost;           // of its gates; infinite if one is no wider than 0
  uint32_t gate;         // the tightest one; no_id without gates
  uint32_t gates;        // that it passes
  BoxShift shift;        // in a box: so many vectors from the end that was given
  PoreLocation ends[2];  // where it begins and ends; of the outside the point of one
};

class TunnelFinder {
 public:
  void carve(Workspace &workspace, uint32_t maxima, uint32_t gates, uint32_t points);
  // Points of a way that are nearer to the one before than nearness of its level are left out, but for gates, maxima
  // and ends; an end that is a maximum or gate, but for rounding, is that, at its own position.
  // Status::capacity: there is no room for so many points; needed_points() would have sufficed. Status::range: so many
  // boxes away that there are no positions there. Status::stopped: more is not allowed.
  Status find(PoresBuilder &pores, const BallsAround &balls, const TunnelEnds &ends, TunnelSummary &summary,
              Patience patience = Patience());
  void forget() {
    points_.clear();
    needed_ = 0;
    summary_ = {};
  }

  Span<const TunnelPoint> points() const { return points_.items(); }
  // Of the last tunnel; all is 0 if there is none.
  const TunnelSummary &summary() const { return summary_; }
  uint32_t capacity() const { return points_.capacity(); }
  uint32_t needed_points() const { return needed_; }

 private:
  static constexpr double nearness = 0x1p-8, rounding = 2.0;
  // Through a gate from one of its ends to the other one: twice its number, and which end it begins at.
  struct Step {
    uint32_t gate_and_end;
    uint32_t gate() const { return gate_and_end / 2; }
    uint32_t end() const { return gate_and_end % 2; }
    Step back() const { return {gate_and_end ^ 1}; }
  };
  // A maximum, or 0, the outside, in the tree or beside it.
  struct Node {
    double cost;     // of the way there
    Step by;         // the last step of it
    uint32_t slot;   // of the heap; no_id: not seen; in_tree
    BoxShift shift;  // of its copy
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
  Span<uint32_t> first_, heap_;  // [maxima + 2] of steps_; [maxima + 1]
  Span<uint32_t> first_alike_;   // [gates] the first one with the level of each
  Span<Step> steps_, route_;     // [2 gates] by the node that they begin at; [2 maxima + 3]
  FixedVector<TunnelPoint> points_;
  FixedVector<WayPoint> way_;
  TunnelSummary summary_{};
  uint32_t route_count_ = 0, needed_ = 0;
  bool too_far_ = false;  // whether steps were left out that lead too many boxes away
};

}  // namespace hsp
