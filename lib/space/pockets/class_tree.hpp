// Answers from the tree of merges: which class a maximum is in at a probe, where two classes meet, and which maximum a
// point is below.
#pragma once

#include "pores/ascent.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

// The classes of pores that were built. Numbers are those of maxima, or pore_outside.
class ClassTree {
 public:
  explicit ClassTree(const PoresBuilder &pores)
      : maxima_(pores.maxima()), gates_(pores.gates()), winding_gates_(pores.winding_gates()) {}

  // The class that a maximum belongs to where a probe of this level fits; no_id if it does not fit there.
  uint32_t class_at(uint32_t maximum, double level) const;
  // The gate where the classes of two maxima meet, which is the tightest one of the widest path between them; no_id if
  // they do not above the floor, or if both are the same.
  uint32_t gate_between(uint32_t a, uint32_t b) const;
  // In a box: the tightest gate of the widest way from a maximum to another copy of it; no_id if none is above the
  // floor.
  uint32_t gate_to_copy(uint32_t maximum) const;

 private:
  Span<const PoreMaximum> maxima_;
  Span<const PoreGate> gates_;
  Span<const uint32_t> winding_gates_;
};

// Where a point is.
struct PoreLocation {
  double level;                        // f there; infinite without balls
  uint32_t ball;                       // a nearest one; no_id without balls
  uint32_t maximum;                    // above it, or pore_outside; no_id if the point is not above the floor
  BoxShift ball_shift, maximum_shift;  // in a box: of the image that is nearest, and of the copy above the point
};

// The maximum that one way up leads to. Another one may lead to another maximum, but to no other class for any probe
// that fits at the point and is narrower by a lattice step or more. Status::range: too many boxes away, or a way is
// lost between balls that are more than 2^35 steps apart. Status::check cannot happen.
Status locate(const PoresBuilder &pores, const BallsAround &balls, const exact::Vector &point, int64_t floor,
              PoreLocation &location);
// The rest of that, for a way up that has begun at `start`: sets the maximum of the location and its copy.
Status follow_up(const PoresBuilder &pores, const BallsAround &balls, Ascent &way, const exact::Vector &start,
                 int64_t floor, PoreLocation &location);

// The widest probe from one point to another, or to the outside, which is null. In a periodic box any copy of the other
// one will do, and instead of the outside another copy of the first one.
struct PorePassage {
  bool passes;       // whether a probe does that is wider than the floor
  double level;      // of the widest one; 0 if none does
  uint32_t gate;     // that stops wider ones, or no_id
  uint32_t ball;     // at an end that does, or no_id
  uint32_t ends[2];  // the maxima above the points
};
Status find_passage(const PoresBuilder &pores, const BallsAround &balls, const exact::Vector &from,
                    const exact::Vector *to, int64_t floor, PorePassage &passage);

}  // namespace hsp
