#include "paths/free_segments.hpp"

#include "exact/wide_integer.hpp"
#include "model/grid_order.hpp"

namespace hsp {
namespace {

using exact::Vector;
using Integer = exact::WideInteger<exact::FastLimb, 64>;

Vector centre_of(const BallSet &balls, uint32_t ball) {
  return balls.ball(ball).centre;
}

exact::WideInteger<exact::FastLimb, 128> exact_dot(const Vector &a, const Vector &b) {
  const auto times = [](int64_t p, int64_t q) { return exact::product<128>(Integer::from(p), Integer::from(q)); };
  return times(a.x, b.x) + times(a.y, b.y) + times(a.z, b.z);
}

bool is_outside_exactly(const exact::LatticeBall &ball, const Vector &a, const Vector &b) {
  const Vector d = b - a, p = ball.centre - a;
  const auto along = exact_dot(d, p), length = exact::squared_length(d), excess = exact::power(p, ball.radius);
  if (along.sign() <= 0) return excess.sign() > 0;
  if ((along - length).sign() >= 0) return exact::power(ball.centre - b, ball.radius).sign() > 0;
  return (exact::product<256>(excess, length) - exact::product<256>(along, along)).sign() > 0;
}

// The part of a segment in the box around all cubes, by parameters that are 0 at a and 1 at b; empty if last < first.
struct Stretch {
  double first, last;
};
Stretch clip(const CubeCover &cover, double side, const Vector &a, const Vec3 &d) {
  Stretch part{0.0, 1.0};
  const double from[3] = {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
  const double along[3] = {d.x, d.y, d.z};
  const CubeCoordinates &low = cover.low(), &high = cover.high();
  const double least[3] = {static_cast<double>(low.x), static_cast<double>(low.y), static_cast<double>(low.z)};
  const double most[3] = {static_cast<double>(high.x), static_cast<double>(high.y), static_cast<double>(high.z)};
  for (uint32_t axis = 0; axis < 3; ++axis) {
    const double before = side * (least[axis] - 1.0) - 4.0 - from[axis];
    const double behind = side * (most[axis] + 2.0) + 4.0 - from[axis];
    if (along[axis] == 0.0) {
      if (before > 0.0 || behind < 0.0) return {1.0, 0.0};
      continue;
    }
    const double enter = (along[axis] > 0.0 ? before : behind) / along[axis];
    const double leave = (along[axis] > 0.0 ? behind : before) / along[axis];
    part.first = enter > part.first ? enter : part.first;
    part.last = leave < part.last ? leave : part.last;
  }
  return part;
}

// The cubes that a piece of a segment may meet.
struct CubeBox {
  int64_t low[3], high[3];
  bool holds(int64_t x, int64_t y, int64_t z) const {
    return x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1] && z >= low[2] && z <= high[2];
  }
};
CubeBox box_of(const CubeAxis &axis, const Vec3 &a, const Vec3 &b) {
  constexpr double margin = 2.0;  // for the rounding of a and b
  CubeBox box;
  const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
  for (uint32_t k = 0; k < 3; ++k) {
    const double low = from[k] < to[k] ? from[k] : to[k], high = from[k] < to[k] ? to[k] : from[k];
    box.low[k] = axis.cube_at(nearest(low - margin));
    box.high[k] = axis.cube_at(nearest(high + margin));
  }
  return box;
}

}  // namespace

bool is_outside_ball(const BallSet &balls, uint32_t ball, const Vector &a, const Vector &b) {
  const Vec3 d = to_double(b - a), p = to_double(centre_of(balls, ball) - a);
  const double length = dot(d, d), squared = dot(p, p), along = dot(d, p);
  const double r = balls.r[ball], w = r * r;
  double excess = 0.0, error = 0.0;
  if (along <= 0.0) {
    excess = squared - w;
    error = 16 * unit_roundoff * (squared + w);
  } else if (along >= length) {
    const Vec3 q = p - d;
    excess = dot(q, q) - w;
    error = 16 * unit_roundoff * (squared + length + w);
  } else {
    const Vec3 n = cross(p, d);
    excess = dot(n, n) - w * length;
    error = 64 * unit_roundoff * (squared + w) * length;
  }
  if (excess > error) return true;
  if (excess < -error) return false;
  return is_outside_exactly(balls.ball(ball), a, b);
}

bool is_free_segment(const BallSet &balls, const FreeSpace &space, const Vector &a, const Vector &b) {
  const CubeCover &cover = space.cover;
  if (cover.cubes() == 0) return true;
  const double side = static_cast<double>(space.side);
  const Vec3 from = to_double(a), d = to_double(b - a);
  const Stretch part = clip(cover, side, a, d);
  if (part.last < part.first) return true;
  const double length = std::sqrt(dot(d, d)) * (part.last - part.first);
  // A segment with many more cubes than there are balls: every ball is looked at.
  if (!(length < side * (static_cast<double>(balls.n) + 8.0))) {
    for (uint32_t ball = 0; ball < balls.n; ++ball) {
      if (!is_outside_ball(balls, ball, a, b)) return false;
    }
    return true;
  }
  const CubeAxis axis(space.side);
  const uint32_t pieces = 1 + static_cast<uint32_t>(length / side);
  CubeBox last{{1, 1, 1}, {0, 0, 0}};
  Vec3 start = from + part.first * d;
  for (uint32_t piece = 1; piece <= pieces; ++piece) {
    const double at = part.first + (part.last - part.first) * (static_cast<double>(piece) / pieces);
    const Vec3 end = from + at * d;
    const CubeBox box = box_of(axis, start, end);
    for (int64_t z = box.low[2]; z <= box.high[2]; ++z) {
      for (int64_t y = box.low[1]; y <= box.high[1]; ++y) {
        for (int64_t x = box.low[0]; x <= box.high[0]; ++x) {
          if (last.holds(x, y, z)) continue;
          const uint32_t cube = cover.find({x, y, z});
          if (cube == no_id) continue;
          for (const uint32_t ball : cover.balls(cube)) {
            if (!is_outside_ball(balls, ball, a, b)) return false;
          }
        }
      }
    }
    last = box;
    start = end;
  }
  return true;
}

double clearance_of_ball(const BallSet &balls, uint32_t ball, const Vector &a, const Vector &b) {
  const Vec3 d = to_double(b - a), p = to_double(centre_of(balls, ball) - a);
  const double length = dot(d, d), along = dot(d, p);
  const double part = along <= 0.0 ? 0.0 : along >= length ? 1.0 : along / length;
  const Vec3 nearest_way = p - part * d;
  return std::sqrt(dot(nearest_way, nearest_way)) - balls.r[ball];
}

double segment_clearance(const BallSet &balls, const Vector &a, const Vector &b) {
  double least = std::numeric_limits<double>::infinity();
  for (uint32_t ball = 0; ball < balls.n; ++ball) {
    const double distance = clearance_of_ball(balls, ball, a, b);
    least = distance < least ? distance : least;
  }
  return least;
}

}  // namespace hsp
