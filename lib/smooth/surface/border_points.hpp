// Names of points on the borders of concave patches: ends of arcs, and points that are tested. The position of a point
// follows from its name and the balls alone.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// The coordinate axis that a vector is least along.
inline int8_t axis_least_along(const Vec3 &d) {
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  if (x <= y && x <= z) return 0;
  return y <= z ? 1 : 2;
}

struct BorderPoint {
  enum class Kind : uint8_t {
    corner,        // of the creases of vertices id[0] < id[1] < id[2]; one of two, by the sign
    cusp,          // of the circle of balls id[0] < id[1], on the side of the second one if the sign is positive
    towards_ball,  // where the patch of vertex id[0] meets the convex patch of its ball id[1]
    on_crease      // a point of the circle in which the probes at vertices id[0] and id[1] meet, by one of three axes:
                   // the same point in every width
  };
  Kind kind;
  int8_t sign;  // or the axis
  uint32_t id[3];
  uint32_t number = no_number;  // of the corner (cut_patches.hpp): its position may be kept by it

  static constexpr uint32_t no_number = UINT32_C(1) << 31;
};

// The two balls of a vertex that are not in `slot`, in such an order that first, second and slot run counter-clockwise
// about the direction from the vertex to its balls.
struct SideOfPatch {
  uint32_t first, second;  // slots
};
SideOfPatch side_of_patch(const VertexRecord &vertex, uint32_t slot);

}  // namespace hsp
