// Builds the pores (pores.hpp): critical points, ways up from gates, classes and the gates where they merge.
#pragma once

#include "core/disjoint_sets.hpp"
#include "core/limits.hpp"
#include "periodic/windings.hpp"
#include "pores/critical_points.hpp"
#include "pores/way_up.hpp"

namespace hsp {

// The gates below which a class of a periodic box first goes on for ever in one, two and three directions: the widest
// gates by which a probe gets so far.
struct PorePassages {
  uint32_t gate[3] = {no_id, no_id, no_id};
  uint32_t maximum[3] = {no_id, no_id, no_id};  // the maximum of that class, its largest cavity
  WindingLattice lattice[3];                    // the windings of that class
  // The widest gate below which some way winds along given vector k of the box: its winding has a multiple of it, not
  // 0.
  uint32_t gate_along[3] = {no_id, no_id, no_id};
};

class PoresBuilder {
 public:
  void carve(Workspace &workspace, const PoreLimits &limits);

  // Finds all maxima and gates above a floor, which is in lattice steps. Status::capacity: a limit is too small, see
  // retry_limits(). Status::range: a way up leads to probes of 2^50 steps. Status::check cannot happen.
  // Status::stopped: patience allows no more work. before: null, or pores that were built of some of these balls, all
  // of which have grown by one length since. They save the search where no new ball is near; the result is the same.
  // They help nothing if they are of other balls, of a box, or of a higher floor.
  Status build(const CubeGrid &grid, int64_t floor, Patience patience = Patience(),
               const PoresBuilder *before = nullptr);
  // The same in a periodic box. Status::range also if it is more than a hundred times longer than wide.
  Status build(const PeriodicImages &images, int64_t floor, Patience patience = Patience());

  // In descending order of levels; points of equal level by their first balls, in the order of positions
  // (exact/rank.hpp).
  Span<const PoreMaximum> maxima() const { return maxima_.part(0, maximum_count_); }
  Span<const PoreGate> gates() const { return gates_.part(0, gate_count_); }
  // How many gates merge two classes.
  uint32_t mergers() const { return merger_count_; }
  // All nearest balls of a point, in the order of positions.
  Span<const uint32_t> tied(const CriticalPoint &point) const {
    const uint32_t named = point.ball[3] == no_id ? 3 : 4;
    if (point.tied == named) return {point.ball, named};
    return tied_.part(point.first_tied, point.first_tied + point.tied);
  }
  // Which images in a box these balls are, in the same order.
  Span<const SmallShift> tied_shifts(const CriticalPoint &point) const {
    const uint32_t named = point.ball[3] == no_id ? 3 : 4;
    if (point.tied == named) return {point.shift, named};
    return tied_shifts_.part(point.first_tied, point.first_tied + point.tied);
  }
  // The periodic box; null without one.
  const PeriodicBox *box() const { return balls_.box(); }
  const PorePassages &passages() const { return passages_; }
  // Of each maximum the gate below which its class goes on for ever, before it dies; or no_id.
  Span<const uint32_t> winding_gates() const { return winding_gates_; }
  // Joins the outside and the maxima above a level by all gates above it. Returns how many components joined() has
  // then: sets of the numbers of node_of(), first the one with the outside, which is alone in it in a box, then the
  // others in the order of their oldest maxima. 0 if patience has ended.
  uint32_t join_above(double level, Patience patience = Patience());
  const Windings &joined() const { return windings_; }
  // Appends to `points` the points of the way up from a gate to its end 0 or 1, without the gate itself.
  Status trace(uint32_t gate, uint32_t end, FixedVector<WayPoint> &points);
  // How many balls are not inside another one.
  uint32_t outer_balls() const { return balls_.own(); }

  // After a success the limits that suffice; with one less of any of them build() would have failed. After a failure
  // the limits as far as they are known.
  const PoreLimits &needed() const { return needed_; }
  // The limits to try again with after Status::capacity.
  PoreLimits retry_limits() const;
  // Work that was done, for measurements.
  const CriticalPoints::Work &work() const { return critical_.work(); }
  uint64_t steps() const { return ways_.steps(); }
  // How many questions the exact stage has answered since carve().
  uint64_t questions() const { return critical_.lines().questions() + ways_.questions(); }

 private:
  void begin(uint32_t balls);
  Status build_from(int64_t floor, Patience &patience, const PoresBuilder *before);
  int compare_levels(const CriticalPoint &a, const CriticalPoint &b);
  bool is_higher(const CriticalPoint &a, const CriticalPoint &b);
  void sort_points(Patience &patience);
  static void put_gate_below(CriticalPoint &gate, CriticalPoint &top);
  void put_gates_below_their_ends();
  Status climb_from_gates(Patience &patience);
  WayUp::End moved_end(const WayUp::End &end, uint32_t gates_ball, uint32_t translation);
  Status merge();
  Status merge_in_box();
  uint32_t note_merger(uint32_t gate, uint32_t a, uint32_t b, uint32_t first);
  void note_passages(uint32_t first, uint32_t end);
  void note_ways_along(uint32_t gate, const WindingLattice &lattice);
  void name_callers_balls();

  PoreLimits limits_, needed_;
  PoreBalls balls_;
  CriticalPoints critical_;
  WayUp ways_;
  NearBalls compared_;  // the balls of two points whose levels are compared
  Span<PoreMaximum> maxima_;
  Span<PoreGate> gates_;
  Span<uint32_t> tied_, parents_, winding_gates_;
  Span<const SmallShift> tied_shifts_;
  Windings windings_;
  PorePassages passages_;
  uint32_t maximum_count_ = 0, gate_count_ = 0, merger_count_ = 0;
};

}  // namespace hsp
