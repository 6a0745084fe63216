// The balls that meet one cube, as plain arrays, and kernels on each of them with all others. For registers of n
// doubles; every n gives the same bits. power_cell.kernel.cpp compiles this file.
#pragma once

#include <limits>

#include "core/vec3.hpp"
#include "lanes/target.hpp"
#include "lanes/wide.hpp"

namespace hsp {

// Of each ball: the vector from the centre of the cube to its centre, its radius, the square of that vector less that
// of the radius; and 1, or 0 if it is discarded. Behind the last ball there is room up to a multiple of eight, with
// entries that count as discarded.
struct MemberArrays {
  const double *x, *y, *z, *radius, *power, *not_discarded;
  uint32_t count;
};
// The same of one ball.
struct MemberBall {
  double x, y, z, radius, power;
};
// The radical planes v.y = h of a ball and all others. distance: the square of the plane's distance from the ball's
// centre, with a sign: negative if the centre is beyond the plane. It is infinite for planes that do not count any
// more, and behind the last one, where there is room up to a multiple of eight.
struct PlaneOrder;
struct PlaneArrays {
  double *x, *y, *z, *h, *distance;
  uint32_t *nearest;  // first, as far as PlaneOrder says
  PlaneOrder *order;
};
inline constexpr double done_with = std::numeric_limits<double>::infinity();
// The order of the planes in PlaneArrays::nearest: by distance, of equal ones the one with the lower number first.
// Those before `next` are done with. find_planes() sorts up to most_ordered planes. Of up to most_sought planes `count`
// is 0, and each next one is sought among all. Of more the caller sorts some at a time.
inline constexpr uint32_t most_ordered = 24, most_sought = 160;
struct PlaneOrder {
  uint32_t next, count;
};

HSP_KERNEL(void, find_planes,
           (const MemberArrays &members, const MemberBall &own, double limit, const PlaneArrays &planes),
           (members, own, limit, planes))
HSP_KERNEL(bool, is_before_all,
           (const MemberArrays &members, const MemberBall &own, const Vec3 &point, double error,
            const double *distance),
           (members, own, point, error, distance))
HSP_KERNEL(uint64_t, find_dominance,
           (const MemberArrays &members, uint32_t a, uint32_t first, double side, double error),
           (members, a, first, side, error))

namespace {

// Sorts planes by counting those before each: so no branch depends on a distance.
template <uint32_t n>
inline void order_planes(const PlaneArrays &planes, uint32_t count) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  constexpr double lane_numbers[4] = {0.0, 1.0, 2.0, 3.0};
  const Real lanes = L::load(lane_numbers);
  const double *const distance = planes.distance;
  PlaneOrder &order = *planes.order;
  order.next = 0;
  order.count = count <= most_ordered ? count : 0;
  for (uint32_t first = 0; first < order.count; first += n) {
    const Real own = L::load(distance + first);
    Mask ranks = L::bits(L::all(0.0));
    for (uint32_t k = 0; k < first; ++k) ranks -= L::all(distance[k]) <= own;
    for (uint32_t k = 0; k < n; ++k) {
      const Real other = L::all(distance[first + k]);
      const Mask later = lanes > L::all(static_cast<double>(k));
      ranks -= (other < own) | L::both(other == own, later);
    }
    for (uint32_t k = first + n; k < count; ++k) ranks -= L::all(distance[k]) < own;
    for (uint32_t k = 0; k < n && first + k < count; ++k) planes.nearest[ranks[k]] = first + k;
  }
}

// Finds the planes between a ball and these, as CubeFrame::between() does. If the square of a distance is larger than
// the limit, or if the other ball is discarded or the same, the distance is set to infinity, and the rest is undefined.
template <uint32_t n>
inline void find_planes_in_lanes(const MemberArrays &members, const MemberBall &own, double limit,
                                 const PlaneArrays &planes) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const Real x = L::all(own.x), y = L::all(own.y), z = L::all(own.z);
  const Real radius = L::all(own.radius), most = L::all(limit);
  const Real zero = L::all(0.0), one = L::all(1.0), never = L::all(done_with);
  for (uint32_t first = 0; first < (members.count + 7) / 8 * 8; first += n) {
    const Real far_x = L::load(members.x + first), far_y = L::load(members.y + first);
    const Real far_z = L::load(members.z + first), other = L::load(members.radius + first);
    const Real vx = far_x - x, vy = far_y - y, vz = far_z - z;
    const Real length = vx * vx + vy * vy + vz * vz;
    const Real powers = (other - radius) * (other + radius);
    const Real own_h = length - powers;
    const Real distance = own_h * L::absolute(own_h) / length;
    // The distance of the ball itself is NaN. Of balls with one centre at most one is not discarded.
    const typename L::Mask near = L::both(distance <= most, L::load(members.not_discarded + first) > zero);
    L::store(planes.distance + first, L::select(near, distance, never));
    const Real scale = one / L::square_root(length);
    const Real h = (vx * (x + far_x) + vy * (y + far_y) + vz * (z + far_z)) - powers;
    L::store(planes.x + first, scale * vx);
    L::store(planes.y + first, scale * vy);
    L::store(planes.z + first, scale * vz);
    L::store(planes.h + first, scale * h);
  }
  order_planes<n>(planes, members.count);
}

// Whether a point, as a position of cube_frame.hpp, has less power to a ball than to all of these whose planes are not
// done with, by more than an error. The value of a plane is the one of PowerCell::drop_dominated().
template <uint32_t n>
inline bool is_before_all_in_lanes(const MemberArrays &members, const MemberBall &own, const Vec3 &point, double error,
                                   const double *distance) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const Real x = L::all(own.x), y = L::all(own.y), z = L::all(own.z);
  const Real power = L::all(own.power), least = L::all(error);
  const Real never = L::all(done_with);
  const Real at_x = L::all(point.x), at_y = L::all(point.y), at_z = L::all(point.z);
  for (uint32_t first = 0; first < members.count; first += n) {
    const Real along = (L::load(members.x + first) - x) * at_x + (L::load(members.y + first) - y) * at_y +
                       (L::load(members.z + first) - z) * at_z;
    const Real more = L::load(members.power + first) - power - along;
    if (L::any(L::both(more <= least, L::load(distance + first) < never))) return false;
  }
  return true;
}

// A bit for each of up to 64 balls from number `first` on: whether one of it and ball a may have less power than the
// other all over the cube of this side, or whether both have one centre.
template <uint32_t n>
inline uint64_t find_dominance_in_lanes(const MemberArrays &members, uint32_t a, uint32_t first, double side,
                                        double error) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const Real x = L::all(members.x[a]), y = L::all(members.y[a]), z = L::all(members.z[a]);
  const Real power = L::all(members.power[a]), sides = L::all(side), errors = L::all(error), zero = L::all(0.0);
  const uint32_t left = members.count - first, count = left < 64 ? left : 64;
  uint64_t found = 0;
  for (uint32_t k = 0; k < count; k += n) {
    const uint32_t b = first + k;
    const Real mean = L::absolute(L::load(members.power + b) - power);
    const Real spread = sides * (L::absolute(L::load(members.x + b) - x) + L::absolute(L::load(members.y + b) - y) +
                                 L::absolute(L::load(members.z + b) - z));
    found |= (L::set_lanes(mean > spread + errors) | L::set_lanes(spread == zero)) << k;
  }
  return found & (~UINT64_C(0) >> (64 - count));
}

}  // namespace
}  // namespace hsp
