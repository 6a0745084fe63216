// Connected components of the union and of its boundary.
//
// Two balls belong to one component of the union if they meet. As an example balls 0 to 3 of the grid, of which 0 meets
// 2 and 1 meets 3: two components. If the caller has given ball 3 first, component 0 is that of balls 1 and 3, and its
// origin is the one of these with the lower rank.
//
// Two faces belong to one shell if they share an arc or a free circle. As an example a hollow ball of many balls with
// two more balls far away, which meet each other: three shells, the outer and the inner one of the first component, and
// one of two faces.
#pragma once

#include "boundary/boundary.hpp"
#include "core/ahead.hpp"
#include "core/patience.hpp"
#include "core/small_code.hpp"

namespace hsp {

// On entry arrays.component_origin holds the parents of disjoint sets, in which balls of one component are joined. Puts
// there for each ball the origin of its component, and numbers the components in the order of their first balls in the
// input.
void number_components(const CubeGrid &grid, Patience &patience, BoundaryArrays &arrays);

// Joins the faces that meet at some vertices or share some circles. Other workers may join in the same sets meanwhile.
// If the patience ends, only some of them are joined.
template <class Sets>
void join_faces(const Boundary &boundary, IdRange vertices, IdRange circles, Patience &patience, Sets &shells) {
  // The three faces at a vertex share arcs, and every arc has a vertex.
  const bool far_apart = !small_code && boundary.vertex_count() > ahead::few_vertices;
  in_parts(patience, vertices, 100, [&](IdRange some) {
    for (const uint32_t v : some) {
      if (far_apart && v + ahead::vertices < vertices.last) boundary.prefetch_half_edges_at(v + ahead::vertices);
      const uint32_t first = boundary.face_of(boundary.half_edge_at(v, 0));
      shells.join(first, boundary.face_of(boundary.half_edge_at(v, 1)));
      shells.join(first, boundary.face_of(boundary.half_edge_at(v, 2)));
    }
  });
  for (const uint32_t c : circles) {
    const CircleRecord &circle = boundary.circle(c);
    shells.join(boundary.face_of_loop(circle.loop[0]), boundary.face_of_loop(circle.loop[1]));
  }
}

// Numbers the shells in the order of their first face and stores them in the faces. scratch [faces].
void find_shells(const Boundary &boundary, BoundaryArrays &arrays, Span<uint32_t> scratch, Patience &patience);

// The same once the faces have been joined.
void number_shells(DisjointSets shells, BoundaryArrays &arrays);

}  // namespace hsp
