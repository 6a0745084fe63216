// A box whose copies fill space, on the lattice of the balls. Its three vectors are arbitrary. They are turned, with
// all that lies in the box, so that a is along x and b in the plane of x and y (box_frame.hpp), and then rounded.
//
// A vector that points to the other side of its axis is reversed, which leaves the set of copies as it is: so a
// left-handed set of vectors becomes right-handed, and nothing is mirrored. The caller's shifts count this vector
// backwards.
//
// Every point has one place in the brick 0 .. a.x, 0 .. b.y, 0 .. c.z, whose copies by the vectors fill space, too.
// Here b and c are reduced by whole multiples of the vectors before them, to |b.x|, |c.x| <= a.x/2 and |c.y| <= b.y/2.
// Shifts of images are multiples of the reduced vectors; callers get multiples of the given ones.
#pragma once

#include "core/status.hpp"
#include "core/vec3.hpp"
#include "exact/lattice.hpp"
#include "model/meeting.hpp"
#include "periodic/box_frame.hpp"

namespace hsp {

// A shift: multiples of the three vectors of a box.
struct BoxShift {
  int32_t k[3] = {0, 0, 0};

  constexpr bool operator==(const BoxShift &other) const = default;
  constexpr bool is_zero() const { return (k[0] | k[1] | k[2]) == 0; }
};

constexpr BoxShift operator+(const BoxShift &p, const BoxShift &q) {
  return {{p.k[0] + q.k[0], p.k[1] + q.k[1], p.k[2] + q.k[2]}};
}
constexpr BoxShift operator-(const BoxShift &p, const BoxShift &q) {
  return {{p.k[0] - q.k[0], p.k[1] - q.k[1], p.k[2] - q.k[2]}};
}
// Lexicographic order.
constexpr bool comes_before(const BoxShift &p, const BoxShift &q) {
  for (int axis = 0; axis < 2; ++axis) {
    if (p.k[axis] != q.k[axis]) return p.k[axis] < q.k[axis];
  }
  return p.k[2] < q.k[2];
}

// The order in which images are visited.
constexpr bool visited_before(const BoxShift &p, const BoxShift &q) {
  for (int axis = 2; axis > 0; --axis) {
    if (p.k[axis] != q.k[axis]) return p.k[axis] < q.k[axis];
  }
  return p.k[0] < q.k[0];
}

class PeriodicBox {
 public:
  static constexpr double longest = 0x1p44;          // limit of components of vectors, in steps
  static constexpr int32_t largest_shift = 127;      // limit of shifts of images that are near balls in the box
  static constexpr int64_t largest_skew = 64;        // limit of multiples that reduction may subtract
  static constexpr int64_t farthest_copy = 1 << 17;  // limit of a shift from the box, along each vector

  // Turns the vectors, given in the caller's unit, and rounds them to the lattice. Status::range if one of the three
  // lengths along the axes is 0 then, or if a number is too large.
  Status set(const exact::Lattice &lattice, const double vector[9]);
  // Whether the shifts of all images that may meet balls in the brick are within largest_shift, for balls up to this
  // radius. Let t be twice the radius over the shortest side. Multiples of c are at most 1 + t; those of b half as many
  // more; and for each of these those of a half a multiple more: at most 9/4 (1 + t).
  bool suits(int64_t largest_radius) const;

  // Moves a point into the brick by whole vectors. shift: from its place in the brick to where it was. Status::range if
  // it is too far away.
  Status wrap(exact::Vector &point, BoxShift &shift) const {
    const auto &[a, b, c] = reduced_;
    shift = {};
    const auto is_inside = [](int64_t at, int64_t side) { return at >= 0 && at < side; };
    if (is_inside(point.x, a.x) && is_inside(point.y, b.y) && is_inside(point.z, c.z)) return Status::ok;
    return wrap_outside(point, shift);
  }
  // The vector of a shift, which must not be far larger than those of images.
  exact::Vector translation(const BoxShift &shift) const;
  // Moves a difference by whole vectors to within half of the three lengths along the axes. Returns the shift from
  // there to where it was.
  BoxShift centre(Vec3 &difference) const;
  // The same shift in multiples of the given vectors.
  BoxShift in_given_vectors(const BoxShift &shift) const;

