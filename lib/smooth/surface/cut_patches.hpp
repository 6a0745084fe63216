// Concave patches that other probes cut: the pieces that are left of them, and the arcs around these pieces. A patch
// that is whole needs no record: it has three sides between three corners.
//
//   vertex --pieces--> piece --arcs--> arc --next--> ... = one loop
//
// An arc runs counter-clockwise about the axis of the cap that bounds the patch there: seen from the probe's centre,
// which is outside of the solid, the patch lies on its left. An arc is a part of a side of the patch, where a saddle
// patch adjoins, or of a crease, where the patch of another probe adjoins.
//
// A corner has the same number in all patches that meet there:
//   3 v + t               the corner of the patch of vertex v at the vertex's ball number t; it is stored nowhere
//   3 V + 2 k + s         the cusp of cusped circle k on the side of its ball number s
//   3 V + 2 K + 0, 1 ...  where three creases meet
// with V vertices and K cusped circles.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/id_range.hpp"
#include "core/ranked_bits.hpp"
#include "core/vec3.hpp"
#include "core/workspace.hpp"

namespace hsp {

// An arc of a circle of a unit sphere, counter-clockwise about its axis.
struct SphereArc {
  Vec3 axis;      // unit vector
  double height;  // of its circle's plane
  double angle;   // (0, 2 pi]
  Vec3 chord;     // from its start to its end; 0 for a whole circle

  // Its term in the vector area, the integral of the direction, of a region that lies below its circle.
  Vec3 vector_area() const {
    return -0.5 * combine(height, cross(axis, chord), (1.0 - height) * (1.0 + height) * angle, axis);
  }
};

// Sums over the creases of a piece that derivatives of the surface's area need (surface_gradients.hpp). A crease lies
// on the unit sphere's circle with axis a at height c, and runs from w to w' through the angle phi.
struct CreaseSums {
  Vec3 directions{0.0, 0.0, 0.0};  // of c times the integral of the direction: c (c phi a + (w' - w) x a)
  double angle = 0.0;              // of c phi

  void add(const SphereArc &crease) {
    const double c = crease.height;
    directions = combine(1.0, directions, c * c * crease.angle, crease.axis);
    directions = combine(1.0, directions, c, cross(crease.chord, crease.axis));
    angle += c * crease.angle;
  }
};

// Measures of what other probes leave of the concave patch of a vertex.
struct ConcavePatch {
  double area = 0.0;                // square steps
  double volume = 0.0;              // its term of the divergence theorem about the origin of the component, cubic steps
  Vec3 vector_area{0.0, 0.0, 0.0};  // integral of the directions from the vertex, over the part of the unit sphere
};

struct PatchPiece {
  uint32_t vertex;
  uint32_t first_arc;  // arcs of a piece are consecutive, and those of the next piece follow
  double area;         // square steps
  double volume;       // as above
  CreaseSums creases;
};

struct PatchArc {
  uint32_t across;  // of a crease, the vertex of the probe across; of a side, side(slot)
  uint32_t corner;  // where it starts; no_id for a whole circle
  uint32_t next;    // in its loop; itself for a whole circle
  uint32_t twin;    // of a crease, the arc of the other probe; else no_id
  double angle;

  static constexpr uint32_t side_bit = UINT32_C(1) << 31;
  static constexpr uint32_t side(uint32_t slot) { return side_bit | slot; }
  bool is_side() const { return (across & side_bit) != 0; }
  // The slot in the vertex's record of the ball that the side is opposite to.
  uint32_t slot() const { return across & ~side_bit; }
};

// Calls visit(k) for the arcs of a loop, from arc `loop` on. Arc is any record that holds the next arc of its loop.
template <class Arc, class Visit>
void for_each_of_loop(Span<Arc> arcs, uint32_t loop, Visit visit) {
  uint32_t k = loop;
  do {
    visit(k);
    k = arcs[k].next;
  } while (k != loop);
}
// Sets the loop of all arcs that have none: the first arc of that loop.
template <class Arc>
void label_loops(Span<Arc> arcs) {
  for (uint32_t first = 0; first < arcs.size(); ++first) {
    if (arcs[first].loop == no_id) for_each_of_loop(arcs, first, [&](uint32_t k) { arcs[k].loop = first; });
  }
}
// Finds which loops bound one piece of a patch that is less than half a sphere. Sets the piece of all arcs: the first
// arc of the loop around that piece. excess(loop): the area on the left of a loop, less that of half a sphere. It is
// negative for a loop around a piece, and positive for a loop around a hole. If there is only one piece, all holes are
// in it. False if there are several pieces and a hole, or if an excess may be 0: sums are right to far less than the
// margin, as every angle has the right sign. characteristic: the number of pieces minus that of holes.
template <class Arc, class Excess>
bool gather_pieces(Span<Arc> arcs, Excess excess, int32_t &characteristic) {
  constexpr double margin = 1e-3;
  int32_t pieces = 0, holes = 0;
  uint32_t outer = no_id;
  for (uint32_t k = 0; k < arcs.size(); ++k) {
    if (arcs[k].loop != k) continue;
    const double own = excess(k);
    if (!(own < -margin || own > margin)) return false;
    ++(own < 0.0 ? pieces : holes);
    if (own < 0.0) outer = k;
  }
  characteristic = pieces - holes;
  if (holes > 0 && pieces != 1) return false;
  for (Arc &arc : arcs) arc.piece = holes > 0 ? outer : arc.loop;
  return true;
}

class CutPatches {
 public:
  void carve(Workspace &workspace, uint32_t vertices, uint32_t pieces, uint32_t arcs);

