// Answers from the tree in which classes merge: the class of a maximum for a probe, the gate at which two classes meet,
// and the maximum that a way up from a point leads to.
#pragma once

#include "pores/ascent.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

// The classes of built pores. A class has the number of its maximum, or pore_outside.
class ClassTree {
 public:
  explicit ClassTree(const PoresBuilder &pores)
      : maxima_(pores.maxima()), gates_(pores.gates()), winding_gates_(pores.winding_gates()) {}

  // The class that a maximum belongs to in the free space of a probe of this level; no_id if the probe does not fit at
  // the maximum.
  uint32_t class_at(uint32_t maximum, double level) const;
  // The gate at which the classes of two maxima meet: the tightest gate of the widest path between them. no_id if they
  // do not meet above the floor, or if the maxima are the same.
  uint32_t gate_between(uint32_t a, uint32_t b) const;
  // In a box: the tightest gate of the widest way from a maximum to another copy of it; no_id if no such way is above
  // the floor.
  uint32_t gate_to_copy(uint32_t maximum) const;

 private:
  Span<const PoreMaximum> maxima_;
  Span<const PoreGate> gates_;
  Span<const uint32_t> winding_gates_;
};

// The place of a point in the pores.
struct PoreLocation {
  double level;                        // f at the point; infinite without balls
  uint32_t ball;                       // a nearest ball; no_id without balls
  uint32_t maximum;                    // that a way up leads to, or pore_outside; no_id unless f is above the floor
  BoxShift ball_shift, maximum_shift;  // in a box: of the nearest image, and of the copy of the maximum
};

// Finds f, a nearest ball and the maximum to which one way up from a point leads. Another way up may lead to another
// maximum. But both are of one class for any probe that fits at the point and is narrower than f by a lattice step or
// more. Status::range: the point is too many boxes away, or a way is lost between balls that are more than 2^35 steps
// apart. Status::check cannot happen.
Status locate(const PoresBuilder &pores, const BallsAround &balls, const exact::Vector &point, int64_t floor,
              PoreLocation &location);
// The second half of locate(), for a way up that has begun at `start`: sets the maximum of the location and its copy.
Status follow_up(const PoresBuilder &pores, const BallsAround &balls, Ascent &way, const exact::Vector &start,
                 int64_t floor, PoreLocation &location);

// The widest probe that gets from one point to another.
struct PorePassage {
  bool passes;       // whether some probe wider than the floor gets there
  double level;      // of the widest such probe; 0 if there is none
  uint32_t gate;     // the gate that stops wider ones, or no_id
  uint32_t ball;     // the ball that stops wider ones, as it is nearest to an end; or no_id
  uint32_t ends[2];  // the maxima above the points
};
// to: the other point; null for the outside. In a periodic box the way may end at any copy of `to`; null is then
// another copy of `from`.
Status find_passage(const PoresBuilder &pores, const BallsAround &balls, const exact::Vector &from,
                    const exact::Vector *to, int64_t floor, PorePassage &passage);

}  // namespace hsp
