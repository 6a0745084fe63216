// The combinatorial boundary of a union of balls as plain data, and a form of it that does not depend on the numbering
// of balls, vertices, arcs, faces, shells and components, so that two boundaries can be compared.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace oracle {

struct BoundaryRecord {
  struct Vertex {
    std::array<uint32_t, 3> ball;  // a < b < c
    int sign;                      // side along (c_b - c_a) x (c_c - c_a)
    // For the balls as given: two circles touch here, or the sphere of a further ball, not contained, passes through.
    bool tied;
  };
  struct Arc {
    std::array<uint32_t, 2> ball;    // a < b
    std::array<uint32_t, 2> vertex;  // from, to; counter-clockwise about the axis from c_a to c_b
    std::array<uint32_t, 2> face;    // the face on ball a, the face on ball b
  };
  struct Circle {
    std::array<uint32_t, 2> ball;
    std::array<uint32_t, 2> face;
  };
  struct Face {
    uint32_t ball;
    uint32_t loops;
    uint32_t shell;
  };
  struct Ball {
    bool contained;
    uint32_t component;
  };
  struct Counts {
    uint32_t exposed_balls = 0;
    uint32_t contained_balls = 0;
    uint32_t loops = 0;
    uint32_t shells = 0;
    uint32_t components = 0;
    uint32_t voids = 0;
    uint32_t tied_vertices = 0;
    int64_t euler = 0;
    bool operator==(const Counts &) const = default;
  };

  std::vector<Vertex> vertices;
  std::vector<Arc> arcs;
  std::vector<Circle> circles;
  std::vector<Face> faces;
  std::vector<Ball> balls;
  Counts counts;
};

// A vertex by the labels of its balls, ascending, and its side for that order.
struct VertexName {
  std::array<uint32_t, 3> ball = {0, 0, 0};
  int sign = 0;
  auto operator<=>(const VertexName &) const = default;
};

// Sort the three balls and adapt the sign: the normal (c_b - c_a) x (c_c - c_a) is alternating in the three balls.
VertexName vertex_name(uint32_t a, uint32_t b, uint32_t c, int sign);

// An arc by the labels of its two balls, ascending. It runs counter-clockwise about the axis from the lower to the
// higher label. A whole circle has two default ends.
struct EdgeName {
  std::array<uint32_t, 2> ball = {0, 0};
  VertexName from;
  VertexName to;
  auto operator<=>(const EdgeName &) const = default;
};

// A boundary by labels of its balls alone. Two of them are equal exactly if the boundaries are the same.
struct CanonicalBoundary {
  struct Vertex {
    VertexName name;
    bool tied;
    auto operator<=>(const Vertex &) const = default;
  };
  struct Face {
    uint32_t ball = 0;
    uint32_t loops = 0;
    std::vector<EdgeName> edges;
    auto operator<=>(const Face &) const = default;
  };

  BoundaryRecord::Counts counts;
  std::vector<uint8_t> contained;               // by label
  std::vector<uint32_t> smallest_of_component;  // by label: the smallest label in the ball's component
  std::vector<Vertex> vertices;                 // ascending, as all that follows
  std::vector<EdgeName> arcs;
  std::vector<EdgeName> circles;
  std::vector<Face> faces;
  std::vector<uint32_t> first_of_shell;  // by face: the first face of the same shell

  bool operator==(const CanonicalBoundary &) const = default;
};

// label[i]: a name for ball i, a permutation of 0 .. n - 1.
CanonicalBoundary canonical(const BoundaryRecord &record, const std::vector<uint32_t> &label);

// Which members differ, with both sizes; empty if the two are equal.
std::string differences(const CanonicalBoundary &a, const CanonicalBoundary &b);

}  // namespace oracle
