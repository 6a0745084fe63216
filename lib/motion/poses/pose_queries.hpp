// Questions about a moving molecule and one at rest: whether any two balls meet, which pairs meet, how far apart the
// molecules are. Both are prepared as trees on lattices of the same step; the pose must have room for the reach of the
// moving one. Integers decide, with the result of testing all pairs, about the snapped balls of a pose (pose.hpp), or
// the exact images of a rational pose (rational_pose.hpp). Trees only leave out balls that are certainly apart. Balls
// that touch meet. Trees and poses are only read, so that many threads may ask at once.
#pragma once

#include "poses/pose.hpp"
#include "poses/rational_pose.hpp"
#include "poses/sphere_tree.hpp"

namespace hsp {

// Makes a pose for a molecule as Pose::make() or RationalPose::make() does. The lattice of the one that rests has the
// same step. Status::range if the pose has no room for the moving one, or the status of make().
template <class Number, class AnyPose>
Status make_pose(const SphereTree &moving, const Number *quaternion, const double *translation, AnyPose &pose) {
  const Status status = AnyPose::make(quaternion, translation, moving.lattice(), pose);
  if (status != Status::ok) return status;
  return pose.has_room_for(moving.reach()) ? Status::ok : Status::range;
}

// The questions below are about a Pose or a RationalPose.

// Two balls, by their ranks in the trees: the pair that decided the last answer. A caller that asks about many poses
// passes it on. The pair is tried first; if poses change little, it may decide alone. Answers do not depend on it, and
// any numbers are allowed.
struct PairRanks {
  uint32_t fixed = no_id, moving = no_id;
};

// Whether any two balls meet. If so the witness becomes a pair that meets, else it stays as it is.
template <class AnyPose>
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose, PairRanks &witness);
inline bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const Pose &pose) {
  PairRanks none;
  return any_balls_meet(fixed, moving, pose, none);
}

// Bounds from earlier poses for the next one, besides the witness. The caller sets only `margin`, in steps. The walk at
// a free pose looks farther by `margin`, and so finds how far apart the molecules are. As long as no ball can have gone
// that far since, poses are free without a walk. Answers do not depend on it.
struct GapBudget {
  explicit GapBudget(double steps) : margin(steps) {}

  double margin;
  PairRanks witness;
  Pose from;           // a free pose
  double budget = -1;  // poses are free while no ball is as far as this from its place in `from`, in steps; < 0: none
};

// As any_balls_meet() above. The two molecules are the same in all calls with one budget.
template <class AnyPose>
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose, GapBudget &known);

struct MeetingPair {
  uint32_t fixed, moving;  // the caller's indices
};

// Writes the pairs that meet, as many as there is room for, and returns how many there are. They are ascending if all
// fit, else in an arbitrary order.
template <class AnyPose>
uint64_t list_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose,
                            Span<MeetingPair> pairs);

struct Overlap {
  uint64_t pairs = 0;
  double volume =
      0;  // the sum of the volumes of all pairs' intersections, in cubic steps: a point counts once for each pair
};

// The sum over all pairs that meet: the penalty of docking codes.
Overlap sum_overlaps(const SphereTree &fixed, const SphereTree &moving, const Pose &pose);

struct PairGap {
  double gap = std::numeric_limits<double>::infinity();  // steps; below 0 if balls overlap
  uint32_t fixed = no_id, moving = no_id;                // the caller's indices
};

// The least distance between two balls; below 0 for the pair that overlaps deepest. Its error is at most 2^-51 times
// the distance of the centres or the sum of the radii, whichever is larger. Of equal pairs the first, by the ball at
// rest. Infinite if one molecule has no balls. The witness becomes the pair.
template <class AnyPose>
PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose, PairRanks &witness);
inline PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const Pose &pose) {
  PairRanks none;
  return least_gap(fixed, moving, pose, none);
}

}  // namespace hsp
