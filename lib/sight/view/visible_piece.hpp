// The piece of one ball: the free part of its front hemisphere, as loops of half-edges. The half of the sphere
// behind the centre is one more cap, whose circle is the silhouette, so that everything is decided by the predicates of
// lib/ground/exact and the vertex search of lib/union/sphere.
#pragma once

#include "boundary/boundary.hpp"
#include "sphere/half_edge_chain.hpp"
#include "sphere/vertex_finder.hpp"
#include "view/view_frame.hpp"

namespace hsp {

// An arc of a loop. A circle is named by the index of the cap that it bounds.
struct PieceHalfEdge {
  uint32_t previous_circle;  // the circle of the half-edge that ends where this one starts
  uint32_t circle;           // its own circle
  uint32_t next;             // the half-edge that starts where it ends
  uint32_t loop;
};

class VisiblePiece {
 public:
  void carve(Workspace &workspace, uint32_t neighbours);

  // block: the cubes around that of ball i.
  // Finds the front hemisphere of ball i outside the balls for which cuts(ball) is true.
  template <class Cuts>
  void cut_hemisphere(const BallSet &balls, const CubeBlock &block, const exact::Vector &direction, uint32_t i,
                      Cuts cuts) {
    if (!gather(balls, block, i)) return;
    caps_.keep_if(cuts);
    find_all(balls, direction);
  }
  // Finds the front part of the faces of ball i.
  void cut_faces(const BallSet &balls, const CubeBlock &block, const Boundary &boundary, const exact::Vector &direction,
                 uint32_t i);

  const Caps &caps() const { return caps_; }
  // The half-edges, with the piece on their left.
  Span<const PieceHalfEdge> half_edges() const { return half_edges_.part(0, half_edge_count_); }
  Span<const uint32_t> circles() const {
    return whole_.part(0, circle_count_);
  }  // caps whose circles are loops as a whole

 private:
  bool gather(const BallSet &balls, const CubeBlock &block, uint32_t i);
  void find_all(const BallSet &balls, const exact::Vector &direction);
  void add_front_of_faces(const Boundary &boundary);
  void link();

  Caps caps_;
  Span<exact::Plane> planes_;  // the planes of the caps; set when half-edges are linked
  VertexFinder finder_;
  FixedVector<VertexRecord> vertices_;
  FixedVector<CircleRecord> circles_;
  Span<PieceHalfEdge> half_edges_;
  HalfEdgeChain chain_;
  Span<uint32_t> whole_;
  uint32_t half_edge_count_ = 0;
  uint32_t circle_count_ = 0;
};

}  // namespace hsp
