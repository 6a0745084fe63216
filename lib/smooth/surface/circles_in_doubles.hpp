// Caps of a unit sphere in doubles, as a source of decisions for free_region.hpp: what is answered is certain, given a
// bound on the errors of the caps.
//
// For circles u.x = a and v.x = b put n = u x v, q = a v - b u and D = n.n - q.q (exact/circle_crossing.hpp). Unlike
// 1 - g^2 - a^2 - b^2 + 2 g a b this keeps its precision where two circles are almost the same, as those of two close
// vertices. Errors in units of e = 2^-53, those of u at most 3.5 A and of a at most 7 A (A the amplification),
// with L^2 = n.n + q.q <= 5:
//   n   2 * 3.5 A + 4 <= 11 A      q   2 * (7 + 3.5) A + 4 <= 25 A
//   D   2 (11 A |n| + 25 A |q|) + 8 L^2 <= 80 A L
// and for the points (q x n +- sqrt(D) n) / n.n, where D > 0, so |q| <= |n| and L <= 1.42 |n|:
//   q x n          (25 + 11 + 2 * 11) A / |n|
//   sqrt(D) n      80 A L / (2 sqrt(D) |n|) + 3 * 11 A / |n|
//   together, as sqrt(D) <= |n|, at most 148 A / sqrt(D); a third cap's u.p - a adds 3.5 A + 7 A, all roundings 20.
#pragma once

#include "sphere/arc_geometry.hpp"
#include "sphere/caps.hpp"
#include "surface/free_region.hpp"

namespace hsp {

// Whether two circles cross, and where if they certainly do. error: A e.
template <class Crossing>
Answer certain_crossing(const CircleCrossing<Vec3, double> &pair, uint32_t j, uint32_t k, double error,
                        Crossing &crossing) {
  const double D = pair.discriminant(1.0);
  const double scale = error * std::sqrt(pair.nn + dot(pair.q, pair.q));
  if (D < -256 * scale) return Answer::no;
  // So far above its error that the first order decides.
  if (!(D > 4096 * scale)) return Answer::unknown;
  const double root = std::sqrt(D);
  crossing = {j, k, root, {pair.point(-root), pair.point(root)}, 256 * error / root};
  return Answer::yes;
}

class CirclesInDoubles {
 public:
  // amplification >= 1.
  CirclesInDoubles(const Caps &caps, double amplification) : caps_(caps), error_(amplification * unit_roundoff) {}

  struct Crossing {
    uint32_t first, second;
    double root;
    Vec3 point[2];  // p-, p+
    double error;   // of axis.point - height for any cap
  };

  uint32_t count() const { return caps_.count; }
  Vec3 axis(uint32_t k) const { return caps_.axis(k); }
  double height(uint32_t k) const { return caps_.b[k]; }

  Answer crossing(uint32_t j, uint32_t k, Crossing &crossing) const {
    const CircleCrossing<Vec3, double> pair(caps_.axis(j), caps_.b[j], caps_.axis(k), caps_.b[k]);
    return certain_crossing(pair, j, k, error_, crossing);
  }
  Answer contains(const Crossing &crossing, int sign, uint32_t r) const {
    const double above = dot(caps_.axis(r), crossing.point[sign > 0 ? 1 : 0]) - caps_.b[r];
    return above > crossing.error ? Answer::yes : above < -crossing.error ? Answer::no : Answer::unknown;
  }
  RegionCorner corner(const Crossing &crossing, int sign) const {
    return {crossing.first, crossing.second, sign, crossing.root, crossing.point[sign > 0 ? 1 : 0], crossing.error,
            false};
  }
  // By the circle's centre a u: error of a g - b at most 7 A + (2 * 3.5 A + 3) + 7 A + 2.
  Answer lies_inside(uint32_t k, uint32_t r) const {
    const double above = caps_.b[k] * dot(caps_.axis(k), caps_.axis(r)) - caps_.b[r];
    const double certain = 32 * error_;
    return above > certain ? Answer::yes : above < -certain ? Answer::no : Answer::unknown;
  }
  bool ends_sooner(uint32_t k, const RegionCorner &exit, const RegionCorner &a, const RegionCorner &b) const {
    return turn(k, exit, a) < turn(k, exit, b);
  }
  // Seen from the circle's centre each end is uncertain by its error over the circle's radius.
  double arc_angle(uint32_t k, const RegionCorner &exit, const RegionCorner &entry) const {
    const double angle = turn(k, exit, entry);
    const double radius_squared = (1.0 - caps_.b[k]) * (1.0 + caps_.b[k]);
    const double error = 2 * (exit.error + entry.error);
    const double margin = angle < pi ? angle : 2 * pi - angle;
    return margin > 0.0 && margin * margin * radius_squared > error * error ? angle : -1.0;
  }
  double exterior_angle(const RegionCorner &corner) const {
    const double g = dot(caps_.axis(corner.first), caps_.axis(corner.second));
    return arc_tangent(corner.root, g - caps_.b[corner.first] * caps_.b[corner.second]);
  }

 private:
  double turn(uint32_t k, const RegionCorner &from, const RegionCorner &to) const {
    const Vec3 centre = caps_.b[k] * caps_.axis(k);
    return turn_about(caps_.axis(k), from.point - centre, to.point - centre);
  }

  const Caps &caps_;
  const double error_;
};

}  // namespace hsp
