// Free space for every probe at once: where the distance to the balls, f(x) = min |x - c| - r, has its maxima and its
// gates. Free space for a probe p is {f > p}. As p falls, components of it are born at maxima and meet at gates:
//
//   maximum   where f is largest nearby: four balls, more if they tie
//   gate      where two components, or two ends of one, meet: three balls, more if they tie
//   class     a component from its birth at a maximum to its death at a gate, where it merges into one that is older,
//             of a larger birth. The outside is the oldest, and has no maximum
//
// A probe fits at a point, or passes a gate, if it is narrower than f there. Ids of balls are the caller's. Levels are
// radii of probes beyond the one that is in the model, in lattice steps.
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"
#include "core/vec3.hpp"

namespace hsp {

// Ends and parents that are no maximum.
inline constexpr uint32_t pore_outside = no_id - 1;

// A maximum or a gate as it is found. Its first three or four balls span it; all that tie follow in a list of their own
// if they are more.
struct CriticalPoint {
  Vec3 place;
  double level;
  double doubt;      // how far the level may be off
  uint32_t ball[4];  // ascending in the order of the pore balls; no_id behind the last one
  uint32_t tied;     // how many balls are nearest
  uint32_t first_tied;
};

struct PoreMaximum {
  CriticalPoint point;
  uint32_t gate;  // where its class dies; no_id if it lives down to the floor
  uint32_t into;  // the maximum of the class that it merges into there, pore_outside, or no_id
};

struct PoreGate {
  CriticalPoint point;
  uint32_t
      end[2];   // maxima that its two sides lead up to, or pore_outside; first where its balls turn counter-clockwise
  bool merges;  // two classes, rather than two ends of one
};

}  // namespace hsp
