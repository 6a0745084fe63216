#include "surface/crease_lengths.hpp"

#include "exact/circle_crossing.hpp"
#include "measure/areas.hpp"
#include "surface/probe_caps.hpp"
#include "surface/probe_positions.hpp"

namespace hsp {
namespace {

// By how much borders may be off beside errors of positions, in units of the probe's radius.
constexpr double rounding_of_planes = 0x1p-28;

}  // namespace

// The circle of a crease is computed from each of its two probes; its angle was, when they were cut.
bool CreaseLengths::agree(uint32_t arc) const {
  const PatchArc &own = cut_.arc(arc);
  const double height = circle_of(vertex_of(arc), own).height;
  const double radius = std::sqrt(height < 1.0 ? (1.0 - height) * (1.0 + height) : 0.0) * probe_;
  const double off = (own.angle - cut_.arc(own.twin).angle) * radius;
  const double most = tolerance * length_ + uncertainty(arc);
  return off <= most && -off <= most;
}

CreaseLengths::ArcCircle CreaseLengths::circle_of(uint32_t vertex, const PatchArc &arc) const {
  const double error = vertex_error * length_;
  const Vec3 at = offset_of(vertex);
  if (!arc.is_side()) {
    const Vec3 to = offset_of(arc.across) - at;
    const double distance = std::sqrt(dot(to, to));
    if (!(distance > 0.0)) return {{0.0, 0.0, 0.0}, 0.0, 1.0};
    return {(1.0 / distance) * to, distance / (2 * probe_), 14 * error / distance + rounding_of_planes};
  }
  const VertexRecord &record = boundary_.vertex(vertex);
  const Vec3 first = centre_of(record.ball[arc.slot() == 0 ? 1 : 0]) - at;
  const Vec3 second = centre_of(record.ball[arc.slot() == 2 ? 1 : 2]) - at;
  const Vec3 normal = cross(first, second);
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0.0)) return {{0.0, 0.0, 0.0}, 0.0, 1.0};
  const double longer = std::sqrt(dot(first, first)) + std::sqrt(dot(second, second));
  return {(1.0 / length) * normal, 0.0, error * longer / length + rounding_of_planes};
}

// Where two circles cross at an angle whose sine is s, errors d of them move their crossing by d/s along one of them,
// and if they nearly touch by the root of d. So little is known of where a crease ends if two of the probes are close
// to each other, or it grazes the border.
double CreaseLengths::uncertainty_of_ends(uint32_t a) const {
  const PatchArc &arc = cut_.arc(a);
  if (arc.next == a) return 0.0;
  const uint32_t vertex = vertex_of(a);
  const ArcCircle own = circle_of(vertex, arc);
  double sum = 0.0;
  const uint32_t ends[2] = {arc.next, cut_.previous(a)};
  for (const uint32_t beside : ends) {
    const ArcCircle other = circle_of(vertex, cut_.arc(beside));
    const CircleCrossing<Vec3, double> crossing(own.axis, own.height, other.axis, other.height);
    const double D = crossing.discriminant(1.0);
    const double error = own.error + other.error;
    const double square = D > error ? D : error;
    sum += 4 * error / std::sqrt(square);
  }
  return sum * probe_;
}

Vec3 CreaseLengths::centre_of(uint32_t ball) const {
  return offset_from_origin(balls_, boundary_, ball);
}

Vec3 CreaseLengths::offset_of(uint32_t vertex) const {
  const Position position = position_of_probe(balls_, boundary_, vertex);
  return centre_of(position.ball) + position.offset;
}

}  // namespace hsp
