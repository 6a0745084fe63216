// The planes of four pairs of balls, exactly: plane_of() of exact/plane.hpp in lanes. Everything has internal linkage.
#pragma once

#include "lanes/twofold.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {
namespace {

// Four integer vectors below 2^31 in size.
struct LaneVectors {
  LongIntegers x, y, z;

  friend LongIntegers dot(const LaneVectors &a, const LaneVectors &b) {
    return hsp::product(a.x, b.x) + hsp::product(a.y, b.y) + hsp::product(a.z, b.z);
  }
};

// Four balls.
struct LaneBalls {
  FourDoubles x, y, z, r;

  LaneBalls() = default;
  LaneBalls(const BallArrays &balls, const uint32_t *ids)
      : x(Four::gather(balls.x, ids)),
        y(Four::gather(balls.y, ids)),
        z(Four::gather(balls.z, ids)),
        r(Four::gather(balls.r, ids)) {}
};

// The planes that four balls have by one other ball each.
struct LanePlanes {
  FourDoubles x, y, z;  // the vector to the other centre
  LaneVectors v;        // the same
  LongIntegers U;       // |v|^2
  LongIntegers h;

  LanePlanes(const LaneBalls &own, const LaneBalls &other)
      : x(other.x - own.x),
        y(other.y - own.y),
        z(other.z - own.z),
        v{LongIntegers::from(x), LongIntegers::from(y), LongIntegers::from(z)},
        U(dot(v, v)),
        h(U - hsp::product(LongIntegers::from(other.r - own.r), LongIntegers::from(other.r + own.r))) {}
};

// The components of u x v.
struct LaneNormals {
  Twofold x, y, z;

  LaneNormals() = default;
  LaneNormals(const LaneVectors &u, const LaneVectors &v)
      : x(from(hsp::product(u.y, v.z) - hsp::product(u.z, v.y))),
        y(from(hsp::product(u.z, v.x) - hsp::product(u.x, v.z))),
        z(from(hsp::product(u.x, v.y) - hsp::product(u.y, v.x))) {}
};

}  // namespace
}  // namespace hsp
