// A convex polytope that planes cut out of a cube, as a graph: vertices of three planes each, joined by edges of two.
// Who cuts says which vertices lie beyond a plane; everything else is combinatorial. Under the symbolic perturbation no
// four planes have a common point, so every polytope stays simple. Coordinates serve the filter stage of predicates
// alone.
#pragma once

#include "cells/cube_frame.hpp"
#include "core/simd.hpp"
#include "core/workspace.hpp"

namespace hsp {

struct PolytopeVertex {
  PlacedPoint at;
  double squared;  // of the distance from the centre of the ball
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
  // No point of it is farther from the ball's centre, but for errors of the frame.
  double reach() const;
  // No vertex is more in doubt.
  double most_doubt() const { return most_doubt_; }

 private:
  bool find_values(const UnitPlane &S, double margin);
  void move(uint32_t from, uint32_t to);

  Span<PolytopeVertex> vertices_;
  Span<double> x_, y_, z_;  // [vertices] their positions, number by number
  Span<double> value_;      // [vertices] v.y - h of the plane that they were last held against
  Span<uint8_t> beyond_;    // [vertices]
  Span<uint32_t> holes_;    // [vertices] those that are beyond, ascending; they leave their places to others
  Span<uint32_t> open_;     // [planes] the edge on it and the new plane that still waits for its other end
  uint32_t count_ = 0, hole_count_ = 0;
  Vec3 centre_{};
  double most_doubt_ = 0.0;  // of all vertices that there have been
};

template <class ExactSide>
uint32_t PowerPolytope::find_beyond(const UnitPlane &S, const CubeFrame &frame, ExactSide exact_side) {
  const double margin = most_doubt_ + frame.plane_doubt();
  if (!find_values(S, -margin)) return 0;
  // Not by way of `this`, which marks could be part of as far as a compiler knows.
  const uint32_t count = count_;
  const double *const values = value_.data();
  uint8_t *const marks = beyond_.data();
  uint32_t *const holes = holes_.data();
  uint32_t found = 0;
  for (uint32_t v = 0; v < count; ++v) {
    bool beyond = values[v] > 0.0;
    if (!(std::fabs(values[v]) > margin)) {
      const int side = frame.side_of(vertices_[v].at, S);
      beyond = (side != 0 ? side : exact_side(vertices_[v])) < 0;
    }
    marks[v] = beyond ? 1 : 0;
    holes[found] = v;
    found += beyond ? 1 : 0;
  }
  hole_count_ = found;
  return found;
}

}  // namespace hsp
