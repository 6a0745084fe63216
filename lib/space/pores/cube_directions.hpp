// Whether sets of balls can have a critical point in a cube, in doubles with error bounds.
#pragma once

#include <cmath>

#include "core/extremes.hpp"
#include "exact/filter.hpp"
#include "exact/lattice.hpp"
#include "pores/ascent.hpp"
#include "pores/cube_halves.hpp"

namespace hsp {

// Whether one direction d leads away from all of some balls everywhere in a cube. This is the thorough test: d is the
// point nearest to 0 of the convex hull of the directions a, of up to four of them (Gilbert, Johnson, Keerthi 1988).
// a(k), inverse(k): the unit vector from the centre of ball k to the middle of the cube, and the inverse of its
// distance. side: half an edge. When all centres are nearly in one plane with the cube, as those of a ring are, d is
// the short way off that plane. So the bound for rounding is a fraction of |d|: the vector y from the centre is exact;
// each component of a is its multiple but for u; a.d is summed up to 3 u |d|, and `across` times the inverse up to 4 u
// of less than |d|. 2^-49 |d| covers these.
template <class Direction, class Inverse>
bool lead_up_at_all(uint32_t count, double side, const Direction &a, const Inverse &inverse) {
  Vec3 simplex[4] = {a(0)}, d = simplex[0];
  uint32_t corners = 1;
  for (int turn = 0; turn < 16; ++turn) {
    const double squared = dot(d, d), across = side * (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z));
    double least = 2.0, worst = 2.0;
    uint32_t which = 0;
    for (uint32_t k = 0; k < count; ++k) {
      const double along = dot(a(k), d);
      worst = smaller_of(worst, along - across * inverse(k));
      if (along < least) {
        least = along;
        which = k;
      }
    }
    const double tiny = 0x1p-49 * std::sqrt(squared);
    if (worst > tiny) return true;
    if (!(squared > 1e-28) || corners == 4 || least > (1.0 - 1e-6) * squared - tiny) return false;
    simplex[corners++] = a(which);
    d = nearest_to_zero(simplex, corners, d);
    // Of two directions that are nearly opposite d is what little their parts leave, wrong by u of these: at right
    // angles to their difference it has as much of both.
    if (corners == 2) {
      const Vec3 apart = simplex[1] - simplex[0];
      d = d - (dot(d, apart) / dot(apart, apart)) * apart;
    }
  }
  return false;
}

// Some balls as seen from the middle of a cube. A critical point is in the convex hull of the centres of its nearest
// balls: if a plane separates these centres from the cube, it has no critical point of theirs. So only signs of linear
// forms at the corners of the cube are asked. The linear part of |x - c| is a lower bound of it.
class CubeDirections {
 public:
  ViewedBalls seen;
  static constexpr uint32_t room = ViewedBalls::room;
  static_assert(room <= 64 && room % 4 == 0);

  void set(Target target, const NearArrays &near, const Vec3 &middle, double half) {
    const double position[3] = {middle.x, middle.y, middle.z};
    seen.side = half;
    see(target, near, position, seen);
    for (uint32_t k = 0; k < near.count; ++k) slot_[k] = static_cast<uint8_t>(k);
  }
  // Finds which of `count` balls are farther than another one in all of the cube. Returns a bit for each ball that is
  // farther than any other.
  uint64_t compare(Target target, uint32_t count) { return find_farther(target, seen, count); }
  // From now on number `to` means the ball that `from` has meant; to <= from.
  void move(uint32_t from, uint32_t to) { slot_[to] = slot_[from]; }
  // Whether two balls may be as near somewhere in the cube.
  bool may_tie(uint32_t k, uint32_t m) const {
    return ((seen.farther[slot_[k]] >> slot_[m] | seen.farther[slot_[m]] >> slot_[k]) & 1) == 0;
  }

  Vec3 y(uint32_t ball) const {
    const uint32_t k = slot_[ball];
    return {seen.x[k], seen.y[k], seen.z[k]};
  }
  Vec3 a(uint32_t ball) const {
    const uint32_t k = slot_[ball];
    return {seen.ax[k], seen.ay[k], seen.az[k]};
  }
  double inverse(uint32_t ball) const { return seen.inverse[slot_[ball]]; }

