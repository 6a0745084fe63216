// The kind of a point x all of whose nearest balls are known. Let a_i be the directions from their centres to x, and K
// the cone of all d with a_i.d >= 0 for all i. Only directions in K lead up:
//   K = {0}        x is a maximum;
//   K is a line    x is a gate, which has two sides however many balls tie;
//   else           x is neither: it is passed by a way up.
// So ties need no perturbation. Everything is decided by the side of planes and lines through centres on which x is;
// the lengths of x - c_i do not matter.
#pragma once

#include "tangents/tangent_point.hpp"

namespace hsp {

enum class PointKind : uint32_t { passing, gate, maximum };

// Finds four balls that are far apart. False if all centres are in one plane; then the last ones of `set` repeat the
// first.
bool find_far_apart(const BallSet &balls, Span<const uint32_t> near, uint32_t *set);

// Unit vectors from the centres of tied balls to their point, in doubles. The exact stage is asked only what is not
// certain by them. If many balls are in one plane with the point, as those of a ring are, the exact stage is asked once
// about each of them: then the answer is known for every set of three. i, j, k, l: ranks in `tied`.
class TiedDirections {
 public:
  // room: for as many vectors as balls tie; with less room nothing is certain.
  TiedDirections(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room);
  // Whether direction i is certainly inside the cone of all others: then ball i is on no curve that leads up.
  bool is_inner(uint32_t i) const;
  // Whether the line through the ends of directions i and j certainly goes through the inside of the hull of all: then
  // no curve of these two balls and a third one leads up.
  bool is_inner(uint32_t i, uint32_t j) const;
  // Whether upwards on the curve of three balls another one certainly gets nearer at once. side: side_of_plane() if
  // that is known, else 0.
  bool is_closed(uint32_t i, uint32_t j, uint32_t k, int side = 0) const;
  // Whether the point is certainly not in the plane of three centres.
  bool is_off_plane(uint32_t i, uint32_t j, uint32_t k) const;
  // On which side of the plane of three centres the point is, as TangentPoint::side_of_plane().
  int side_of_plane(uint32_t i, uint32_t j, uint32_t k);
  // Whether questions before have shown that three centres are in one plane with the point; that four are in one plane.
  bool is_known_in_plane(uint32_t i, uint32_t j, uint32_t k) const;
  bool are_known_in_plane(uint32_t i, uint32_t j, uint32_t k, uint32_t l) const;
  // Whether two centres are certainly not on one line with the point.
  bool are_apart(uint32_t i, uint32_t j) const;
  // Whether there certainly are centres on both sides of the plane through the point and two of them.
  bool are_on_both_sides(uint32_t i, uint32_t j) const;
  // Whether the point is in one plane with some centres and certainly inside a triangle of them. Sets `all`, if so:
  // whether all centres are in that plane.
  bool surround_in_plane(bool &all);
  // Whether 0 is certainly inside the hull of the directions: then the point is a maximum.
  bool surround() const;
  // Whether 0 is in the tetrahedron of four directions: +1 certainly inside, -1 certainly outside, 0 not certain.
  int surround(uint32_t i, uint32_t j, uint32_t k, uint32_t l) const;

 private:
  // A plane nearly through the point, and the balls that are nearly in it.
  struct Plane {
    Vec3 normal, turn;  // turn: the normal of a wide triangle of these balls
    int side;           // if is_one: on which side of their plane the point is, as seen by three that turn like `turn`
    bool is_one;        // whether the centres of these balls are exactly in one plane
  };
  static constexpr uint32_t most_planes = 4;
  uint32_t known_planes() const { return planes_found_ < most_planes ? planes_found_ : most_planes; }
  bool is_near(const Plane &plane, uint32_t i) const;
  bool are_near(const Plane &plane, uint32_t i, uint32_t j, uint32_t k) const {
    return is_near(plane, i) && is_near(plane, j) && is_near(plane, k);
  }
  const Plane *find_plane(uint32_t i, uint32_t j, uint32_t k);
  bool take(const TangentPoint &point, Span<Vec3> room);
  bool is_around(const Vec3 &along, const Vec3 &from, uint32_t i, uint32_t j) const;

  const BallSet &balls_;
  const TangentPoint &point_;
  Span<const uint32_t> tied_;
  Span<const Vec3> a_;
  uint32_t count_ = 0;  // 0: nothing is certain
  Plane planes_[most_planes];
  uint32_t planes_found_ = 0;  // the last most_planes of them are kept
};

// A lower bound of how far 0 is inside the convex hull of unit vectors; not positive if 0 is outside, or nearly.
// outward: if not null, becomes the outward normal, of any length, of the side of the hull that is nearest to 0; or 0.
double depth_of_hull(Span<const Vec3> a, Vec3 *outward = nullptr);
// The same in a plane, for a point nearly in it. a: the unit vectors from centres to the point; y: the same vectors
// with their lengths. off_plane: becomes a bound of how far the point is from the parallel planes through the centres.
double depth_in_plane(Span<const Vec3> a, Span<const Vec3> y, double &off_plane);

// Takes the unit vectors whose products with n are at most `nearly`. Returns a lower bound of how far 0 is inside their
// hull, as seen along n, and finds three of them around 0. Not positive if 0 is not certainly inside.
double depth_in_circle(Span<const Vec3> a, const Vec3 &n, double nearly, uint32_t *three);

// The kind of a point, all of whose nearest balls are `tied`. room: as for TiedDirections.
PointKind kind_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room);
PointKind kind_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied,
                  TiedDirections &directions);

// Whether a point is in the triangle of three centres, for a point of their plane; or in the tetrahedron of four
// centres that are not in one plane. Sides count as inside. on_side: whether it lies on a side.
bool is_in_triangle(const BallSet &balls, const TangentPoint &point, uint32_t i, uint32_t j, uint32_t k, bool &on_side);
bool is_in_tetrahedron(const BallSet &balls, const TangentPoint &point, const uint32_t *ids, bool &on_side);

// The name of a gate: the first three of its tied balls whose triangle has the point in it. The name of a maximum: the
// first four whose tetrahedron has it. No other gate or maximum has that name, since a set of balls has one point with
// W' < 0 (tangent_point.hpp). tied: in ascending order of positions.
void name_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, PointKind kind,
             Span<Vec3> room, uint32_t *name);

}  // namespace hsp