  // For a point of the brick: calls sink(shift) for every image of it, without itself, that is within `reach` of the
  // brick, in the order of visited_before(); perhaps also for some that are hardly farther.
  template <class Sink>
  void visit_images(const exact::Vector &point, int64_t reach, Sink sink) const {
    const auto &[a, b, c] = reduced_;
    // An image is as deep in a copy of the brick as the point is in the brick.
    if (is_deep(point.x, a.x, reach) && is_deep(point.y, b.y, reach) && is_deep(point.z, c.z, reach)) return;
    const double within = static_cast<double>(reach) * static_cast<double>(reach) * certainly_above;
    BoxShift shift;
    const Multiples layers(point.z, c.z, reach);
    for (int32_t k = layers.first; k <= layers.last; ++k) {
      const int64_t z = point.z + k * c.z;
      const Multiples rows(point.y + k * c.y, b.y, reach);
      for (int32_t j = rows.first; j <= rows.last; ++j) {
        const int64_t y = point.y + k * c.y + j * b.y;
        const double square = square_of_gap(z, c.z) + square_of_gap(y, b.y);
        if (square > within) continue;
        const int64_t start = point.x + k * c.x + j * b.x;
        const Multiples row(start, a.x, reach);
        for (int32_t i = row.first; i <= row.last; ++i) {
          shift = {{i, j, k}};
          if (square + square_of_gap(start + i * a.x, a.x) <= within && !shift.is_zero()) sink(shift);
        }
      }
    }
  }

  // The shortest of the three lengths along the axes.
  int64_t shortest_side() const {
    const auto &[a, b, c] = reduced_;
    const int64_t shorter = a.x < b.y ? a.x : b.y;
    return shorter < c.z ? shorter : c.z;
  }
  // The volume of the box in cubic steps, rounded thrice.
  double volume() const { return to_double(reduced_[0]).x * to_double(reduced_[1]).y * to_double(reduced_[2]).z; }
  // The given vectors on the lattice, turned: one of them may point to the other side of its axis.
  const exact::Vector &given(uint32_t k) const { return given_[k]; }
  // The frame of all points here, relative to the caller's axes.
  const BoxFrame &frame() const { return frame_; }

 private:
  Status wrap_outside(exact::Vector &point, BoxShift &shift) const;

  // The multiples of a side that bring a coordinate into -reach .. side + reach. They are few, so that steps cost less
  // than divisions.
  struct Multiples {
    Multiples(int64_t at, int64_t side, int64_t reach) {
      while (at >= side - reach) {
        at -= side;
        --first;
      }
      while (at < -reach) {
        at += side;
        ++first;
      }
      last = first;
      while (at + side <= side + reach) {
        at += side;
        ++last;
      }
    }
    int32_t first = 0, last = 0;
  };
  // Whether a coordinate is farther than `reach` from both ends of its side.
  static constexpr bool is_deep(int64_t at, int64_t side, int64_t reach) { return at > reach && side - at > reach; }

  static constexpr int64_t floored_quotient(int64_t a, int64_t b) {
    if (a >= 0 && a < b) return 0;  // most often
    const int64_t quotient = a / b;
    return a % b < 0 ? quotient - 1 : quotient;
  }
  // The squared distance of a coordinate from 0 .. side.
  static double square_of_gap(int64_t at, int64_t side) {
    const double gap = static_cast<double>(at < 0 ? -at : at > side ? at - side : 0);
    return gap * gap;
  }

  BoxFrame frame_;
  exact::Vector given_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  exact::Vector reduced_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  int32_t skew_[3] = {0, 0, 0};  // how often a was subtracted from b, b from c, a from c
  int32_t side_[3] = {1, 1, 1};  // -1 for a vector that was reversed before the reduction
};

}  // namespace hsp
