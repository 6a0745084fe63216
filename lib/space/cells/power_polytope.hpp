// A convex polytope that planes cut out of a cube, as a graph: each vertex is on three planes, each edge on two. The
// caller says which vertices lie beyond a plane; everything else is combinatorial. Under the symbolic perturbation no
// four planes have a common point, so that every polytope is simple. Coordinates are used only by the filter stage of
// predicates.
#pragma once

#include <bit>

#include "cells/cube_frame.hpp"
#include "cells/edge_crossings.hpp"
#include "cells/vertex_sides.hpp"
#include "core/workspace.hpp"

namespace hsp {

// Seen from outside, the planes come in the same sense of rotation around every vertex. So a walk around a facet in
// that sense reaches a vertex along the edge opposite to plane[k], has the facet as plane[k + 1], and goes on along the
// edge opposite to plane[k + 2], indices modulo 3.
struct PolytopeVertex {
  uint32_t plane[3];
  uint32_t link[3];  // [k]: the vertex at the other end of the edge opposite to plane[k], and its k, as 4 vertex + k

  uint32_t neighbour(uint32_t k) const { return link[k] / 4; }
  uint32_t back(uint32_t k) const { return link[k] % 4; }
  uint32_t slot_of(uint32_t wanted) const { return (plane[1] == wanted ? 1U : 0U) + (plane[2] == wanted ? 2U : 0U); }
  bool has(uint32_t wanted) const { return plane[0] == wanted || plane[1] == wanted || plane[2] == wanted; }
};
constexpr uint32_t next_of_three(uint32_t k) {
  return k == 2 ? 0 : k + 1;
}
constexpr uint32_t previous_of_three(uint32_t k) {
  return k == 0 ? 2 : k - 1;
}

// How much of a polytope is beyond a plane.
enum class CutOff { nothing, some, all };

class PowerPolytope {
 public:
  // Planes 0 .. 5 are the sides of the cube, the others those of up to so many balls.
  static uint64_t most_planes(uint32_t balls) { return static_cast<uint64_t>(balls) + cube_sides; }
  // A simple polytope of f facets has 2 f - 4 vertices. During a cut there are the old and the new vertices.
  static uint64_t most_vertices(uint32_t balls) { return 2 * most_planes(balls); }
  void carve(Workspace &workspace, uint32_t balls);

  // Starts with the whole cube, for a ball with this centre.
  void start(const CubeFrame &frame, const Vec3 &centre);
  // The vertices for find_cut().
  const CutVertices &to_cut() {
    to_cut_.count = count_;
    return to_cut_;
  }
  // After find_cut(), which has noted what doubles tell: decides which vertices are beyond plane S. exact_side(vertex),
  // +1 near or -1 beyond, is asked for the others. Returns how much of the polytope is beyond.
  template <class ExactSide>
  CutOff decide_sides(const UnitPlane &S, const CubeFrame &frame, ExactSide exact_side);
  // Cuts off the vertices beyond plane number `plane`, for which decide_sides() has returned CutOff::some. planes: all
  // planes, by number. The part beyond a plane is connected, and so is the rest.
  void cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame);
  void make_empty() { count_ = 0; }

  uint32_t size() const { return count_; }
  const PolytopeVertex &operator[](uint32_t v) const { return vertices_[v]; }
  Vec3 position(uint32_t v) const { return {to_cut_.at.x[v], to_cut_.at.y[v], to_cut_.at.z[v]}; }
  BoundedPoint at(uint32_t v) const { return {position(v), to_cut_.at.error[v]}; }
  // The squared distance of a vertex from the centre of the ball.
  double squared(uint32_t v) const { return to_cut_.at.squared[v]; }
  const VertexArrays &arrays() const { return to_cut_.at; }
  // The mean of the vertices, a point of the polytope. It is off by no more than they are, but for rounding.
  Vec3 middle() const;
  // A bound of the errors of all vertices.
  double most_error() const { return most_error_; }

 private:
  template <class IsNear>
  uint32_t find_crossings(IsNear is_near);
  void solve_uncertain(uint32_t count, const UnitPlane *planes, const CubeFrame &frame);
  void clear_squares_behind();
  void move(uint32_t from, uint32_t to);

  Span<PolytopeVertex> vertices_;
  CutVertices to_cut_{};   // [vertices + 7] the positions of vertices
  Span<uint64_t> beyond_;  // [vertices / 64] a bit for each vertex
  Span<uint64_t> unsure_;  // [vertices / 64]
  // The vertices that are beyond, ascending; their slots are used again. Behind them the number of vertices.
  Span<uint32_t> holes_;         // [vertices + 1]
  Span<CrossedEdge> crossings_;  // [vertices + crossings_behind]
  Span<uint32_t> made_;          // [vertices + crossings_behind] the new vertex of each crossing
  Span<uint32_t> ends_;  // [planes] of the edge on this plane and the new one: the exclusive or of both ends, as links
  uint32_t count_ = 0, hole_count_ = 0;
  CrossingBounds bounds_{};
  double most_error_ = 0.0;  // the largest error of all vertices so far, also those cut off
  Target target_ = Target::baseline;
};

template <class ExactSide>
CutOff PowerPolytope::decide_sides(const UnitPlane &S, const CubeFrame &frame, ExactSide exact_side) {
  bool any_near = false, any_beyond = false;
  for (uint32_t first = 0; first < count_; first += 64) {
    uint64_t beyond = beyond_[first / 64];
    for (uint64_t left = unsure_[first / 64]; left != 0; left &= left - 1) {
      const uint32_t v = first + static_cast<uint32_t>(std::countr_zero(left));
      const int side = frame.side_of(at(v), S);
      if ((side != 0 ? side : exact_side(vertices_[v])) < 0) beyond |= left & (~left + 1);
    }
    beyond_[first / 64] = beyond;
    any_beyond |= beyond != 0;
    any_near |= beyond != ~UINT64_C(0) >> (count_ - first < 64 ? 64 - (count_ - first) : 0);
  }
  return !any_beyond ? CutOff::nothing : any_near ? CutOff::some : CutOff::all;
}

}  // namespace hsp
