// Balls and sticks as they are seen: what is painted of them and in which order, if they have one. Nothing of sticks
// meets balls or sticks but inside the balls that they end in; stick_sweep.hpp checks that.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/limits.hpp"
#include "core/workspace.hpp"
#include "maps/stick.hpp"

namespace hsp {

struct StickLimits {
  uint32_t balls = 0;  // of the model
  uint32_t sticks = 0;
  uint32_t pairs = 0;  // of balls and parts of sticks that are seen one over the other; twice if balls meet
  uint32_t edges = 0;  // around what is seen of them, where they have no drawing order
};

// Limits that suffice for most molecules whose balls and sticks have a drawing order. Status::range if one would be
// larger than max_count.
constexpr Status default_limits(uint32_t balls, StickLimits &limits) {
  if (balls > (max_count - 64) / 64) return Status::range;
  limits = {balls, 2 * balls, 64 * balls + 64, 0};
  return Status::ok;
}

// Bodies that cannot be drawn, or have no drawing order, with the numbers that the caller gave.
enum class StickConflict : uint32_t {
  none = 0,
  balls_meet = 1,     // two balls: no order
  no_ball = 2,        // a stick, and a ball that does not exist
  same_ends = 3,      // two sticks; or a stick twice, both ends of which are one ball
  thin_ball = 4,      // a stick, and a ball at its end that is not thicker
  sharp_angle = 5,    // two sticks that meet outside the ball where both end
  sticks_meet = 6,    // two sticks
  stick_in_ball = 7,  // a stick, and a ball that it runs into
  cycle = 8,          // a stick over others that are over it, and how many balls and parts of sticks that are: no order
};

struct StickViolation {
  StickConflict conflict = StickConflict::none;
  uint32_t first = no_id, second = no_id;
};

// The part that a stick from behind leaves of the disc of the ball at its nearer end: the silhouette between the angles
// middle - half and middle + half is not seen, but the junction circle from t = from to pi - from.
struct StickBite {
  double middle, half;
  double from;
  uint32_t stick;
};

// A ball, or a part of a stick.
struct StickPath {
  uint32_t ball;   // of grid order: itself, or the one that a part belongs to
  uint32_t stick;  // no_id for a ball
  uint32_t part;
};

struct StickView {
  ViewFrame frame;
  Span<PlacedBall> balls;  // grid order
  FixedVector<Stick> sticks;
  Span<uint32_t> first_bite;     // [balls + 1]
  FixedVector<StickBite> bites;  // ball after ball, counter-clockwise
  FixedVector<StickPath> paths;  // in drawing order

  void carve(Workspace &workspace, const StickLimits &limits) {
    balls = workspace.take<PlacedBall>(limits.balls);
    sticks = FixedVector<Stick>(workspace.take<Stick>(limits.sticks));
    first_bite = workspace.take<uint32_t>(static_cast<uint64_t>(limits.balls) + 1);
    bites = FixedVector<StickBite>(workspace.take<StickBite>(limits.sticks));
    paths = FixedVector<StickPath>(workspace.take<StickPath>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks)));
  }
  void clear() {
    sticks.clear();
    bites.clear();
    paths.clear();
  }
  Span<const StickBite> bites_of(uint32_t ball) const {
    return bites.items().part(first_bite[ball], first_bite[ball + 1]);
  }
};

}  // namespace hsp
