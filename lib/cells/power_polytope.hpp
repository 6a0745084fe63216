// A convex polytope that planes cut out of a cube, as a graph: vertices of three planes each, joined by edges of two.
// Who cuts says which vertices lie beyond a plane; everything else is combinatorial. Under the symbolic perturbation no
// four planes have a common point, so every polytope stays simple. Coordinates serve the filter stage of predicates
// alone.
#pragma once

#include <bit>

#include "cells/cube_frame.hpp"
#include "cells/vertex_sides.hpp"
#include "core/workspace.hpp"

namespace hsp {

struct PolytopeVertex {
  PlacedPoint at;
  uint32_t plane[3];
  uint32_t neighbour[3];  // [k]: along the edge on the two planes other than plane[k]

  uint32_t place_of(uint32_t wanted) const { return plane[0] == wanted ? 0 : plane[1] == wanted ? 1 : 2; }
  bool has(uint32_t wanted) const { return plane[0] == wanted || plane[1] == wanted || plane[2] == wanted; }
};

class PowerPolytope {
 public:
  // Planes 0 .. 5 are the sides of the cube, the others those of up to so many balls.
  static uint64_t most_planes(uint32_t balls) { return static_cast<uint64_t>(balls) + cube_sides; }
  // A simple polytope of f facets has 2 f - 4 vertices, and while it is cut the old and the new ones are there.
  static uint64_t most_vertices(uint32_t balls) { return 2 * most_planes(balls); }
  void carve(Workspace &workspace, uint32_t balls);

  // The whole cube, for a ball with this centre.
  void start(double side, const Vec3 &centre);
  // What side of plane number `plane` the vertices are on, which is `S` in doubles: exact_side(vertex), +1 near or -1
  // beyond, is asked where these do not tell. Returns how many are beyond.
  template <class ExactSide>
  uint32_t find_beyond(const UnitPlane &S, const CubeFrame &frame, ExactSide exact_side);
  // Cuts off the vertices that are beyond plane number `plane`, that of the last find_beyond(), of which there are
  // some; `planes` are all of them. What is beyond a plane is connected, and so is the rest.
  void cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame);
  void make_empty() { count_ = 0; }

  uint32_t size() const { return count_; }
  const PolytopeVertex &operator[](uint32_t v) const { return vertices_[v]; }
  // Of the distance of a vertex from the centre of the ball.
  double squared(uint32_t v) const { return squared_[v]; }
  // No point of it is farther from the ball's centre, but for errors of the frame.
  double reach() const;
  // The mean of its vertices, which is in it: off by no more than they are, but for roundings.
  Vec3 middle() const;
  // No vertex is more in doubt.
  double most_doubt() const { return most_doubt_; }

 private:
  // Of the vertices from one on, up to 64.
  VertexSides sides_of(uint32_t first, const UnitPlane &S, double margin) const {
    const PointValues points{x_.data() + first, y_.data() + first, z_.data() + first, value_.data() + first};
    const uint32_t count = count_ - first < 64 ? count_ - first : 64;
    const PlaneNumbers plane{S.v.x, S.v.y, S.v.z, S.h};
#if HSP_AVX2
    if (wide_code_) return find_sides_avx2(points, count, plane, margin);
#endif
    return find_sides<baseline_lanes>(points, count, plane, margin);
  }
  void move(uint32_t from, uint32_t to);

  Span<PolytopeVertex> vertices_;
  Span<double> x_, y_, z_;  // [vertices] their positions, number by number
  Span<double> squared_;    // [vertices]
  Span<double> value_;      // [vertices] v.y - h of the plane that they were last held against
  Span<uint64_t> beyond_;   // [vertices / 64] a bit for each
  Span<uint32_t> holes_;    // [vertices] those that are beyond, ascending; they leave their places to others
  Span<uint32_t> open_;     // [planes] the edge on it and the new plane that still waits for its other end
  uint32_t count_ = 0, hole_count_ = 0;
  [[maybe_unused]] bool wide_code_ = false;
  Vec3 centre_{};
  double most_doubt_ = 0.0;  // of all vertices that there have been
};

template <class ExactSide>
uint32_t PowerPolytope::find_beyond(const UnitPlane &S, const CubeFrame &frame, ExactSide exact_side) {
  const double margin = most_doubt_ + frame.plane_doubt();
  uint32_t found = 0;
  for (uint32_t first = 0; first < count_; first += 64) {
    const VertexSides sides = sides_of(first, S, margin);
    uint64_t beyond = sides.beyond;
    for (uint64_t left = sides.unsure; left != 0; left &= left - 1) {
      const PolytopeVertex &vertex = vertices_[first + static_cast<uint32_t>(std::countr_zero(left))];
      const int side = frame.side_of(vertex.at, S);
      if ((side != 0 ? side : exact_side(vertex)) < 0) beyond |= left & (~left + 1);
    }
    beyond_[first / 64] = beyond;
    for (; beyond != 0; beyond &= beyond - 1) {
      holes_[found++] = first + static_cast<uint32_t>(std::countr_zero(beyond));
    }
  }
  hole_count_ = found;
  return found;
}

}  // namespace hsp
