// The smooth surface as a map: patches, edges between two patches each, corners. All ids follow from those of the
// boundary; exceptions have ids behind these.
//
// With F faces, A arcs, C circles and V vertices of the boundary, arcs numbered by the first of their two half-edges,
// and saddles by their arc a, as a, or circle c, as A + c:
//   patch   f                     convex
//           F + k                 saddle k; with cusps its part at the ball that the caller gave first
//           F + A + C + v         concave patch of vertex v; its first piece if it is cut
//           then: the other parts of saddles with cusps, further pieces of cut patches
//   edge    2 k + s               between saddle k and the convex patch on its ball s, in the caller's order
//           2 A + 2 C + 2 a + e   the side between the saddle of arc a and the concave patch at its end e; with cusps
//                                 the part of it at ball 0
//           then: the parts at ball 1 of sides with cusps, in the same order; creases
//   corner  as in cut_patches.hpp
//
// A directed edge is 2 edge or 2 edge + 1. The first runs counter-clockwise about the axis of its circle; the patch on
// its left, seen from outside of the solid, is `left`. For the edges of arcs and circles the axis leads from ball 0 to
// ball 1, as in the boundary; sides run from ball 0 to ball 1.
#pragma once

#include "surface/surface.hpp"

namespace hsp {

enum class PatchKind : uint8_t { convex, saddle, concave, circle_saddle };
struct SurfacePatch {
  PatchKind kind;
  uint32_t source;  // face, saddle or vertex
  uint32_t part;    // of a saddle with cusps, the ball (0 or 1) that it lies at; of a concave patch, the id
                    // of its piece among cut patches, no_id if it is whole
};

enum class SurfaceEdgeKind : uint8_t { rim, circle_rim, side, crease };
struct SurfaceEdge {
  SurfaceEdgeKind kind;
  uint32_t source;  // rim, circle_rim: code of the element on the convex patch's ball; side: of the half-edge that
                    // starts at the vertex; crease: arc of cut patches
  uint32_t part;    // of a side with cusps, the ball (0 or 1) that it lies at

  LoopElement element() const { return LoopElement::from_code(source); }  // not of a crease
};

class SurfaceMap {
 public:
  SurfaceMap(const BallSet &balls, const Boundary &boundary, const Surface &surface)
      : balls_(balls), boundary_(boundary), surface_(surface) {}

  const BallSet &balls() const { return balls_; }
  const Boundary &boundary() const { return boundary_; }
  const Surface &surface() const { return surface_; }

  uint32_t patch_count() const { return first_extra_piece() + surface_.cut_patches().extra_pieces().size(); }
  uint32_t edge_count() const { return first_crease() + surface_.cut_patches().creases().size(); }
  uint32_t corner_count() const { return first_crease_corner() + surface_.cut_patches().crease_corners().size(); }

  SurfacePatch patch(uint32_t id) const;
  SurfaceEdge edge(uint32_t id) const;

  // Steps from directed edges, as in quad-edges.
  static uint32_t twin(uint32_t h) { return h ^ 1; }
  uint32_t next(uint32_t h) const;      // around the left patch
  uint32_t previous(uint32_t h) const;  // the same the other way
  uint32_t left(uint32_t h) const;
  uint32_t origin(uint32_t h) const;  // corner; no_id if the edge is a whole circle
  // A directed edge with the patch on its left; no_id if it has none: a whole sphere.
  uint32_t first_edge(uint32_t patch) const;
  // A directed edge of the next loop around the same patch; after the last loop one of the first.
  uint32_t next_loop(uint32_t h) const;

  // The concave patch of a vertex; if it is cut, that of the given piece.
  uint32_t concave_patch(uint32_t vertex, uint32_t piece) const;
  uint32_t patch_of_piece(uint32_t piece) const;
  // The shell of a patch or corner; no_id for a corner where no edge ends: the cusp of a whole circle.
  uint32_t shell_of(uint32_t patch) const;
  uint32_t shell_of_corner(uint32_t corner) const;
  // If the circle of a cusp has arcs of both parts (chosen_faces.hpp), the cusp is a corner of both. Then this is the
  // other one's shell, which shell_of_corner does not return; else no_id.
  uint32_t other_shell_of_cusp(uint32_t corner) const;
  // Whether a patch is of the part that is measured.
  bool is_chosen(uint32_t patch) const { return surface_.chosen().has(face_beside(patch)); }

