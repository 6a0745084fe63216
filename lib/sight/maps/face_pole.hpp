// The pole of inaccessibility of a face: the point of it that is farthest from its edges, where a label has most room.
//
// A branch and bound over squares (as in the program polylabel for polygons): no point of a square is deeper in the
// face than its middle by more than half a diagonal, nor farther from the edges than from those points of them that are
// next to the middle. The square that may hold the deepest point is cut in four, until none may hold a point that is
// deeper by more than 1/64 than the deepest one found. At first circles are laid into the face that touch some of its
// edges in the middle and shrink until they fit, so that also in a thin sickle a point is known that lies inside.
#pragma once

#include "maps/stick_map.hpp"

namespace hsp {

// In view coordinates.
struct FacePole {
  double x, y;
  double radius;  // from there to the nearest edge
  double bound;   // nowhere in the face it is more
};

// By how much less than the bound the radius may be, of itself, unless there is too much to look at.
inline constexpr double pole_tolerance = 0x1p-6;
// So many points are looked at, at most; for each all edges around the face.
inline constexpr uint32_t most_pole_looks = 4096;

// Of any face but the unbounded one.
FacePole find_pole(const VisibilityMap &map, uint32_t face);
FacePole find_pole(const StickMap &map, uint32_t face);

}  // namespace hsp
