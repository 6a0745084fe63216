// Points all over the unit sphere at about one distance from each other: on circles of latitude, one after the other,
// so that consecutive ones are near each other.
#pragma once

#include <cstdint>

#include "core/elementary.hpp"
#include "core/vec3.hpp"

namespace hsp {

// Larger distances yield the points of this one.
inline constexpr double largest_ring_spacing = 2.0;

// About how many points there are; they are never more than 1.5 times that and 8.
inline double expected_ring_points(double spacing) {
  return 14.6 / (spacing * spacing);  // 4 pi over sqrt(3)/2, the area for each vertex of equilateral triangles
}

// Calls sink(point) for every point. The points of a circle are left out if needs(sine, cosine), of the circle's angle
// from the z axis, says that none of them is needed. This is not asked for circles of few points.
template <class Needs, class Sink>
void for_each_ring_point(double spacing, Needs needs, Sink sink) {
  constexpr uint32_t few = 256;
  constexpr double height_of_triangle = 0.8660254037844386;
  const double step = spacing < largest_ring_spacing ? spacing : largest_ring_spacing;
  const auto rings = static_cast<uint32_t>(pi / (height_of_triangle * step) + 0.5);
  for (uint32_t ring = 0; ring < rings; ++ring) {
    const SinCos polar = sin_cos(pi * (ring + 0.5) / rings);
    const auto points = static_cast<uint32_t>(2 * pi * polar.sine / step + 0.5);
    if (points == 0 || (points > few && !needs(polar.sine, polar.cosine))) continue;
    const SinCos turn = sin_cos(2 * pi / points);
    SinCos at = sin_cos(ring % 2 == 0 ? 0.0 : pi / points);
    for (uint32_t k = 0; k < points; ++k) {
      sink(Vec3{polar.sine * at.cosine, polar.sine * at.sine, polar.cosine});
      at = {at.cosine * turn.cosine - at.sine * turn.sine, at.sine * turn.cosine + at.cosine * turn.sine};
    }
  }
}

}  // namespace hsp