  // Whether one direction leads away from the first `count` balls everywhere in the cube. The quick test: a few steps
  // towards the point of the convex hull of the directions a that is nearest to 0. False also if it does not know.
  bool lead_up(uint32_t count) const {
    Vec3 d{0.0, 0.0, 0.0};
    double least = 0.0;  // |d| is larger than that if there is such a direction
    for (uint32_t k = 0; k < count; ++k) {
      d = d + a(k);
      least += inverse(k);
    }
    d = (1.0 / count) * d;
    least *= seen.side / count;
    for (int turn = 0; turn < 6; ++turn) {
      const double squared = dot(d, d);
      if (!(squared > 1e-12) || squared <= least * least) return false;
      const double across = seen.side * size(d);
      double worst = 2.0;
      uint32_t which = 0;
      for (uint32_t k = 0; k < count; ++k) {
        const double lead = dot(a(k), d) - across * inverse(k);
        if (lead < worst) {
          worst = lead;
          which = k;
        }
      }
      if (worst > slack_of_seen) return true;
      const Vec3 v = a(which) - d;
      const double along = -dot(d, v) / dot(v, v);
      if (!(along > 0.0)) return false;
      const double part = along < 1.0 ? along : 1.0;
      d = d + part * v;
      least += part * (seen.side * inverse(which) - least);
    }
    return false;
  }
  // The thorough test, only for a cube that is small beside the distance of its balls: as a rule balls that tie in it
  // tie in its parts, too.
  bool lead_up_at_all(uint32_t count) const {
    if (seen.side * inverse(0) > 0x1p-5) return false;
    const auto direction_of = [&](uint32_t k) { return a(k); };
    const auto inverse_of = [&](uint32_t k) { return inverse(k); };
    return hsp::lead_up_at_all(count, seen.side, direction_of, inverse_of);
  }
  // The plane through the centres of three balls, with normal n. In the cube n.(x - c) is between offset - span and
  // offset + span. tiny: a bound of the rounding of each component of n.
  struct Face {
    Vec3 n;
    double offset, tiny;
    int where;  // the side of the plane on which the whole cube certainly is, +1 or -1; else 0
  };
  Face face(uint32_t i, uint32_t j, uint32_t k) const {
    const Vec3 u = y(i) - y(j), v = y(i) - y(k), n = cross(u, v);
    const double tiny = 1e-13 * size(u) * size(v), offset = dot(n, y(i)),
                 span = seen.side * size(n) + 4.0 * tiny * seen.extent;
    return {n, offset, tiny, exact::certain_sign(offset, span)};
  }
  // Whether the cube certainly does not meet the triangle of three centres.
  bool is_outside(const Face &face, uint32_t i, uint32_t j, uint32_t k) const {
    if (face.where != 0) return true;
    const auto beyond = [&](uint32_t from, uint32_t to) {
      const Vec3 edge = y(from) - y(to), inward = cross(face.n, edge);
      return dot(inward, y(from)) + seen.side * size(inward) < -face.tiny * size(edge) * (size(y(from)) + seen.side);
    };
    return beyond(i, j) || beyond(j, k) || beyond(k, i);
  }
  // Whether the cube and the fourth corner of a tetrahedron are certainly on different sides of a face.
  bool separates(const Face &face, uint32_t opposite) const {
    if (face.where == 0) return false;
    const double height = face.offset - dot(face.n, y(opposite)), off = 4.0 * face.tiny * seen.extent;
    return face.where > 0 ? height < -off : height > off;
  }
  bool is_nearly_flat(const Face &face, uint32_t fourth) const {
    return std::fabs(face.offset - dot(face.n, y(fourth))) <= 4.0 * face.tiny * size(y(fourth));
  }
  static double size(const Vec3 &v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

 private:
  uint8_t slot_[room];  // [ball] its place in the arrays of `seen`
};

}  // namespace hsp
