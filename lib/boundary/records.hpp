// What Step 2 leaves behind: vertices and free circles, in terms of the grid's ball ids.
#pragma once

#include <cstdint>

namespace hsp {

// A free point of three spheres, decided once, at the first of its balls in grid order.
struct VertexRecord {
  uint32_t ball[3];  // ascending
  uint32_t code;

  static constexpr uint32_t positive_bit = 1;  // p+ of the circles of ball[1] and ball[2] on ball[0]
  static constexpr uint32_t tied_bit = 2;      // another sphere or a tangency passes through it: the tie rule decided

  bool positive() const { return (code & positive_bit) != 0; }
  bool tied() const { return (code & tied_bit) != 0; }
};

// A whole intersection circle that no other ball covers.
struct CircleRecord {
  uint32_t ball[2];  // ascending
  uint32_t loop[2];  // the loop it makes on each of them
};

}  // namespace hsp
