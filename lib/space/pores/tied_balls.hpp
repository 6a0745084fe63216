// The kind of a point all of whose nearest balls are known. With a_i the directions from their centres to the point,
// and K all d with a_i.d >= 0, only directions of K lead up, and
//   K = {0}     a maximum;
//   a line      a gate, which has two sides however many balls tie;
//   else        neither: a way up begins there.
// So ties need no perturbation. All from signs of planes and lines through centres, in which the lengths of x - c_i do
// not matter.
#pragma once

#include "tangents/tangent_point.hpp"

namespace hsp {

enum class PointKind : uint32_t { passing, gate, maximum };

// Four balls that are far apart; false if all centres are in one plane.
bool find_far_apart(const BallSet &balls, Span<const uint32_t> near, uint32_t *set);

// Unit vectors from the centres of tied balls to their point, in doubles: what is certain by them need not be asked of
// the exact stage. Where many are in one plane with the point, as those of a ring are, that is asked of each once: then
// it is known of all sets of three.
class TiedDirections {
 public:
  // room: for as many vectors; with less nothing is certain.
  TiedDirections(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room);
  // Whether one is certainly inside the cone that all others make up: it is on no curve that leads up.
  bool is_inner(uint32_t i) const;
  // Whether the line of two of them certainly goes through the inside of their hull: no curve of these two and a third
  // one leads up then.
  bool is_inner(uint32_t i, uint32_t j) const;
  // Whether on the curve of three of them, upwards, another one certainly gets nearer at once. side: side_of_plane() if
  // that is known, else 0.
  bool is_closed(uint32_t i, uint32_t j, uint32_t k, int side = 0) const;
  // Whether the point is certainly not in the plane of three of the centres.
  bool is_off_plane(uint32_t i, uint32_t j, uint32_t k) const;
  // On which side of the plane of three of the centres the point is, as TangentPoint has it.
  int side_of_plane(uint32_t i, uint32_t j, uint32_t k);
  // Whether three, or four, are known to be in one plane with the point by what was asked before.
  bool is_known_in_plane(uint32_t i, uint32_t j, uint32_t k) const;
  bool are_known_in_plane(uint32_t i, uint32_t j, uint32_t k, uint32_t l) const;
  // Whether two of them certainly make a plane with the point.
  bool are_apart(uint32_t i, uint32_t j) const;
  // Whether some centres are certainly on both sides of the plane through the point and two of them.
  bool are_on_both_sides(uint32_t i, uint32_t j) const;
  // Whether the point is in one plane with some and certainly inside their triangles; all: whether with all of them.
  bool surround_in_plane(bool &all);
  // Whether 0 is certainly inside their hull: the point is a maximum.
  bool surround() const;
  // Whether 0 is in the tetrahedron of four: +1 and -1 if that is certain.
  int surround(uint32_t i, uint32_t j, uint32_t k, uint32_t l) const;

 private:
  // Nearly through the point, with the balls that are nearly in it. If all their centres are in one plane, on which
  // side of that the point is, where three turn as `turn` does.
  struct Plane {
    Vec3 normal, turn;
    int side;
    bool is_one;
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
  uint32_t planes_found_ = 0;  // the last ones of these are kept
};

// A lower bound of how far 0 is inside the hull of unit vectors; not positive if it is outside or nearly. outward: if
// not null, becomes the normal of the side that is nearest to 0, or 0.
double depth_of_hull(Span<const Vec3> a, Vec3 *outward = nullptr);
// The same in a plane, of a point that is nearly in it: of unit vectors from centres to the point. off_plane: how far
// it is from planes through centres at most, where y are the vectors.
double depth_in_plane(Span<const Vec3> a, Span<const Vec3> y, double &off_plane);

// Of unit vectors those that are nearly at right angles to n: a lower bound of how far 0 is inside their hull as seen
// along n, and three of them around it. Not positive if it is not certainly inside.
double depth_in_circle(Span<const Vec3> a, const Vec3 &n, double nearly, uint32_t *three);

// Of a point and all balls that are nearest to it. room: as for TiedDirections.
PointKind kind_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room);
PointKind kind_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied,
                  TiedDirections &directions);

// Whether a point is in the triangle of three centres, in whose plane it lies, or in the tetrahedron of four that are
// not in one plane; sides included. on_side: whether it lies on one.
bool is_in_triangle(const BallSet &balls, const TangentPoint &point, uint32_t i, uint32_t j, uint32_t k, bool &on_side);
bool is_in_tetrahedron(const BallSet &balls, const TangentPoint &point, const uint32_t *ids, bool &on_side);

// The name of a gate or a maximum: of its balls the first three whose triangle has the point in it, or the first four
// whose tetrahedron has. No other gate or maximum has that name, since a set of balls has one point with W' < 0.
// tied: in ascending order.
void name_of_gate(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, uint32_t *name);
void name_of_maximum(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room,
                     uint32_t *name);
inline void name_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, PointKind kind,
                    Span<Vec3> room, uint32_t *name) {
  if (kind == PointKind::gate) {
    name_of_gate(balls, point, tied, name);
  } else {
    name_of_maximum(balls, point, tied, room, name);
  }
}

}  // namespace hsp
