#include "surface/probe_positions.hpp"

#include "exact/power.hpp"

namespace hsp {
namespace {

bool touch_from_outside(const BallSet &balls, uint32_t a, uint32_t b) {
  return exact::power(balls.exact_difference(a, b), balls.ball(a).radius + balls.ball(b).radius).sign() == 0;
}

// Whether the third ball of a vertex covers a whole gap of the circle of the other two: from the vertex to another one
// of the same three balls.
bool has_mirror_image(const Boundary &boundary, uint32_t vertex, uint32_t a, uint32_t b, uint32_t third) {
  for (const uint32_t e : boundary.half_edges(a)) {
    if (boundary.half_edge(e).circle != b) continue;
    const uint32_t ends[2] = {boundary.half_edge(e).vertex, boundary.end_vertex(e)};
    for (const uint32_t end : ends) {
      if (end != vertex && boundary.vertex(end).has(third)) return true;
    }
  }
  return false;
}

}  // namespace

uint32_t third_of_touching(const BallSet &balls, const Boundary &boundary, uint32_t vertex) {
  if (boundary.root_discriminant(vertex) != 0.0) return 3;
  const VertexRecord &record = boundary.vertex(vertex);
  uint32_t third = 0;
  while (third < 3 && !touch_from_outside(balls, record.ball[(third + 1) % 3], record.ball[(third + 2) % 3])) ++third;
  return third;
}

Vec3 way_off_touching_point(const BallSet &balls, const Boundary &boundary, uint32_t vertex) {
  constexpr Vec3 none{0.0, 0.0, 0.0};
  const uint32_t third = third_of_touching(balls, boundary, vertex);
  if (third == 3) return none;
  const VertexRecord &record = boundary.vertex(vertex);
  const Vec3 normal =
      cross(balls.difference(record.ball[0], record.ball[1]), balls.difference(record.ball[0], record.ball[2]));
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0.0)) return none;
  if (has_mirror_image(boundary, vertex, record.ball[(third + 1) % 3], record.ball[(third + 2) % 3],
                       record.ball[third])) {
    return none;
  }
  return (record.positive() ? 1.0 : -1.0) / length * normal;
}

Position position_of_probe(const BallSet &balls, const Boundary &boundary, uint32_t vertex) {
  const Position position = position_of_vertex(balls, boundary, vertex);
  if (boundary.root_discriminant(vertex) != 0.0) return position;
  const double off = radius_of_touching * static_cast<double>(balls.probe_steps);
  return {position.ball, combine(1.0, position.offset, off, way_off_touching_point(balls, boundary, vertex))};
}

}  // namespace hsp
