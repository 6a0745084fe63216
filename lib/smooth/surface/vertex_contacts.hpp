// How a vertex of the boundary moves with the three spheres through it, seen from one of them. With their normals n_k
// there it stays on all three: n_k.v' = n_k.c_k' + R_k', so v' is the sum of (n_k.c_k' + R_k') g_k over the spheres,
// where g_0 = (n_1 x n_2) / det(n_0, n_1, n_2) and so on.
#pragma once

#include "measure/boundary_positions.hpp"

namespace hsp {

struct VertexContacts {
  uint32_t slot;     // in the vertex's record, of the ball that sees it
  uint32_t ball[3];  // that one first; then the others in the cyclic order of the record
  Vec3 normal[3];
  Vec3 share;      // g_0
  double sign;     // of the determinant
  double inverse;  // 1 / its size

  // A vertex with a discriminant above 0. `offset` from the centre of ball `own` to it.
  VertexContacts(const BallSet &balls, const Boundary &boundary, uint32_t vertex, uint32_t own, const Vec3 &offset) {
    const VertexRecord &record = boundary.vertex(vertex);
    slot = record.slot_of(own);
    ball[0] = own;
    normal[0] = (1.0 / balls.r[own]) * offset;
    double twice = 2.0 * balls.r[own];
    for (uint32_t k = 1; k < 3; ++k) {
      ball[k] = record.ball[(slot + k) % 3];
      normal[k] = (1.0 / balls.r[ball[k]]) * (offset - balls.difference(own, ball[k]));
      twice *= balls.r[ball[k]];
    }
    // The determinant has the vertex's sign; its size is exact but for rounding.
    sign = record.positive() ? 1.0 : -1.0;
    inverse = twice / boundary.root_discriminant(vertex);
    find_share();
  }
  // Recomputes normals and share from the one position of the vertex, so that all three balls have the same bits.
  void see_as_all(const BallSet &balls, const Position &vertex) {
    for (uint32_t k = 0; k < 3; ++k)
      normal[k] = (1.0 / balls.r[ball[k]]) * (vertex.offset - balls.difference(vertex.ball, ball[k]));
    find_share();
  }

 private:
  void find_share() { share = sign * inverse * cross(normal[1], normal[2]); }
};

}  // namespace hsp
