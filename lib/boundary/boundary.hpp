// The boundary of a union as it is built: per ball its uses of vertices, chained to loops, gathered to faces. All ids
// of balls are the grid's; the memory is carved once for given limits.
//
//   ball i --first_use--> uses (vertex, in, out) --next--> ... = one loop     circle_side --> free circles = loops on
//   their own
//          --first_loop--> loops --loop_face--> faces --first_face
//
// A use is the visit of a loop to a vertex: the loop comes in along the circle with ball `in` and leaves along the
// circle with ball `out`, with the face on its left, that is clockwise about the axis towards the other ball.
#pragma once

#include "boundary/records.hpp"
#include "core/disjoint_sets.hpp"
#include "core/fixed_vector.hpp"
#include "core/workspace.hpp"
#include "model/cube_grid.hpp"

namespace hsp {

struct BoundaryLimits {
  uint32_t balls = 0;
  uint32_t neighbours = 0;
  uint32_t vertices = 0;
  uint32_t circles = 0;
};

struct VertexUse {
  uint32_t vertex;
  uint32_t in, out;  // balls
  uint32_t next;     // the use at which the arc along `out` ends
  uint32_t loop;
};

struct FaceRecord {
  uint32_t ball;
  uint32_t loops;
  uint32_t shell;
};

struct BoundaryStructure {
  FixedVector<VertexRecord> vertices;
  FixedVector<CircleRecord> circles;
  Span<double> root_discriminant;  // [vertices] sqrt(D), exact D rounded once

  Span<VertexUse> uses;              // [3 vertices], by ball, in an order that does not depend on ids
  Span<uint32_t> first_use;          // [balls + 1]
  Span<uint32_t> use_at;             // [3 vertices] use of vertex v by its ball number t at 3 v + t
  Span<uint32_t> circle_side;        // [2 circles] by ball: 2 * circle + side
  Span<uint32_t> first_circle_side;  // [balls + 1]

  Span<uint32_t> first_loop;  // [balls + 1]
  Span<uint32_t> loop_cap;    // [loops] a ball whose circle the loop runs along
  Span<uint32_t> loop_face;   // [loops]
  Span<uint32_t> first_face;  // [balls + 1]
  Span<FaceRecord> faces;
  uint32_t loop_count = 0;
  uint32_t face_count = 0;
  uint32_t shell_count = 0;

  Span<uint8_t> ball_state;  // [balls]
  static constexpr uint8_t contained = 1;
  static constexpr uint8_t without_caps =
      2;  // no other sphere meets it: the whole sphere is free unless it is contained
  // Clusters of the ball's caps (faces.hpp), counted while the caps are at hand if they are few.
  Span<uint8_t> cluster_count;
  static constexpr uint8_t not_counted = 0;
  Span<uint32_t> component_parent;  // [balls]
  DisjointSets components;
  Span<uint32_t> face_parent;  // [faces]

  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // Loops have at least two arcs or are circles.
  static uint64_t most_loops(const BoundaryLimits &limits) {
    return 3 * static_cast<uint64_t>(limits.vertices) / 2 + 2 * static_cast<uint64_t>(limits.circles);
  }
};

}  // namespace hsp
