#include "surface/flat_patches.hpp"

#include "surface/probe_caps.hpp"

namespace hsp {

bool is_flat(const BallSet &balls, const Boundary &boundary, const Position &position, uint32_t vertex, Vec3 &normal) {
  const VertexRecord &record = boundary.vertex(vertex);
  const Vec3 n =
      cross(balls.difference(record.ball[0], record.ball[1]), balls.difference(record.ball[0], record.ball[2]));
  const double length = std::sqrt(dot(n, n));
  if (!(length > 0.0)) return false;
  normal = (record.positive() ? 1.0 : -1.0) / length * n;
  const double above = dot(normal, balls.difference(position.ball, record.ball[0]) - position.offset);
  return 2 * std::fabs(above) < coincident_distance * static_cast<double>(balls.probe_steps);
}

}  // namespace hsp
