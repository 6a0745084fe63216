// Of one ball with very many caps, those that may meet one of them: an index by where their axes are, seen along z.
//
//     +---+---+---+---+   A cap lies within `reach` of its axis, the chord of its angle. Two caps have a common point
//     |   | o |   |   |   only if their axes are no farther apart than their reaches together. Most caps are in the
//     +---+--(+)--+---+   square of their axis. A square is as wide as their largest reach, so that those around a
//     | o |   |   | o |   cap's own square hold all that it may meet. A few that reach farther are in no square and are
//     +---+---+---+---+   always looked at.
#pragma once

#include "core/small_code.hpp"
#include "sphere/caps.hpp"

namespace hsp {

class NearCaps {
 public:
  // Fewer are compared each with each: that is as quick. Of large ones one meets most of the others. b: of the caps, as
  // Caps or FloatCaps have it.
  static constexpr uint32_t fewest = 128;
  template <class Real>
  static bool are_many(const Caps &caps, const Real *b) {
    return !small_code && caps.count >= fewest && are_small(b, caps.count);
  }

  // Memory, [caps] each.
  struct Memory {
    Span<uint32_t> square_first, in_square, near;
    Span<float> reach;
  };
  explicit NearCaps(const Memory &memory) : memory_(memory) {}

  // Of all caps, once before the others.
  void start(const Caps &caps);
  // Those that have a common point with cap j, j itself, and a few others, ascending. Valid until the next call.
  Span<const uint32_t> around(const Caps &caps, uint32_t j) const;

 private:
  // Whether one meets few of them: on average they are a 32nd of the sphere at most, and together 16 spheres.
  template <class Real>
  static bool are_small(const Real *b, uint32_t count) {
    Real parts = 0;
    for (uint32_t k = 0; k < count; ++k) parts += 1 - b[k];
    return parts < static_cast<Real>(count) * Real{0.0625} && parts < 32;
  }

  uint32_t square_of(double coordinate) const;

  Memory memory_;
  uint32_t squares_ = 1;   // along an axis
  uint32_t placed_ = 0;    // caps in squares; behind them in in_square are those that reach farther
  double per_length_ = 0;  // squares
  double farthest_ = 0;    // reach of a cap in a square
};

}  // namespace hsp
