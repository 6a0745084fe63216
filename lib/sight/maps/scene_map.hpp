// The visible part of a union of balls along a direction, as a subdivision of the view plane (Section 5.2): every face
// shows one ball or the background. Bodies of other kinds are possible if they are convex. All that depends on the kind
// of bodies is in the scene of a map: BallScene for balls, StickScene for balls and sticks.
//
// The visible surface is the upper envelope of the front hemispheres. So every edge is a part of one of two kinds of
// curves: a silhouette, or the crease where the spheres of two balls meet. Creases never hide anything, because the
// surface is re-entrant there: only silhouettes and spheres hide. The kinds of vertices:
//
//   triple   three creases end where three spheres meet
//   T        a curve, the stem, ends where it goes behind a nearer ball, on the silhouette of that ball
//   tangency the crease of two balls goes over into the silhouette of the nearer one
//   plain    an arbitrary point of a closed curve that has no other vertex
//   halves   where the contours of both halves of a stick and the curve between the halves end; only with sticks
//
// Unlike everything below this room the map rests on floating-point roots. Its connections are checked while
// it is built (map_builder.hpp). The same input gives the same bits on every machine.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/workspace.hpp"
#include "view/view_frame.hpp"

namespace hsp {

enum class MapVertexKind : uint32_t { plain = 0, triple = 1, t = 2, tangency = 3, halves = 4 };

// How many edges meet at a vertex.
constexpr uint32_t degree_of(MapVertexKind kind) {
  return kind == MapVertexKind::plain || kind == MapVertexKind::tangency ? 2 : 3;
}

// Positions are view coordinates. Bodies have the ids of their scene.
struct MapVertex {
  double x, y, z;
  MapVertexKind kind;
  uint32_t leaving;  // a half-edge that leaves it; of a T the one of the stem
  // The bodies of the curves that meet; no_id behind the last one. Triple: ascending. T: first the one or two bodies of
  // the stem (the second is no_id if the stem is a silhouette), last the nearer body whose contour it is on. Tangency:
  // the farther, the nearer. Plain: those of the curve.
  uint32_t body[3];
};

// A part of the silhouette of `body`; or of the crease of `body` and `nearer`, if `nearer` is a body. The parameters
// are those of ball_scene.hpp; they increase from vertex[0] to vertex[1]. Half-edge 2e runs along edge e, 2e + 1
// against it.
struct MapEdge {
  double from, to;
  uint32_t body;
  uint32_t nearer;  // no_id on a silhouette
  uint32_t vertex[2];

  bool is_silhouette() const { return nearer == no_id; }
};

// A half-edge has its face on the left.
struct MapHalfEdge {
  uint32_t next;
  uint32_t loop;
};

// Outer loops run counter-clockwise and have a positive area, holes run clockwise and have a negative one.
struct MapLoop {
  uint32_t first_half_edge;
  uint32_t face;
  uint32_t next_of_face;  // no_id behind the last one
  uint32_t owner;         // the owner of its face
  double area;
};

struct MapFace {
  uint32_t owner;       // the body that is seen, no_id for the background
  uint32_t first_loop;  // the outer loop and then the holes; the unbounded face has holes only
  double area;          // 0 for the unbounded face
};

// How much room the makers of a map need at most: for bodies, groups of corners (CornerName), and edges.
struct MapSizes {
  uint64_t bodies, groups, edges;
};

// Face 0 is the unbounded one. The faces of one owner follow each other, those of the background first.
struct MapRecords {
  ViewFrame frame;
  double perturbation = 0.0;  // a bound of how far centres were moved, in lattice steps; 0 if they were not
  uint32_t components = 0;    // connected parts of the edges
  uint32_t owners = 0;        // bodies with faces
  FixedVector<MapVertex> vertices;
  FixedVector<MapEdge> edges;
  FixedVector<MapHalfEdge> half_edges;
  FixedVector<MapLoop> loops;
  FixedVector<MapFace> faces;
  Span<const uint32_t> loop_order;  // loops sorted by owner: owners in the order of faces, the background last

  // Every vertex has at least two edges, so that there are no more vertices than edges. There are at most twice as many
  // loops as edges, and at most one more face than edges: F = 1 + C + E - V, and each of the C parts has a vertex.
  void carve(Workspace &workspace, uint64_t most_edges) {
    vertices = FixedVector<MapVertex>(workspace.take<MapVertex>(most_edges));
    edges = FixedVector<MapEdge>(workspace.take<MapEdge>(most_edges));
    half_edges = FixedVector<MapHalfEdge>(workspace.take<MapHalfEdge>(2 * most_edges));
    loops = FixedVector<MapLoop>(workspace.take<MapLoop>(2 * most_edges));
    faces = FixedVector<MapFace>(workspace.take<MapFace>(2 * most_edges + 1));
  }
  void clear() {
    vertices.clear();
    edges.clear();
    half_edges.clear();
    loops.clear();
    faces.clear();
    components = 0;
    owners = 0;
  }

  uint32_t origin(uint32_t half_edge) const { return edges[half_edge / 2].vertex[half_edge % 2]; }
  uint32_t face_of(uint32_t half_edge) const { return loops[half_edges[half_edge].loop].face; }
  // The body on the left of a half-edge; no_id on the far side of a silhouette, which does not tell it.
  uint32_t left_of(uint32_t half_edge) const {
    const MapEdge &edge = edges[half_edge / 2];
    if (edge.is_silhouette()) return half_edge % 2 == 0 ? edge.body : no_id;
    return half_edge % 2 == 0 ? edge.nearer : edge.body;
  }
  // Calls visit(half-edge) around a loop. The next half-edge is read before the call.
  template <class Visit>
  void visit_loop(uint32_t loop, Visit visit) const {
    const uint32_t first = loops[loop].first_half_edge;
    uint32_t h = first;
    do {
      const uint32_t next = half_edges[h].next;
      visit(h);
      h = next;
    } while (h != first);
  }
  // Calls visit(loop) for the outer loop of a face and then for its holes.
  template <class Visit>
  void visit_loops(uint32_t face, Visit visit) const {
    for (uint32_t l = faces[face].first_loop; l != no_id; l = loops[l].next_of_face) visit(l);
  }
  // The face after another one of the same owner; no_id after the last.
  uint32_t next_face_of(uint32_t face) const {
    return face + 1 < faces.size() && faces[face + 1].owner == faces[face].owner ? face + 1 : no_id;
  }
};

template <class Scene>
struct SceneMap : MapRecords {
  Scene scene;
  Span<const uint32_t> first_face;  // [slot of a body] its first face; no_id if it has none

  // The first face that shows a body or, for no_id, the background; no_id if there is none.
  uint32_t first_face_of(uint32_t owner) const { return owner == no_id ? 0 : first_face[scene.slot_of(owner)]; }
};

}  // namespace hsp
