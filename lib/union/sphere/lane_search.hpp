// Steps 1 and 2 of Section 4.2 for one ball after the other, several caps at a time: in floats first, then in doubles.
// Caps and VertexFinder decide what is left open, and the results are the same as theirs. Libraries without kernels of
// lanes have NoSearchInLanes instead.
#pragma once

#include "sphere/cube_candidates.hpp"
#include "sphere/few_caps.hpp"
#include "sphere/great_circles.hpp"
#include "sphere/pair_sweep.hpp"
#include "sphere/vertex_finder.hpp"

namespace hsp {

class SearchInLanes {
 public:
  void carve(Workspace &workspace, uint32_t neighbours);
  // Memory for the candidates of a cube, which the search uses from start() to end().
  static Span<uint32_t> take_candidates(Workspace &workspace, uint32_t neighbours);
  void start(Span<uint32_t> memory_of_candidates) { candidates_.start(memory_of_candidates, target_); }
  void end() { candidates_.end(); }

  // Prepares the search of the balls of one cube. block: the cubes around it. False if its balls are to be searched
  // without lanes.
  bool start_cube(const CubeGrid &grid, uint32_t cube, const CubeBlock &block);
  // The same for balls from `first_own` on that are at most 1.5 `side` from `centre` along each axis, and whose
  // neighbours lie in the block.
  bool start_block(const BallSet &balls, const CubeBlock &block, uint32_t first_own, const double (&centre)[3],
                   double side);
  // Finds the caps of ball i of that cube: their balls, and their floats, which the search keeps. False if that is left
  // to Caps::gather. selected: null, or as for Caps::put_selected_first.
  bool gather(const BallSet &balls, uint32_t i, Caps &caps, DisjointSets *components, const uint32_t *selected);
  // Whether certainly at most so many balls meet ball i. If false, there may be more.
  bool certainly_meets_few(uint32_t i, uint32_t most) const {
    return levels_ == nullptr && candidates_.count(i) <= most;
  }
  // After gather(): the same as VertexFinder::find. The memory of `idle` may be used. Returns the number of clusters of
  // the caps, 0 if they were not counted.
  uint32_t find(const BallSet &balls, Caps &caps, VertexFinder &finder, const FreeIntervals &idle,
                FixedVector<VertexRecord> &vertices, FixedVector<CircleRecord> &circles);

  // The number of clusters of the caps of ball i by n others; 0 if n is larger than most_few_caps or floats are not
  // certain.
  static uint32_t count_few_clusters(Target target, const BallSet &balls, uint32_t i, const uint32_t *others,
                                     uint32_t n);

  // For tests: the target, whether there is a search in lanes, and which of its stages there are.
  void use(Target target, bool use_lanes) {
    target_ = target;
    enabled = use_lanes;
  }
  bool enabled = false;
  bool floats = true;
  bool doubles = true;

 private:
  bool keep_exposed(Caps &caps, ExposedCaps exposed);
  bool find_few(Caps &caps, FewCaps &found);
  // When a search gives up. late: if many pairs take long. soon: also if many circles are left at first.
  enum class GivesUp : uint8_t { never, late, soon };
  // False if it gave up; nothing has been added then.
  bool find_many(const BallSet &balls, Caps &caps, VertexFinder &finder, GivesUp gives_up,
                 FixedVector<VertexRecord> &vertices, FixedVector<CircleRecord> &circles);

  Target target_ = Target::baseline;
  CandidatesInLanes candidates_;
  const RadiusLevels *levels_ = nullptr;  // instead of candidates, if the grid has levels
  Span<float> rows_;                      // the memory of all arrays of sweep_
  PairSweep sweep_;
  Span<uint32_t> uncrossed_;
};

class NoSearchInLanes {
 public:
  static constexpr bool enabled = false;
  void use(Target, bool) {}
  void carve(Workspace &, uint32_t) {}
  static Span<uint32_t> take_candidates(Workspace &, uint32_t) { return {}; }
  void start(Span<uint32_t>) {}
  void end() {}
  bool start_cube(const CubeGrid &, uint32_t, const CubeBlock &) { return false; }
  bool start_block(const BallSet &, const CubeBlock &, uint32_t, const double (&)[3], double) { return false; }
  bool gather(const BallSet &, uint32_t, Caps &, DisjointSets *, const uint32_t *) { return false; }
  bool certainly_meets_few(uint32_t, uint32_t) const { return false; }
  uint32_t find(const BallSet &, Caps &, VertexFinder &, const FreeIntervals &, FixedVector<VertexRecord> &,
                FixedVector<CircleRecord> &) {
    return 0;
  }
  static uint32_t count_few_clusters(Target, const BallSet &, uint32_t, const uint32_t *, uint32_t) { return 0; }
};

using LaneSearch = std::conditional_t<has_lanes, SearchInLanes, NoSearchInLanes>;

}  // namespace hsp
