// Finds the arc, the circle or the face of a ball's boundary on which a point of its sphere lies.
#pragma once

#include "boundary/boundary.hpp"
#include "sphere/great_circles.hpp"

namespace hsp {

// The circle of a cap crosses the circle of plane `other` in a free point: the arc or free circle of ball caps.origin
// on which this point lies. sign: +1 for p+ and -1 for p- of `other` and the cap, in this order; in the opposite order
// the sign is the opposite one.
LoopElement locate_on_boundary(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                               uint32_t cap, const exact::Plane &other, int sign);

// The same for many points of a ball with many caps. If `of_caps` is not empty, find_first_elements() has filled it
// before, with the first element on the circle of each cap.
void find_first_elements(const Caps &caps, const Boundary &boundary, Span<uint32_t> of_caps);
LoopElement locate_from_first(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                              LoopElement first, const exact::Plane &other, int sign);
inline LoopElement locate_on_boundary(const Caps &caps, const exact::Predicates &predicates, const Boundary &boundary,
                                      uint32_t cap, const exact::Plane &other, int sign, Span<const uint32_t> of_caps) {
  if (small_code || of_caps.empty()) return locate_on_boundary(caps, predicates, boundary, cap, other, sign);
  return locate_from_first(caps, predicates, boundary, LoopElement::from_code(of_caps[cap]), other, sign);
}

// The face that contains the highest point of ball i, which must be free. This needs no scratch memory: the arcs of the
// ball name the only caps that keep faces apart.
uint32_t face_of_top(const BallSet &balls, const Boundary &boundary, uint32_t i);

// The face in which a vertical line through (x, y) enters ball i from below; the point must be free. This needs no
// scratch memory either.
uint32_t face_of_entry(const BallSet &balls, const Boundary &boundary, uint32_t i, int64_t x, int64_t y);

}  // namespace hsp
