// The border of the free part of one sphere: vertices, half-edges between them, and whole circles.
//
// A half-edge is a directed arc. Its loop keeps the free part on its left, so it runs clockwise about the axis towards
// the ball whose sphere cuts out its circle.
//
// As an example the ball of radius 5 at 0 beside those at (6,0,0) and (0,6,0). Its free part has x <= 3 and y <= 3, and
// one loop of two half-edges:
//   on the circle x = 3     from (3, 3, -2.65), by way of y < 3, to (3, 3, 2.65)
//   on the circle y = 3     from there, by way of x < 3, back to (3, 3, -2.65)
// The vertex at 2.65 is positive, the one at -2.65 is not: n = (6,0,0) x (0,6,0) points up.
#pragma once

#include "core/sorting.hpp"
#include "core/status.hpp"

namespace hsp {

// A free point of three spheres, decided once, at the first of its balls in grid order.
struct VertexRecord {
  uint32_t ball[3];  // ascending
  uint32_t code;

  static constexpr uint32_t positive_bit = 1;  // p+ of the circles of ball[1] and ball[2] on ball[0]
  static constexpr uint32_t tied_bit = 2;      // a degenerate position, decided by the symbolic perturbation

  bool positive() const { return (code & positive_bit) != 0; }
  bool tied() const { return (code & tied_bit) != 0; }
  // 0, 1 or 2: which of the three balls b is.
  uint32_t slot_of(uint32_t b) const { return ball[0] == b ? 0 : ball[1] == b ? 1 : 2; }
  bool has(uint32_t b) const { return ball[0] == b || ball[1] == b || ball[2] == b; }
};

// A vertex with its balls in another order. The sign says whether it is p+ or p- of the circles of ball[1] and ball[2]
// on ball[0]: every exchange of two balls changes it.
struct OrderedVertex {
  uint32_t ball[3];
  int sign;
};

// The balls of a vertex in the order of before(p, q).
template <class Before>
OrderedVertex in_order(const VertexRecord &vertex, Before before) {
  OrderedVertex result{{vertex.ball[0], vertex.ball[1], vertex.ball[2]}, 1};
  const bool odd = sort_three(result.ball[0], result.ball[1], result.ball[2], before);
  if (vertex.positive() == odd) result.sign = -1;
  return result;
}

// A whole intersection circle that no other ball covers.
struct CircleRecord {
  uint32_t ball[2];  // ascending
  uint32_t loop[2];  // the loop it makes on each of them
};

// An arc of a loop. Its circle is named by the ball that cuts it out.
struct HalfEdge {
  uint32_t vertex;  // where it starts
  uint32_t circle;
  uint32_t next;  // the half-edge that starts where it ends
  uint32_t loop;
};

}  // namespace hsp
