// The free arcs and circles on one ball in batches: each arc has a term in areas, vector areas and derivatives. Arcs
// are in the order of the half-edges, which does not depend on ids, so the bits of sums do not either. Kernels evaluate
// them in doubles, several slots at once; ill-conditioned slots are evaluated by the exact integers of
// sphere/arc_geometry.hpp.
#pragma once

#include "boundary/boundary.hpp"
#include "measure/arc_sums.hpp"

namespace hsp {

// One ball for kernels.
inline BallOfSet ball_of_set(const BallSet &balls, uint32_t i) {
  return {balls.x.data(), balls.y.data(), balls.z.data(), balls.r.data(),
          balls.x[i],     balls.y[i],     balls.z[i],     balls.r[i]};
}

class ArcBatches {
 public:
  // The arcs and circles of the given face, or of all faces of the ball if `face` is no_id.
  ArcBatches(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t face = no_id)
      : balls_(balls),
        boundary_(boundary),
        ball_(ball),
        face_(face),
        half_edges_(boundary.half_edges(ball)),
        circles_(boundary.circles(ball)),
        loops_(face == no_id ? boundary.loops(ball) : boundary.loops_of_face(face)),
        first_(half_edges_.first),
        fits_(face == no_id && half_edges_.size() + circles_.size() <= ArcBatch::capacity) {}
  // One arc or circle alone.
  ArcBatches(const BallSet &balls, const Boundary &boundary, LoopElement element)
      : ArcBatches(balls, boundary, boundary.ball_of(element), boundary.face_of(element)) {
    half_edges_ = loops_ = {0, 0};
    element_ = element;
    is_single_ = true;
  }

  // Fills and evaluates the next batch; false if there is none.
  bool next() {
    if (!gather()) return false;
    evaluate();
    return true;
  }
  // The two steps of next(). Between them batch().other is known, and the caller may put further data into the batch:
  // the processor fetches these from memory while the batch is evaluated.
  bool gather() { return !finished_ && fill(); }
  void evaluate();
  const ArcBatch &batch() const { return batch_; }
  ArcBatch &batch() { return batch_; }

  // The half-edge of slot s, which has an arc.
  uint32_t half_edge(uint32_t s) const { return fits_ ? first_ + s : half_edge_[s]; }

 private:
  bool fill();
  void gather_whole_ball();
  void gather_loops();
  void gather_element();
  bool find_loop();
  void put(uint32_t other, double root_discriminant, uint32_t half_edge = no_id);
  double root_at(uint32_t half_edge) const {
    return boundary_.root_discriminant(boundary_.half_edge(half_edge).vertex);
  }
  void put_circles();
  void pad();
  // Few slots are ill-conditioned.
  [[gnu::cold]] void complete_from_integers();
  void circle_from_integers(uint32_t s);
  void vertex_from_integers(uint32_t s);
  void arc_from_integers(uint32_t s);
  exact::Plane plane(uint32_t other) const { return exact::plane_of(balls_.ball(ball_), balls_.ball(other)); }

  const BallSet &balls_;
  const Boundary &boundary_;
  const uint32_t ball_, face_;

  // The arcs that are left to be gathered.
  IdRange half_edges_;                     // of the ball
  Span<const ClosedHalfEdge> circles_;     // all circles of the ball
  IdRange loops_;                          // of the face
  uint32_t circle_ = 0;                    // the next one of circles_
  uint32_t first_circle_ = 0;              // the first slot of the batch with a circle
  uint32_t start_ = no_id, walk_ = no_id;  // the first half-edge of the loop, and the next one; no_id between loops
  bool finished_ = false;
  bool is_single_ = false;
  LoopElement element_;  // the arc or circle, if it is a single one

  const uint32_t first_;  // the first half-edge of the ball
  const bool fits_;       // whether all that the ball has fits into one batch
  ArcBatch batch_;
  uint32_t half_edge_[ArcBatch::room];  // of the slots, unless all fit
};

}  // namespace hsp
