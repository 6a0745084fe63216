// A triangulation of a whole sphere with given points: Delaunay by insertion of the points, then required edges by
// flips.
//
// It begins as an octahedron, so that there is no point at infinity and a whole sphere needs no special case. All
// triangles run counter-clockwise seen from outside, exactly, whatever the points. They are Delaunay triangles as far
// as the rounded points are on one sphere.
#pragma once

#include "core/status.hpp"
#include "core/workspace.hpp"
#include "mesh/rounded_direction.hpp"

namespace hsp {

// A triangle and one of its edges: the one opposite corner `edge`.
struct TriangleEdge {
  uint32_t triangle, edge;
};

struct SphereTriangle {
  uint32_t point[3];
  uint32_t neighbour[3];  // across the edge opposite the point
  bool fixed[3];          // edges that must stay

  uint32_t corner_of(uint32_t p) const { return point[0] == p ? 0 : point[1] == p ? 1 : 2; }
  uint32_t edge_towards(uint32_t t) const { return neighbour[0] == t ? 0 : neighbour[1] == t ? 1 : 2; }
};

constexpr uint32_t next_corner(uint32_t c) {
  return c == 2 ? 0 : c + 1;
}
constexpr uint32_t previous_corner(uint32_t c) {
  return c == 0 ? 2 : c - 1;
}

class SphereTriangulation {
 public:
  static constexpr uint32_t octahedron_points = 6;
  static constexpr uint32_t octahedron_turns = 8;

  // For so many points, the octahedron's among them.
  void carve(Workspace &workspace, uint32_t points);

  // Corner k of the octahedron in orientation `turn`, one of octahedron_turns.
  static Vec3 octahedron_corner(uint32_t turn, uint32_t k);
  // Starts with the octahedron alone. There must be room for at least its 6 points.
  void start(uint32_t turn);

  // Returns the number of the point, which is that of an earlier one if the two coincide. There must be room for it.
  uint32_t insert(const RoundedDirection &p);
  // Makes the edge from a to b one that stays. False if it meets a point or such an edge: `obstacle` then becomes one
  // of the points there.
  bool fix_edge(uint32_t a, uint32_t b, uint32_t &obstacle);
  // After that: the other end of the edge in the way, or no_id.
  uint32_t other_obstacle() const { return other_obstacle_; }
  // Removes a point where no fixed edge ends. Its number is not used again, and numbers of triangles change. False if
  // the triangles around it cannot give way to others.
  bool remove(uint32_t p);
  // Flips the edges that fix_edge and remove have left and that are not Delaunay edges.
  void restore_all();

  uint32_t point_count() const { return point_count_; }
  const RoundedDirection &point(uint32_t p) const { return point_[p]; }
  uint32_t triangle_count() const { return triangle_count_; }
  const SphereTriangle &triangle(uint32_t t) const { return triangle_[t]; }
  // One of the triangles around a point.
  uint32_t triangle_at(uint32_t p) const { return triangle_at_[p]; }
  // The triangle to the left of the edge from a to b, and the edge there. False if there is none.
  bool find_edge(uint32_t a, uint32_t b, TriangleEdge &found) const;

 private:
  int side(uint32_t a, uint32_t b, uint32_t c) const { return orientation(point_[a], point_[b], point_[c]); }
  uint32_t locate(const RoundedDirection &p) const;
  // The first edge of a triangle that a point lies beyond; 3 if there is none.
  uint32_t edge_before(const SphereTriangle &triangle, const RoundedDirection &p) const;
  void set_triangle(uint32_t t, const SphereTriangle &triangle);
  void replace_neighbour(uint32_t t, uint32_t old, uint32_t by);
  void split_triangle(uint32_t t, uint32_t p);
  void split_edge(uint32_t t, uint32_t edge, uint32_t p);
  bool may_flip(uint32_t t, uint32_t edge) const;
  bool wants_flip(uint32_t t, uint32_t edge) const;
  void flip(uint32_t t, uint32_t edge);
  void push(uint32_t t) { stack_[stacked_++] = t; }
  void restore_around(uint32_t p);
  bool gather_crossings(uint32_t a, uint32_t b, uint32_t &obstacle);
  bool has_three_triangles(uint32_t p) const;
  bool flip_edge_of(uint32_t p);
  void remove_triangle(uint32_t t);

  struct Pair {
    uint32_t a, b;
  };

  Span<RoundedDirection> point_;
  Span<uint32_t> triangle_at_;  // [points] one of the triangles around each
  Span<SphereTriangle> triangle_;
  Span<uint32_t> stack_;  // triangles
  Span<Pair> crossing_;   // edges that cross the required one, a ring buffer
  uint32_t point_count_ = 0;
  uint32_t triangle_count_ = 0;
  uint32_t stacked_ = 0;
  uint32_t crossings_ = 0;
  uint32_t other_obstacle_ = no_id;
  uint32_t last_ = 0;  // where the next search begins
  bool flipped_ = false;
};

}  // namespace hsp