  // All vertices are added in the order of their ids.
  void clear();
  void begin_vertex(uint32_t vertex) { first_piece_[vertex] = pieces_.size(); }
  // Sets the sum of a vertex's pieces, after all of them.
  void set_patch(uint32_t vertex, const ConcavePatch &patch) {
    if (first_piece_[vertex] < patch_.size()) patch_[first_piece_[vertex]] = patch;
  }
  void begin_piece(uint32_t vertex, double area, double volume, const CreaseSums &creases = {});
  void add_arc(uint32_t across, double angle, bool last_of_loop);
  void finish(uint32_t vertices);
  // To be called once creases have their twins and arcs their corners. A corner of three creases then has the number
  // first_crease_corner + a, with a the arc that it is numbered at; here a is replaced by its rank.
  void number_joints(uint32_t first_crease_corner);

  uint64_t required_pieces() const { return pieces_.required(); }
  uint64_t required_arcs() const { return arcs_.required(); }
  bool overflowed() const { return pieces_.overflowed() || arcs_.overflowed(); }

  uint32_t piece_count() const { return pieces_.size(); }
  uint32_t arc_count() const { return arcs_.size(); }
  // The pieces of a vertex; none if its patch is whole.
  IdRange pieces(uint32_t vertex) const { return {first_piece_[vertex], first_piece_[vertex + 1]}; }
  bool is_cut(uint32_t vertex) const { return first_piece_[vertex] < first_piece_[vertex + 1]; }
  // The measures of a vertex whose patch is cut.
  const ConcavePatch &patch(uint32_t vertex) const { return patch_[first_piece_[vertex]]; }
  const PatchPiece &piece(uint32_t k) const { return pieces_[k]; }
  IdRange arcs(uint32_t piece) const { return {first_arc(piece), first_arc(piece + 1)}; }
  IdRange arcs_of_vertex(uint32_t vertex) const {
    return {first_arc(first_piece_[vertex]), first_arc(first_piece_[vertex + 1])};
  }
  const PatchArc &arc(uint32_t k) const { return arcs_[k]; }
  PatchArc &arc(uint32_t k) { return arcs_[k]; }
  // The piece that an arc bounds.
  uint32_t piece_of_arc(uint32_t arc) const;
  uint32_t vertex_of_arc(uint32_t arc) const { return piece(piece_of_arc(arc)).vertex; }
  // The arc before it in its loop.
  uint32_t previous(uint32_t arc) const;
  // Where an arc ends.
  uint32_t end_corner(uint32_t k) const { return arc(arc(k).next).corner; }

  // Bit sets, whose ranks number creases, corners and pieces: the first of the two arcs of each crease; for each corner
  // of three creases the arc that starts there in the patch of the lowest vertex; the pieces that are not the first of
  // their vertex.
  const RankedBits &creases() const { return creases_; }
  const RankedBits &crease_corners() const { return crease_corners_; }
  const RankedBits &extra_pieces() const { return extra_pieces_; }

 private:
  uint32_t first_arc(uint32_t piece) const { return piece < pieces_.size() ? pieces_[piece].first_arc : arcs_.size(); }

  Span<uint32_t> first_piece_;  // [vertices + 1]
  Span<ConcavePatch> patch_;    // at the first piece of its vertex
  FixedVector<PatchPiece> pieces_;
  FixedVector<PatchArc> arcs_;
  uint32_t loop_ = 0;  // first arc of the loop at hand
  RankedBits creases_, crease_corners_, extra_pieces_;
};

}  // namespace hsp
