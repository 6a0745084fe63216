// The candidates around one cube after the other (candidate_block.hpp). Libraries without kernels of lanes have
// NoCandidates instead.
#pragma once

#include <type_traits>

#include "sphere/candidate_block.hpp"
#include "sphere/caps.hpp"

namespace hsp {

class CandidatesInLanes {
 public:
  static constexpr uint32_t number_of_arrays = 5;  // into which the memory is divided

  // From start() to end() this memory holds candidates, and its owner leaves it alone.
  void start(Span<uint32_t> memory, Target target);
  void end();

  // Prepares for the balls of one cube, which begin at `first_own`: the balls in the block are their candidates. False
  // if there is no room for these.
  bool start_cube(const CubeGrid &grid, uint32_t cube, uint32_t first_own, const CubeBlock &block);
  // The same for balls from `first_own` on that are at most 1.5 `side` from `centre` along each axis.
  bool start_block(const BallSet &balls, const CubeBlock &block, uint32_t first_own, const double (&centre)[3],
                   double side);

  // The candidates that are not certainly disjoint from ball i, in the order of the block: near_candidates(),
  // count_candidates() and later_candidates() of candidate_block.hpp. count() leaves out ball i itself.
  uint32_t near(uint32_t i, uint32_t *ids, uint32_t most, uint32_t &earlier) const {
    return near_candidates(target_, block_, slot(i), ids, most, earlier);
  }
  uint32_t count(uint32_t i) const { return count_candidates(target_, block_, slot(i)) - 1; }
  uint32_t later(uint32_t i, uint32_t *ids, uint32_t most) const {
    return later_candidates(target_, block_, slot(i), ids, most);
  }

 private:
  uint32_t slot(uint32_t i) const { return own_rank_ + (i - first_own_); }

  Target target_ = Target::baseline;
  Span<uint32_t> memory_;
  CandidateBlock block_;
  uint32_t first_own_ = 0;  // the first ball of the cube
  uint32_t own_rank_ = 0;   // its number among the candidates
};

class NoCandidates {
 public:
  void start(Span<uint32_t>, Target) {}
  void end() {}
  bool start_cube(const CubeGrid &, uint32_t, uint32_t, const CubeBlock &) { return false; }
  uint32_t later(uint32_t, uint32_t *, uint32_t) const { return 0; }
};

using CubeCandidates = std::conditional_t<has_lanes, CandidatesInLanes, NoCandidates>;

}  // namespace hsp
