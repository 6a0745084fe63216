// The rest of a chord. A chord is the radical line of three balls, as far as it is inside all of them. Every other ball
// may cut it, at the plane of equal power. The rest is nearer to the three balls than to any other, in power distance.
//
// A chord is asked for at one of its balls, between the points p- and p+ where the circles of the two other balls
// cross. A cap that holds both points leaves nothing. A cap that holds neither takes nothing. A cap that holds one of
// them clips that end, at the power vertex of the four balls. Of two caps that clip the same end, the one that takes
// more counts. Two caps that clip different ends leave something iff the power vertex of the one is nearer to its balls
// than to the ball of the other. The symbolic perturbation decides ties.
#pragma once

#include "sphere/cap_pair.hpp"
#include "sphere/vertex_finder.hpp"

namespace hsp {

struct ChordEnds {
  // The caps that clip the chord at the side of p- and of p+; no_id if none does and the chord ends in a free vertex.
  uint32_t clipper[2];

  uint32_t free_ends() const { return (clipper[0] == no_id ? 1U : 0U) + (clipper[1] == no_id ? 1U : 0U); }
};

class ChordClipper {
 public:
  void carve(Workspace &workspace, uint32_t capacity);

  // Finds, among many caps, those whose planes may touch the power cell, in memory that is idle before start().
  ExposedCaps exposed_caps() const { return {tests_.cap, covered_}; }
  // Memory that is idle before start().
  CapTests &memory() { return tests_; }
  // There must be no caps of balls that lie inside other balls.
  void start(const Caps &caps);
  // Whether anything is left of the chord of caps j < k, and between which ends. Pairs are asked about once each, in
  // the order of j and then of k.
  bool clip(const Caps &caps, uint32_t j, uint32_t k, ChordEnds &ends);

 private:
  enum class Answer { gone, left, uncertain };
  Answer clip_in_doubles(const Caps &caps, uint32_t j, uint32_t k, const CapPair &pair, ChordEnds &ends);

  CapTests tests_;
  Span<uint8_t> covered_;  // 1 if the cap's circle lies certainly inside another cap: no chord ends on it
  uint32_t hint_ = 0;      // the group of test caps that held both ends of the last chord, by doubles
  uint32_t holder_ = 0;    // the cap that did, by integers
};

}  // namespace hsp
