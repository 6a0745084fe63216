// The rest of a chord: the radical line of three balls, inside all of them, is cut by every other ball at the plane
// of equal power. The rest lies nearer to the three balls than to any other, in power distance.
//
// A chord is asked for at one of its balls, between the points p- and p+ where the circles of the two other ones cross.
// A cap that holds both points leaves nothing, one that holds neither takes nothing, and one that holds one of them
// clips that end, at the power vertex of the four balls. Of two caps that clip the same end the nearer one counts; two
// that clip both ends leave something iff the power vertex of the one is nearer to its balls than to the other. The
// symbolic perturbation decides ties.
#pragma once

#include "sphere/cap_pair.hpp"
#include "sphere/vertex_finder.hpp"

namespace hsp {

struct ChordEnds {
  // The caps that clip the chord at the side of p- and of p+; no_id where nothing does and it ends in a free vertex.
  uint32_t clipper[2];

  uint32_t free_ends() const { return (clipper[0] == no_id ? 1U : 0U) + (clipper[1] == no_id ? 1U : 0U); }
};

class ChordClipper {
 public:
  void carve(Workspace &workspace, uint32_t capacity);

  // Of many caps, those whose planes may touch the power cell, in memory that is idle before start.
  ExposedCaps exposed_caps() const { return {tests_.cap, covered_}; }
  // All of it, idle until start.
  CapTests &memory() { return tests_; }
  // Of balls inside other ones there must be no caps.
  void start(const Caps &caps);
  // Whether anything is left of the chord of the caps j < k, and between which ends. For each j and then each k, all
  // pairs once.
  bool clip(const Caps &caps, uint32_t j, uint32_t k, ChordEnds &ends);

 private:
  enum class Answer { gone, left, uncertain };
  Answer clip_in_doubles(const Caps &caps, uint32_t j, uint32_t k, const CapPair &pair, ChordEnds &ends);

  CapTests tests_;
  Span<uint8_t> covered_;  // the cap's circle lies certainly inside another cap: no chord ends on it
  uint32_t hint_ = 0;      // the group of test caps that held both ends of the last chord
  uint32_t holder_ = 0;    // the cap of which integers said so
};

}  // namespace hsp
