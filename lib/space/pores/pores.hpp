// Free space for every probe at once: where the distance to the balls, f(x) = min |x - c| - r, has its maxima and its
// gates. Free space for a probe p is {f > p}. As p falls, components of it are born at maxima and meet at gates:
//
//   maximum   where f is largest nearby: four balls, more if they tie
//   gate      where two components, or two ends of one, meet: three balls, more if they tie
//   class     a component from its birth at a maximum to its death at a gate, where it merges into one that is older,
//             of a larger birth. The outside is the oldest, and has no maximum
//
//     f
//     |     M2                  two cavities M1, M2 and the gate g between them; the outside is left of G
//     |    /  \       M1
//     |   /    \     /  \       at f = p the set {f > p} has two components, one around each maximum
//   p |--/------\---/----\--    below g they are one: the class of M1 dies there, as M2 was born at a larger f
//     | /        \_/      \     below G that of M2 dies: the outside is older
//     |G          g
//
// A probe fits at a point, or passes a gate, if it is narrower than f there. Ids of balls are the caller's. Levels are
// radii of probes beyond the one that is in the model, in lattice steps.
//
// In a periodic box every point is there once for all its copies. Balls of a point are then images: a ball of the box,
// moved by a shift. The first ball of a point is not moved.
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"
#include "core/vec3.hpp"
#include "periodic/periodic_box.hpp"

namespace hsp {

// Ends and parents that are no maximum.
inline constexpr uint32_t pore_outside = no_id - 1;
// Maxima and the outside as numbers from 0 on.
constexpr uint32_t node_of(uint32_t maximum) {
  return maximum == pore_outside ? 0 : maximum + 1;
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

// A maximum or a gate as it is found. Its first three or four balls span it; all that tie follow in a list of their own
// if they are more.
struct CriticalPoint {
  Vec3 position;
  double level;         // rounded to a power of two, the same for all steps of symmetry
  double error;         // how far the level may be off
  uint32_t ball[4];     // in the order of positions; no_id behind the last one
  SmallShift shift[4];  // of images in a box; none of the first
  uint32_t tied;        // how many balls are nearest
  uint32_t first_tied;
};

struct PoreMaximum {
  CriticalPoint point;
  uint32_t gate;  // where its class dies; no_id if it lives down to the floor
  uint32_t into;  // the maximum of the class that it merges into there, pore_outside, or no_id
};

struct PoreGate {
  CriticalPoint point;
  // Maxima that its two sides lead up to, or pore_outside; first where its balls turn counter-clockwise.
  uint32_t end[2];
  SmallShift end_shift[2];  // in a box: which of their copies
  bool merges;              // two classes, rather than two ends of one
  bool winds;  // in a box: its class can be gone along in a direction, or to a copy, that it could not before
  union {
    uint32_t translation;  // until ways up are known: by which it comes from the last gate before it where that is 0
    uint32_t directions;   // then: in which its class goes on for ever, from here on
  };

  // From the copy of its first end to that of the second.
  BoxShift way() const { return end_shift[1].shift() - end_shift[0].shift(); }
};

// Of a way up from a gate: a point of the curve on which three balls, or two, are nearest.
struct WayPoint {
  Vec3 position;
  double level;
  uint32_t ball[3];  // no_id behind the last one
  SmallShift shift[3];
};

}  // namespace hsp
