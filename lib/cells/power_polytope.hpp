// A convex polytope that planes cut out of a cube, as a graph: vertices of three planes each, joined by edges of two.
// Who cuts says which vertices lie beyond a plane; everything else is combinatorial. Under the symbolic perturbation no
// four planes have a common point, so every polytope stays simple. Coordinates serve the filter stage of predicates
// alone.
#pragma once

#include "cells/cube_frame.hpp"
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

  // The whole cube.
  void start(double side);
  // Cuts off the vertices for which beyond[] is set, by plane number `plane`, which is `S` in doubles; `planes` are all
  // of them. Some vertices are beyond. What is beyond a plane is connected, and so is the rest.
  void cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame);
  void make_empty() { count_ = 0; }

  uint32_t size() const { return count_; }
  // On which sides of the cube it has a facet, as bits.
  uint32_t sides() const {
    uint32_t bits = 0;
    for (uint32_t v = 0; v < count_; ++v) {
      for (const uint32_t number : vertices_[v].plane) bits |= number < cube_sides ? 1U << number : 0U;
    }
    return bits;
  }
  const PolytopeVertex &operator[](uint32_t v) const { return vertices_[v]; }
  void set_beyond(uint32_t v, bool beyond) { beyond_[v] = beyond ? 1 : 0; }

 private:
  void link(uint32_t vertex, uint32_t k, uint32_t plane);
  void move(uint32_t from, uint32_t to);

  Span<PolytopeVertex> vertices_;
  Span<uint8_t> beyond_;
  Span<uint32_t> holes_;  // [vertices] places of those that are cut off
  Span<uint32_t> open_;   // [planes] the edge on it and the new plane that still waits for its other end
  uint32_t count_ = 0;
};

}  // namespace hsp
