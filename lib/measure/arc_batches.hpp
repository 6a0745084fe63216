// The free arcs and circles on one ball in batches: the terms of areas, vector areas and derivatives. Their order is
// that of the half-edges, which does not depend on ids, so neither do the bits of sums.
//
// A batch is a row of slots. A loop of m arcs fills m + 2 of them: the circle before its first half-edge, the circle of
// every half-edge, and the first of these again. Slot c holds circle c, the vertex between
// circles c and c + 1, and the arc on circle c, between vertices c - 1 and c:
//
//   slot       0     1     2          m    m + 1
//   circle    c_m   c_1   c_2   ...  c_m   c_1
//   vertex    v_1   v_2   v_3   ...  v_1
//   arc             a_1   a_2   ...  a_m
//
// Slots without an arc have angle 0 and X 0, so that sums may run over all of them. Two slots are computed at once in
// doubles; ill-conditioned slots fall back to the exact integers of sphere/arc_geometry.hpp.
#pragma once

#include "boundary/boundary.hpp"
#include "measure/exterior_angles.hpp"

namespace hsp {

// Two spheres that touch meet in a circle of radius 0, exactly known from integers.
enum class Touching : uint8_t { no, from_outside, from_inside };

// The arcs of two slots with their circles: the unit vector u from the ball's centre to the other ball's, the inverse
// of the distance of the two, twice the height of the circle's plane along u; the arc's angle, and X = 2 (q - p) x u,
// with its ends p and q such that it runs from p to q counter-clockwise about u.
struct ArcLanes {
  LaneVector axis;
  Lanes inverse_distance, twice_height, angle;
  LaneVector X;
};

struct ArcBatch {
  static constexpr uint32_t capacity = 16;  // even; the rest of a longer loop goes into the next batch
  static constexpr uint32_t room = capacity + lane_count;
  static constexpr uint32_t whole_circle = no_id - 1;

  uint32_t count = 0;
  bool any_touching = false;  // touching[] holds something only if it is set
  double ux[room], uy[room], uz[room], inverse_distance[room], twice_height[room];
  double angle[room], Xx[room], Xy[room], Xz[room];
  uint32_t other[room];          // the other ball
  uint32_t arc_half_edge[room];  // the half-edge of the arc, whole_circle, or no_id
  Touching touching[room];

  LaneVector axis(uint32_t c) const { return {load_lanes(&ux[c]), load_lanes(&uy[c]), load_lanes(&uz[c])}; }
  ArcLanes lanes(uint32_t c) const {
    return {axis(c),
            load_lanes(&inverse_distance[c]),
            load_lanes(&twice_height[c]),
            load_lanes(&angle[c]),
            {load_lanes(&Xx[c]), load_lanes(&Xy[c]), load_lanes(&Xz[c])}};
  }
};

class ArcBatches {
 public:
  // The arcs and circles of the given face, or of all faces if it is no_id.
  ArcBatches(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t face = no_id);

  // Fills and evaluates the next batch; false if there is none.
  bool next();
  const ArcBatch &batch() const { return batch_; }

  // The sum of the angles by which the loops turn at their vertices, in all batches so far.
  double exterior_angle_sum() const { return turn_.total(); }

 private:
  struct Slot {
    uint32_t other;
    uint32_t arc_half_edge, vertex_half_edge;  // no_id if there is none
    bool turns;                                // the vertex counts for exterior_angle_sum()
  };
  enum class Stage : uint8_t { next_loop, arcs, closing, circles };

  void gather();
  bool find_loop();
  bool find_circle(ClosedHalfEdge &closed);
  void hold_back();
  void evaluate();
  void evaluate_circles();
  void evaluate_vertices();
  void evaluate_arcs();
  void circle_from_integers(uint32_t c);
  void vertex_from_integers(uint32_t c);

  const BallSet &balls_;
  const Boundary &boundary_;
  const uint32_t ball_;
  const double x_, y_, z_, r_;
  const uint32_t face_;
  ExteriorAngleSum turn_;
  ArcBatch batch_;

  // Where the gathering is.
  Stage stage_ = Stage::next_loop;
  IdRange loops_;       // of the face that are left
  IdRange half_edges_;  // of the ball that are left
  Span<const ClosedHalfEdge> circles_;
  uint32_t circle_ = 0;
  uint32_t start_ = no_id, walk_ = no_id;  // the first use of the loop, and the one that is next
  Slot held_[2] = {};                      // slots of the last batch that come again
  uint32_t held_count_ = 0;
  bool has_circles_ = false;  // in this batch

  // Of the slots. Masks are -1 where they hold. Vertex c is at index c + 1 of its place, twice the vector from the
  // ball's centre, and of well_conditioned_vertex_; the conditions for plain are in arc_batches.cpp.
  uint32_t vertex_half_edge_[ArcBatch::room];
  int64_t arc_[ArcBatch::room], vertex_[ArcBatch::room], turns_[ArcBatch::room];
  int64_t well_conditioned_circle_[ArcBatch::room], well_conditioned_vertex_[ArcBatch::room], certain_[ArcBatch::room];
  double root_D_[ArcBatch::room];
  double px_[ArcBatch::room], py_[ArcBatch::room], pz_[ArcBatch::room];
};

}  // namespace hsp
