// A moving molecule against one at rest: does any ball of the one meet one of the other, which pairs meet, and how far
// apart are they. Both are prepared as trees on lattices of the same step; the pose must have room for the reach of the
// moving one. What is decided is decided about the snapped balls of the pose (pose.hpp), in integers, as brute force
// would; trees only leave out what is certainly apart. Balls that touch meet. Nothing is written to, so that many
// threads may ask at once.
#pragma once

#include "poses/pose.hpp"
#include "poses/sphere_tree.hpp"

namespace hsp {

// The pose of the numbers of Pose::make, for these molecules. Status::argument if their lattices have different steps,
// Status::range if the pose has no room for the moving one, or what Pose::make says.
Status make_pose(const SphereTree &fixed, const SphereTree &moving, const double *quaternion, const double *translation,
                 Pose &pose);

// Whether any two balls meet.
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const Pose &pose);

struct MeetingPair {
  uint32_t fixed, moving;  // the caller's indices
};

// Writes the pairs that meet, as many as there is room for, and returns how many there are. Ascending if all fit, else
// in no order that means anything.
uint64_t list_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const Pose &pose,
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
// the distance of the centres. Of equal ones the first, by the ball at rest. Infinite if one molecule has no balls.
PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const Pose &pose);

}  // namespace hsp
