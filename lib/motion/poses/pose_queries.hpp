// A moving molecule against one at rest: does any ball of the one meet one of the other, which pairs meet, and how far
// apart are they. Both are prepared as trees on lattices of the same step; the pose must have room for the reach of the
// moving one. All decisions are made in integers, as brute force would, about the snapped balls of a pose
// (pose.hpp) or about the ideal ones of a rational pose (rational_pose.hpp); trees only leave out what is certainly
// apart. Balls that touch meet. Nothing is written to, so that many threads may ask at once.
#pragma once

#include "poses/pose.hpp"
#include "poses/rational_pose.hpp"
#include "poses/sphere_tree.hpp"

namespace hsp {

// The pose of the numbers of Pose::make, for these molecules. Status::argument if their lattices have different steps,
// Status::range if the pose has no room for the moving one, or what Pose::make says.
Status make_pose(const SphereTree &fixed, const SphereTree &moving, const double *quaternion, const double *translation,
                 Pose &pose);
// Likewise, of the numbers of RationalPose::make.
Status make_pose(const SphereTree &fixed, const SphereTree &moving, const int32_t *quaternion,
                 const double *translation, RationalPose &pose);

// Two balls, by their ranks in the trees: those that decided the last answer. A caller that asks about one pose after
// the other hands them on; they are tried first, and where poses change little nothing else may be needed. Answers do
// not depend on them, and any numbers will do.
struct PairRanks {
  uint32_t fixed = no_id, moving = no_id;
};

// Whether any two balls meet. If so the witness becomes a pair that does, else it stays as it is.
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const Pose &pose, PairRanks &witness);
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const RationalPose &pose, PairRanks &witness);
inline bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const Pose &pose) {
  PairRanks none;
  return any_balls_meet(fixed, moving, pose, none);
}

// Bounds from earlier poses for the next one, besides the witness. Only `margin` is the caller's. The walk about a free
// pose looks farther by `margin`, in steps, and so learns how far apart the molecules are. Until a ball may have come
// that far, poses are free without a walk. Answers do not depend on it.
struct GapBudget {
  explicit GapBudget(double steps) : margin(steps) {}

  double margin;
  PairRanks witness;
  Pose from;           // a pose that is free,
  double budget = -1;  // and stays free while no ball goes as far as this, in steps; below 0 if there is none
};

// As any_balls_meet, of the same two molecules as all poses before with this budget.
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const Pose &pose, GapBudget &known);
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const RationalPose &pose, GapBudget &known);

struct MeetingPair {
  uint32_t fixed, moving;  // the caller's indices
};

// Writes the pairs that meet, as many as there is room for, and returns how many there are. Ascending if all fit, else
// in no order that means anything.
uint64_t list_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const Pose &pose,
                            Span<MeetingPair> pairs);
uint64_t list_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const RationalPose &pose,
                            Span<MeetingPair> pairs);

struct Overlap {
  uint64_t pairs = 0;
  double volume =
      0;  // of the intersections of the pairs, in cubic steps: where three balls meet it counts more than once
};

// The penalty that docking codes want.
Overlap sum_overlaps(const SphereTree &fixed, const SphereTree &moving, const Pose &pose);

struct PairGap {
  double gap = std::numeric_limits<double>::infinity();  // steps; below 0 if balls overlap
  uint32_t fixed = no_id, moving = no_id;                // the caller's indices
};

// The least distance between two balls, less than 0 for the pair that overlaps deepest; its error is at most 2^-51 of
// the distance of the centres or of the sum of the radii, whichever is more. Of equal ones the first, by the ball at
// rest. Infinite if one molecule has no balls. The witness becomes the pair.
PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const Pose &pose, PairRanks &witness);
PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const RationalPose &pose, PairRanks &witness);
inline PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const Pose &pose) {
  PairRanks none;
  return least_gap(fixed, moving, pose, none);
}

}  // namespace hsp