  uint32_t first_cusp() const { return 3 * boundary_.vertex_count(); }
  uint32_t first_crease_corner() const { return first_cusp() + 2 * surface_.cusped_circles().count(); }
  // The cusp of a circle with cusps on the side of one of its balls.
  uint32_t cusp_at(uint32_t circle, uint32_t ball) const;
  // The number of a corner among cusps; no_id for other corners.
  uint32_t cusp_of(uint32_t corner) const {
    return corner >= first_cusp() && corner < first_crease_corner() ? corner - first_cusp() : no_id;
  }

  // Calls visit(h) for one directed edge of each loop of a patch.
  template <class Visit>
  void for_each_loop(uint32_t patch, Visit visit) const {
    const uint32_t first = first_edge(patch);
    if (first == no_id) return;
    uint32_t loop = first;
    do {
      visit(loop);
      loop = next_loop(loop);
    } while (loop != first);
  }
  // Calls visit(h) for each directed edge of a loop.
  template <class Visit>
  void for_each_edge(uint32_t loop, Visit visit) const {
    uint32_t h = loop;
    do {
      visit(h);
      h = next(h);
    } while (h != loop);
  }

  // Saddles, each by its element on one of its two balls.
  uint32_t saddle_of(LoopElement e) const;
  uint32_t side_of(LoopElement e) const;  // the ball's place among the saddle's two, in the caller's order
  LoopElement element_of(uint32_t saddle, uint32_t side) const;
  LoopElement across(LoopElement e) const {  // the saddle's element on the other ball
    if (!e.is_circle()) return LoopElement::arc(boundary_.twin(e.half_edge()));
    return LoopElement::circle({e.closed_half_edge().circle(), 1 - e.closed_half_edge().side()});
  }
  uint32_t cusped_circle_of(LoopElement e) const;  // no_id if there are no cusps

 private:
  uint32_t first_saddle() const { return boundary_.face_count(); }
  uint32_t first_concave() const { return first_saddle() + boundary_.arc_count() + boundary_.circle_count(); }
  uint32_t first_extra_saddle() const { return first_concave() + boundary_.vertex_count(); }
  uint32_t first_extra_piece() const { return first_extra_saddle() + surface_.cusped_circles().saddles(); }

  uint32_t first_side() const { return 2 * (boundary_.arc_count() + boundary_.circle_count()); }
  uint32_t first_extra_side() const { return first_side() + 2 * boundary_.arc_count(); }
  uint32_t first_crease() const { return first_extra_side() + 2 * surface_.cusped_circles().arcs(); }

  // A face of the boundary's shell that a patch belongs to.
  uint32_t face_beside(uint32_t patch) const;

  // A directed edge, decoded. Outward: its left patch is convex, or concave; else it is a saddle.
  struct Directed {
    SurfaceEdge edge;
    uint32_t arc;  // of cut patches, if the left patch is cut
    bool outward;
    bool at_other;  // a part of a side that is not at the ball of its half-edge
  };
  Directed directed(uint32_t h) const;

  // A rim has its convex patch on its left in the direction of its element.
  uint32_t along_rim(LoopElement e) const;
  // The side at the start of a half-edge, its part at the half-edge's ball or at the other one, with the saddle patch
  // on its left: it runs away from the half-edge's ball.
  uint32_t side_of_saddle(uint32_t half_edge, bool at_other) const;
  uint32_t edge_of_patch_arc(uint32_t arc) const;
  uint32_t patch_arc_of_side(uint32_t half_edge, uint32_t part) const;
  // Around the concave patch, the half-edges of the sides before and after that of a half-edge.
  uint32_t side_before(uint32_t half_edge) const;
  uint32_t side_after(uint32_t half_edge) const;

  // A saddle as a patch: the part at ball 0, or the part at ball 1 if there are cusps.
  SurfacePatch saddle_patch(uint32_t saddle, uint32_t part) const {
    return {saddle < boundary_.arc_count() ? PatchKind::saddle : PatchKind::circle_saddle, saddle, part};
  }
  // The number of a saddle among those with cusps.
  uint32_t cusped_saddle_of(LoopElement e) const;
  uint32_t corner_at(uint32_t vertex, uint32_t ball) const;
  // The shell at a cusp beside a half-edge on ball 0 of its circle.
  uint32_t shell_at_cusp(uint32_t cusp, uint32_t half_edge) const {
    return surface_.shells().of_face(boundary_.face_of(cusp % 2 == 0 ? half_edge : boundary_.twin(half_edge)));
  }

  const BallSet &balls_;
  const Boundary &boundary_;
  const Surface &surface_;
};

}  // namespace hsp
