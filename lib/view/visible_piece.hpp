// The piece of one ball: the free part of its front hemisphere, as loops of uses of vertices. The half of the sphere
// behind the centre is one more cap, whose circle is the silhouette, so that everything is decided by the predicates of
// lib/exact and the vertex search of lib/boundary.
#pragma once

#include "boundary/boundary.hpp"
#include "sphere/vertex_finder.hpp"
#include "view/view_frame.hpp"

namespace hsp {

// The visit of a loop to a vertex, as VertexUse in lib/boundary, in terms of the indices of caps: it comes in along the
// circle of cap `in` and leaves along that of cap `out`, with the piece on its left.
struct PieceUse {
  uint32_t in, out;
  uint32_t next;  // the use at which the arc along `out` ends
  bool in_loop;
};

class FrontPiece {
 public:
  void carve(Workspace &workspace, uint32_t neighbours);

  // All take the block of cubes around the ball's own.
  // The front hemisphere of ball i outside the balls that cuts(ball) names.
  template <class Cuts>
  void cut_hemisphere(const BallSet &balls, const CubeBlock &block, const exact::Vector &direction, uint32_t i,
                      Cuts cuts) {
    if (!gather(balls, block, i)) return;
    caps_.keep_if(cuts);
    find_all(balls, direction);
  }
  // The front part of the faces of ball i.
  void cut_faces(const BallSet &balls, const CubeBlock &block, const BoundaryStructure &boundary,
                 const exact::Vector &direction, uint32_t i);

  const Caps &caps() const { return caps_; }
  Span<PieceUse> uses() const { return uses_.part(0, use_count_); }
  Span<uint32_t> circles() const { return whole_.part(0, circle_count_); }  // caps whose circles are loops as a whole

 private:
  bool gather(const BallSet &balls, const CubeBlock &block, uint32_t i);
  void find_all(const BallSet &balls, const exact::Vector &direction);
  void add_front_of_faces(const BoundaryStructure &boundary);
  void chain();

  Caps caps_;
  VertexFinder finder_;
  FixedVector<VertexRecord> vertices_;
  FixedVector<CircleRecord> circles_;
  Span<PieceUse> uses_;
  Span<uint32_t> whole_;
  uint32_t use_count_ = 0;
  uint32_t circle_count_ = 0;
};

}  // namespace hsp
