// An index for a ball with very many caps: it finds the caps that may meet a given cap. The tips of the caps' axes on
// the unit sphere, seen along z, are sorted into squares.
//
//     +---+---+---+---+   A cap lies within its `reach`, the chord of its angle, of the tip of its axis. Two caps have
//     |   | o |   |   |   a common point only if these tips are no farther apart than the sum of the reaches. Most caps
//     +---+--(+)--+---+   are listed in the square of their tip. A square is at least as wide as the largest reach of
//     | o |   |   | o |   these caps, so that few squares around a cap's own hold all caps that it may meet. A few caps
//     +---+---+---+---+   that reach farther are in no square and are always looked at.
#pragma once

#include "core/small_code.hpp"
#include "sphere/caps.hpp"

namespace hsp {

class NearCaps {
 public:
  // Fewer caps are compared each with each, which is as quick. So are large caps, as each of them meets most others. b:
  // the array of the caps' b, in Caps or FloatCaps.
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

  // Builds the index, once, before around().
  void start(const Caps &caps);
  // All caps with a point in common with cap j, j itself, and a few others, ascending. Valid until the next call.
  Span<const uint32_t> around(const Caps &caps, uint32_t j) const;

 private:
  // Whether a cap meets few others: less than a 32nd of the sphere on average, less than 16 spheres all together.
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
  double per_length_ = 0;  // squares for each unit of length
  double farthest_ = 0;    // no cap in a square has a larger reach
};

}  // namespace hsp
