#include "pockets/plugs.hpp"

#include "core/extremes.hpp"

namespace hsp {
namespace {

// A disc in the plane of a mouth; positions are relative to the mouth's point.
struct Disc {
  Vec3 centre;
  double radius;
};

double squared_length(const Vec3 &v) {
  return dot(v, v);
}

// The square of the distance from the mouth's point to the farther end of the gap between two discs; or, if they meet,
// to the corner at which they do, on the near side of the line of their centres.
double squared_reach(const Disc &one, const Disc &other) {
  const Vec3 between = other.centre - one.centre;
  const double distance = std::sqrt(squared_length(between));
  if (!(distance > 0.0)) return squared_length(one.centre);
  const Vec3 along = (1.0 / distance) * between;
  if (distance >= one.radius + other.radius) {
    return larger_of(squared_length(one.centre + one.radius * along),
                     squared_length(other.centre - other.radius * along));
  }
  // The point at which the common chord crosses the line of centres; and half the length of the chord, which is not
  // known well if the discs hardly meet.
  const double r = one.radius;
  const double foot = 0.5 * (distance + (r - other.radius) * (r + other.radius) / distance);
  const double half = r * r - foot * foot, error = 0x1p-48 * (r * r + distance * distance);
  const double from = dot(one.centre, along) + foot;
  const double height = std::sqrt(squared_length(one.centre - dot(one.centre, along) * along));
  const auto reach = [&](double squared) {
    const double beyond = height - std::sqrt(squared > 0.0 ? squared : 0.0);
    return from * from + beyond * beyond;
  };
  return larger_of(reach(half - error), reach(half + error));
}

}  // namespace

exact::LatticeBall plug_of(const PoresBuilder &pores, const BallsAround &balls, const PoreGate &mouth, int64_t grown) {
  const Span<const uint32_t> tied = pores.tied(mouth.point);
  const Span<const SmallShift> shifts = pores.tied_shifts(mouth.point);
  const Vec3 &position = mouth.point.position;
  const exact::Vector centre{nearest(position.x), nearest(position.y), nearest(position.z)};
  const auto disc = [&](uint32_t k) {
    const exact::LatticeBall ball = balls.ball({tied[k], shifts[k].shift()});
    const Vec3 from{static_cast<double>(ball.centre.x - centre.x), static_cast<double>(ball.centre.y - centre.y),
                    static_cast<double>(ball.centre.z - centre.z)};
    return Disc{from, static_cast<double>(grown_radius(ball.radius, grown))};
  };
  const auto direction = [&](uint32_t k) {
    const Vec3 from = disc(k).centre;
    const double squared = squared_length(from);
    return squared > 0.0 ? (1.0 / std::sqrt(squared)) * from : Vec3{};
  };
  // All centres are in one plane with the point, on all sides of it.
  Vec3 normal{};
  for (uint32_t k = 1; k < tied.size(); ++k) {
    const Vec3 n = cross(direction(0), direction(k));
    if (squared_length(n) > squared_length(normal)) normal = n;
  }
  double squared = 0.0, largest = 0.0;
  for (uint32_t k = 0; k < tied.size(); ++k) {
    // The next ball, counter-clockwise, is less than half a turn away.
    const Vec3 own = direction(k);
    uint32_t next = no_id;
    double least_turn = -2.0;
    for (uint32_t other = 0; other < tied.size(); ++other) {
      const Vec3 to = direction(other);
      if (other == k || !(dot(cross(own, to), normal) > 0.0) || !(dot(own, to) > least_turn)) continue;
      next = other;
      least_turn = dot(own, to);
    }
    const Disc here = disc(k);
    largest = larger_of(largest, here.radius);
    if (next != no_id) squared = larger_of(squared, squared_reach(here, disc(next)));
  }
  const double reach = std::sqrt(squared);
  return {centre, static_cast<int64_t>(reach + 0x1p-20 * (reach + largest)) + 3, no_id};
}

}  // namespace hsp
