// Where points of one sphere lie on its loops and faces.
#pragma once

#include "boundary/boundary.hpp"
#include "sphere/great_circles.hpp"

namespace hsp {

// The arc or free circle of ball caps.origin on which the circle of a cap crosses another circle in a free point; sign
// as seen from that other circle, so that seen from the cap it is the opposite one.
LoopElement locate_on_boundary(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                               uint32_t cap, const exact::Plane &other, int sign);

// The same for many points of a ball with many caps: where `of_caps` is not empty, it has a number for each cap, which
// are filled once before.
void find_first_elements(const Caps &caps, const Boundary &boundary, Span<uint32_t> of_caps);
LoopElement locate_from_first(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                              LoopElement first, const exact::Plane &other, int sign);
inline LoopElement locate_on_boundary(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                                      uint32_t cap, const exact::Plane &other, int sign, Span<const uint32_t> of_caps) {
  if (small_code || of_caps.empty()) return locate_on_boundary(caps, predicates, boundary, cap, other, sign);
  return locate_from_first(caps, predicates, boundary, LoopElement::from_code(of_caps[cap]), other, sign);
}

// The face that contains the highest point of ball i, which must be free. No scratch memory: the arcs of the ball name
// the only caps that keep faces apart.
uint32_t face_of_top(const BallSet &balls, const Boundary &boundary, uint32_t i);

// The face in which a vertical line through (x, y) enters ball i from below; that point must be free. No scratch
// memory either.
uint32_t face_of_entry(const BallSet &balls, const Boundary &boundary, uint32_t i, int64_t x, int64_t y);

}  // namespace hsp
