// Free space for every probe at once: the maxima and the gates of the distance to the balls, f(x) = min |x - c| - r.
// Free space for a probe of radius p is {f > p}. As p falls, components of it are born at maxima and meet at gates:
//
//   maximum   a local maximum of f: four balls are nearest, more if they tie
//   gate      a saddle of f, where two components, or two ends of one, meet: three balls are nearest, more if they tie
//   class     a component from its birth at a maximum to its death at a gate, where it merges into an older one, born
//             at a larger f. The outside is the oldest, and has no maximum
//
//     f
//     |     M2                  two cavities M1, M2 and the gate g between them; the outside is left of G
//     |    /  \       M1
//     |   /    \     /  \       at f = p the set {f > p} has two components, one around each maximum
//   p |--/------\---/----\--    below g they are one: the class of M1 dies at g, as M2 was born at a larger f
//     | /        \_/      \     below G the class of M2 is dead: the outside is older
//     |G          g
//
// A probe fits at a point, or passes a gate, if its radius is less than f there. Ids of balls are the caller's. A level
// is a value of f: the radius of a probe in lattice steps, beyond the probe radius that is part of the model's radii.
//
// In a periodic box a point is listed once for all its copies. Its balls are then images: a ball of the box and the
// shift by which it is moved. The first ball of a point is not moved.
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"
#include "core/vec3.hpp"
#include "periodic/periodic_box.hpp"

namespace hsp {

// In the place of a maximum: the outside.
inline constexpr uint32_t pore_outside = no_id - 1;
// The outside and the maxima, numbered from 0 on.
constexpr uint32_t node_of(uint32_t maximum) {
  return maximum == pore_outside ? 0 : maximum + 1;
}

struct PoreLimits {
  uint32_t balls = 0;  // in a box together with their images
  uint32_t maxima = 0;
  uint32_t gates = 0;
  uint32_t tied = 0;        // the sum of all nearest balls of points where more tie than span the point
  uint32_t candidates = 0;  // balls that may be nearest, summed over all cubes that are being halved
  uint32_t near = 0;        // balls around one piece of a way up, or candidates of one cube whose sets are tried
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, PoreLimits &limits) {
  if (balls > (max_count - 2048) / 8) return Status::range;
  limits = {balls, 2 * balls + 64, 4 * balls + 128, balls + 256, 4 * balls + 2048, balls + 16};
  return Status::ok;
}

// Multiples of the vectors of a box in one number, 0 for none.
struct SmallShift {
  static constexpr int32_t largest = 511;
  uint32_t bits = 0;

  constexpr bool operator==(const SmallShift &other) const = default;
  static constexpr bool fits(const BoxShift &shift) {
    bool fits = true;
    for (const int32_t k : shift.k) fits = fits && k <= largest && -k <= largest;
    return fits;
  }
  static constexpr SmallShift of(const BoxShift &shift) {
    const auto bits = [&](int axis) { return static_cast<uint32_t>(shift.k[axis]) & 1023; };
    return {bits(0) | bits(1) << 10 | bits(2) << 20};
  }
  constexpr BoxShift shift() const {
    const auto multiple = [&](int axis) { return static_cast<int32_t>(((bits >> 10 * axis & 1023) ^ 512)) - 512; };
    return {{multiple(0), multiple(1), multiple(2)}};
  }
};

// The name of a point: the balls that span it.
struct PointName {
  uint32_t ball[4];     // no_id behind the last one
  SmallShift shift[4];  // which images they are, in a box

  bool operator==(const PointName &other) const = default;
};

// A maximum or a gate as it is found. A gate is spanned by three of its nearest balls, a maximum by four. If more balls
// tie, all of them are in a list of their own (PoresBuilder::tied()). Its balls are in the order of positions, and the
// shift of the first is 0.
struct CriticalPoint : PointName {
  Vec3 position;
  double level;         // rounded to a multiple of a power of two, the same for points that symmetry maps to each other
  double error;         // how far the level may be off
  uint32_t tied;        // how many balls are nearest
  uint32_t first_tied;  // the first of them in the list, if they are more than span it
};

struct PoreMaximum {
  CriticalPoint point;
  uint32_t gate;  // where its class dies; no_id if it lives down to the floor
  uint32_t into;  // the maximum of the class that it merges into there, or pore_outside; no_id if it does not die
};

struct PoreGate {
  CriticalPoint point;
  // The maxima that its two sides lead up to, or pore_outside; first the side from which its first three balls are seen
  // counter-clockwise.
  uint32_t end[2];
  SmallShift end_shift[2];  // in a box: which copies of the maxima
  bool merges;              // whether it merges two classes; else it joins two ends of one
  bool winds;  // in a box: whether its class leads into a new direction, or to a copy that it did not lead to before
  union {
    uint32_t translation;  // until ways up are known: takes the last gate before it with translation 0 to this one
    uint32_t directions;   // after that: in how many directions its class goes on for ever, from this gate on
  };

  // The shift from the copy of its first end to the copy of the second.
  BoxShift way() const { return end_shift[1].shift() - end_shift[0].shift(); }
};

// A point of a way up from a gate: it is on a curve on which three balls, or two, are nearest.
struct WayPoint {
  Vec3 position;
  double level;
  uint32_t ball[3];  // no_id behind the last one
  SmallShift shift[3];
};

}  // namespace hsp
