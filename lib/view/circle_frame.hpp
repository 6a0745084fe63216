// The basis in which a circle of a sphere is told in a view (projected_arcs.hpp): `along` is horizontal and is the
// major axis of the ellipse, `across` lies in the circle's plane and is seen shortened, a quarter turn
// counter-clockwise from it. Nothing is ill-conditioned in three dimensions when the circle is seen edge on.
#pragma once

#include "view/view_frame.hpp"

namespace hsp {

struct CircleFrame {
  // Unit vectors in view coordinates.
  Vec3 axis, along, across;
  // A walk clockwise about the axis, with what lies outside the half-space on its left, goes counter-clockwise (+1) or
  // clockwise (-1) in the view plane.
  double walk;

  // A silhouette: the axis points away from the viewer.
  CircleFrame() : axis{0.0, 0.0, -1.0}, along{1.0, 0.0, 0.0}, across{0.0, 1.0, 0.0}, walk(1.0) {}
  // v: normal of the circle's plane, of any length.
  CircleFrame(const ViewFrame &frame, const exact::Vector &v) {
    const Vec3 n = frame.to_view(exact::to_double(v));
    const double length = std::sqrt(dot(n, n));
    axis = {n.x / length, n.y / length, n.z / length};
    const double s = std::sqrt(axis.x * axis.x + axis.y * axis.y);
    walk = axis.z < 0.0 ? 1.0 : -1.0;
    if (s == 0.0) {
      along = {1.0, 0.0, 0.0};
      across = {0.0, 1.0, 0.0};
      return;
    }
    along = {-axis.y / s, axis.x / s, 0.0};
    const double steep = axis.z / s;
    across = {walk * steep * axis.x, walk * steep * axis.y, -walk * s};
  }
};

}  // namespace hsp
