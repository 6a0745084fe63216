// One cube of the grid and the planes that bound power cells in it, in doubles with their error bounds.
//
// Positions are y = 2 (x - centre of the cube), so that the cube is |y_k| <= side. A plane is v.y = h with a unit
// normal v; its near side is v.y <= h. Errors, with u = 2^-53 and s the side, for balls of this cube or one next to it:
// centres and radii are integers below 2^53, so that differences are exact, and v is off by less than 8 u. h is
// computed from (c_far - c_near).(c_far + c_near) less the factored difference of squared radii; it is off by less than
// 100 u s + 8 u |h|. A plane that meets the cube has |h| < 4 s. So v.y - h is off by less than 512 u s at a point that
// is known exactly. The common point of three planes is y = H / B, where B is off by less than 32 u and each part of H
// by less than 1024 u s. So y is off by less than 4096 u s / |B|.
#pragma once

#include "core/decimal.hpp"
#include "exact/filter.hpp"
#include "lanes/floating_point.hpp"
#include "model/ball_set.hpp"
#include "model/cube_table.hpp"

namespace hsp {

// The plane of a face of a power cell: the radical plane of two balls, or a side of the cube. On the near side of a
// radical plane the power to ball `near` is the smaller one. Side 2 k is the lower one along axis k, side 2 k + 1 the
// upper one.
struct PowerPlane {
  uint32_t near, far;
  friend constexpr bool operator==(const PowerPlane &, const PowerPlane &) = default;

  constexpr bool is_side() const { return near == no_id; }
  constexpr uint32_t side() const { return far; }
};
constexpr PowerPlane side_plane(uint32_t side) {
  return {no_id, side};
}
inline constexpr uint32_t cube_sides = 6;
// The cube beyond a side of a cube.
constexpr CubeCoordinates beside(const CubeCoordinates &cube, uint32_t side) {
  const int64_t step = side % 2 == 0 ? -1 : 1;
  const uint32_t axis = side / 2;
  return {cube.x + (axis == 0 ? step : 0), cube.y + (axis == 1 ? step : 0), cube.z + (axis == 2 ? step : 0)};
}

struct UnitPlane {
  Vec3 v;
  double h;
};

// A position and a bound of its error, which is no_certainty if the planes are nearly parallel.
struct BoundedPoint {
  Vec3 y;
  double error;
};
inline constexpr double no_certainty = 1e300;

class CubeFrame {
 public:
  CubeFrame() = default;
  CubeFrame(const CubeCoordinates &cube, int64_t side)
      : low_{cube.x * side, cube.y * side, cube.z * side}, exact_side_(side), side_(static_cast<double>(side)) {
    centre_ = to_double(low_) + 0.5 * Vec3{side_, side_, side_};
  }

  const exact::Vector &low() const { return low_; }
  int64_t exact_side() const { return exact_side_; }
  double side() const { return side_; }
  // The lattice point nearest to a position in the cube, up to the error of the position; never one outside the cube.
  exact::Vector rounded(const Vec3 &y) const {
    const auto along = [&](int64_t low, double at) {
      return low + (at <= -side_ ? 0 : at >= side_ ? exact_side_ : nearest(0.5 * (side_ + at)));
    };
    return {along(low_.x, y.x), along(low_.y, y.y), along(low_.z, y.z)};
  }
  // How far v.y - h of a plane may be off.
  double plane_error() const { return 512 * unit_roundoff * side_; }

  // From the centre of the cube to that of a ball.
  Vec3 offset_of(const BallSet &balls, uint32_t ball) const {
    return Vec3{balls.x[ball], balls.y[ball], balls.z[ball]} - centre_;
  }
  // The centre of a ball, as a position.
  Vec3 centre_of(const BallSet &balls, uint32_t ball) const { return 2.0 * offset_of(balls, ball); }
  static UnitPlane side_in_doubles(uint32_t side, double distance) {
    const double sign = side % 2 == 0 ? -1.0 : 1.0;
    return {{side / 2 == 0 ? sign : 0.0, side / 2 == 1 ? sign : 0.0, side / 2 == 2 ? sign : 0.0}, distance};
  }
  // The radical plane of two balls with different centres, from their offsets and radii.
  static UnitPlane between(const Vec3 &near, double near_radius, const Vec3 &far, double far_radius) {
    const Vec3 v = far - near;
    const double h = dot(v, near + far) - (far_radius - near_radius) * (far_radius + near_radius);
    const double scale = 1.0 / std::sqrt(dot(v, v));
    return {scale * v, scale * h};
  }
  UnitPlane between(const BallSet &balls, uint32_t near, uint32_t far) const {
    return between(offset_of(balls, near), balls.r[near], offset_of(balls, far), balls.r[far]);
  }
  UnitPlane plane(const BallSet &balls, const PowerPlane &plane) const {
    return plane.is_side() ? side_in_doubles(plane.side(), side_) : between(balls, plane.near, plane.far);
  }

  // The common point of three planes.
  BoundedPoint common_point(const UnitPlane &P, const UnitPlane &Q, const UnitPlane &R) const {
    const Vec3 qr = cross(Q.v, R.v);
    const Vec3 rp = cross(R.v, P.v);
    const Vec3 n = cross(P.v, Q.v);
    const double B = dot(n, R.v);
    const double size = std::fabs(B);
    if (!(size > 1e-8)) return {{0, 0, 0}, no_certainty};
    const double scale = 1.0 / B;
    const Vec3 H = P.h * qr + Q.h * rp + R.h * n;
    return {scale * H, 4096 * unit_roundoff * side_ / size};
  }

  // The side of a plane on which a point lies: +1 the near side, -1 the far side, 0 not certain.
  int side_of(const BoundedPoint &point, const UnitPlane &S) const {
    const double beyond = dot(S.v, point.y) - S.h;
    return -exact::certain_sign(beyond, point.error + plane_error());
  }
  // Whether a point is outside a sphere of squared diameter W, from its squared distance to the centre: +1 outside, -1
  // inside, 0 not certain. The point lies in this cube or on its sides.
  int outside(double squared_distance, double error, double W) const {
    return exact::certain_sign(squared_distance - W, sphere_error(error));
  }
  // A bound of the error of a squared distance, if positions are off by `error`.
  double sphere_error(double error) const { return side_ * (16 * error + 1024 * unit_roundoff * side_); }
  // The same for a segment between two points outside, given with their squared distances: it is off by no more than
  // its ends are. The squared distance of its line is from_squared less the square of the way from there to the nearest
  // point.
  int segment_outside(const BoundedPoint &from, double from_squared, const BoundedPoint &to, double to_squared,
                      const Vec3 &centre, double W) const {
    const double error = from.error > to.error ? from.error : to.error;
    const Vec3 edge = to.y - from.y;
    const double length = dot(edge, edge);
    const double along = dot(centre - from.y, edge);
    if (along <= 0.0) return outside(from_squared, error, W);
    if (along >= length) return outside(to_squared, error, W);
    return exact::certain_sign((from_squared - W) * length - along * along, sphere_error(error) * length);
  }

 private:
  exact::Vector low_{};
  int64_t exact_side_ = 1;
  double side_ = 1.0;
  Vec3 centre_{};
};

}  // namespace hsp
