#include "measure/arc_batches.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

// Doubles serve well-conditioned circles, rho^2 >= r^2/64 and d <= 4 r, and well-conditioned vertices, those of two
// such circles whose axes have an angle of sine s with s^2 >= 1/16. To first order, in units of e = 2^-53, with sigma =
// rho/r:
//   u               |v|^2 3, root 2.5, inverse 3.5, product                                         4.5
//   2 h             (4 d^2 + 2 * 2 |h| d) / d + 4.5 * 2 |h|                                          29 r
//   n = u x u'      2 * 4.5 + 3                                                                      12
//   q               2 (29 r + 5.5 * 2 r) + |q|, and |q| <= 2 r s                                     82 r
//   vertex          q 82/s, n 24/s twice, n.n 48/s + 8, root and roundings 34; |vertex| = 2 r       754 r
//   from the circle's centre, 2 rho away: 754 r + 29 r + 11 r + 2 r, as an angle                    400/sigma
//   angle of an arc both ends, and 50 for x, y and the arc tangent                                  850/sigma
//   exterior angle  (u.u' 12, h h'/r^2 33) over sigma sigma'                                         45/(sigma sigma')
// so the error is below 2^-43/sigma, and typically some e/sigma. This is negligible against branch_cut_margin: arcs at
// least that far from 0 and 2 pi are classified correctly.
constexpr double least_square_of_radius = 1.0 / 64;
constexpr double most_square_of_distance = 16.0;
constexpr double least_square_of_sine = 1.0 / 16;

// Whether a condition held in all lanes.
class AllLanes {
 public:
  void require(const LaneMask &mask) { ones_ = mask_and(mask, ones_); }
  explicit operator bool() const { return ones_[0] + ones_[1] == 2.0; }

 private:
  Lanes ones_{1.0, 1.0};
};

}  // namespace

ArcBatches::ArcBatches(const BallSet &balls, const Boundary &boundary, uint32_t ball, uint32_t face)
    : balls_(balls),
      boundary_(boundary),
      ball_(ball),
      x_(balls.x[ball]),
      y_(balls.y[ball]),
      z_(balls.z[ball]),
      r_(balls.r[ball]),
      face_(face),
      loops_(face == no_id ? boundary.loops(ball) : boundary.loops_of_face(face)),
      half_edges_(boundary.half_edges(ball)),
      circles_(boundary.circles(ball)) {}

bool ArcBatches::next() {
  gather();
  if (batch_.count == 0) return false;
  evaluate();
  return true;
}

// Advances to the next loop of half-edges: of a face in the order of its loops, of a ball in that of their first
// half-edges.
bool ArcBatches::find_loop() {
  if (face_ != no_id) {
    if (loops_.empty() || boundary_.loop_start(loops_.first).is_circle()) return false;
    start_ = boundary_.loop_start(loops_.first++).half_edge();
    return true;
  }
  for (const uint32_t e : half_edges_) {
    if (boundary_.loop_start(boundary_.half_edge(e).loop) != LoopElement::arc(e)) continue;
    start_ = e;
    half_edges_.first = e + 1;
    return true;
  }
  half_edges_.first = half_edges_.last;
  return false;
}

// Advances to the next circle, after the loops of half-edges.
bool ArcBatches::find_circle(ClosedHalfEdge &closed) {
  if (face_ != no_id) {
    if (loops_.empty()) return false;
    closed = boundary_.loop_start(loops_.first++).closed_half_edge();
    return true;
  }
  if (circle_ == circles_.size()) return false;
  closed = circles_[circle_++];
  return true;
}

void ArcBatches::gather() {
  const double *const xs = balls_.x.data();
  const double *const ys = balls_.y.data();
  const double *const zs = balls_.z.data();
  const double *const rs = balls_.r.data();
  const HalfEdge *const half_edges = boundary_.half_edge_data();
  const double *const roots = boundary_.root_discriminant_data();
  const double x = x_, y = y_, z = z_;
  uint32_t count = 0;
  const auto put = [&](const Slot &slot, double root_D) {
    const uint32_t c = count++;
    batch_.other[c] = slot.other;
    batch_.arc_half_edge[c] = slot.arc_half_edge;
    vertex_half_edge_[c] = slot.vertex_half_edge;
    arc_[c] = -static_cast<int64_t>(slot.arc_half_edge < ArcBatch::whole_circle);
    vertex_[c] = -static_cast<int64_t>(slot.vertex_half_edge != no_id);
    turns_[c] = -static_cast<int64_t>(slot.turns);
    batch_.ux[c] = xs[slot.other] - x;
    batch_.uy[c] = ys[slot.other] - y;
    batch_.uz[c] = zs[slot.other] - z;
    batch_.twice_height[c] = rs[slot.other];
    root_D_[c] = root_D;
  };
  const auto root_at = [&](uint32_t half_edge) { return roots[half_edges[half_edge].vertex]; };

  has_circles_ = false;
  for (uint32_t k = 0; k < held_count_; ++k) {
    put(held_[k], held_[k].vertex_half_edge == no_id ? 0.0 : root_at(held_[k].vertex_half_edge));
  }
  held_count_ = 0;
  while (count < ArcBatch::capacity) {
    if (stage_ == Stage::next_loop) {
      if (!find_loop()) {
        stage_ = Stage::circles;
        continue;
      }
      walk_ = start_;
      put({half_edges[start_].previous_circle, no_id, start_, true}, root_at(start_));
      stage_ = Stage::arcs;
    } else if (stage_ == Stage::arcs) {
      uint32_t u = walk_;
      do {
        const uint32_t following = half_edges[u].next;
        put({half_edges[u].circle, u, following, following != start_}, root_at(following));
        u = following;
      } while (u != start_ && count < ArcBatch::capacity);
      walk_ = u;
      if (u == start_) stage_ = Stage::closing;
    } else if (stage_ == Stage::closing) {
      put({half_edges[start_].circle, no_id, no_id, false}, 0.0);
      stage_ = Stage::next_loop;
    } else {
      ClosedHalfEdge closed;
      if (!find_circle(closed)) break;
      put({boundary_.neighbour(closed), ArcBatch::whole_circle, no_id, false}, 0.0);
      has_circles_ = true;
    }
  }
  batch_.count = count;
  // A loop that goes on: the last slot has no vertex yet, so that the last two come again.
  if (count == ArcBatch::capacity && (stage_ == Stage::arcs || stage_ == Stage::closing)) hold_back();
}

void ArcBatches::hold_back() {
  const uint32_t last = batch_.count - 1;
  held_[0] = {batch_.other[last - 1], no_id, vertex_half_edge_[last - 1], false};
  held_[1] = {batch_.other[last], batch_.arc_half_edge[last], vertex_half_edge_[last], turns_[last] != 0};
  held_count_ = 2;
  batch_.arc_half_edge[last] = no_id;
  vertex_half_edge_[last] = no_id;
  arc_[last] = vertex_[last] = turns_[last] = 0;
}

void ArcBatches::evaluate() {
  // Lanes beyond the last slot are computed along; they repeat its circle.
  const uint32_t last = batch_.count - 1;
  for (uint32_t c = batch_.count; c < batch_.count + lane_count; ++c) {
    batch_.other[c] = batch_.other[last];
    batch_.arc_half_edge[c] = no_id;
    batch_.ux[c] = batch_.ux[last];
    batch_.uy[c] = batch_.uy[last];
    batch_.uz[c] = batch_.uz[last];
    batch_.twice_height[c] = batch_.twice_height[last];
    batch_.inverse_distance[c] = 0.0;
    root_D_[c] = 0.0;
    vertex_half_edge_[c] = no_id;
    arc_[c] = vertex_[c] = turns_[c] = well_conditioned_circle_[c] = 0;
  }
  px_[0] = py_[0] = pz_[0] = 0.0;
  well_conditioned_vertex_[0] = 0;
  evaluate_circles();
  evaluate_vertices();
  evaluate_arcs();
}

void ArcBatches::circle_from_integers(uint32_t c) {
  const exact::LatticeBall own = balls_.ball(ball_);
  const exact::LatticeBall other = balls_.ball(batch_.other[c]);
  const exact::Plane P = exact::plane_of(own, other);
  const int64_t U = dot(P.v, P.v);
  const int64_t sum = own.radius + other.radius;
  const int64_t difference = own.radius - other.radius;
  batch_.twice_height[c] = static_cast<double>(P.h) * batch_.inverse_distance[c];
  batch_.touching[c] = U == sum * sum                 ? Touching::from_outside
                       : U == difference * difference ? Touching::from_inside
                                                      : Touching::no;
  batch_.any_touching = batch_.any_touching || batch_.touching[c] != Touching::no;
}

void ArcBatches::evaluate_circles() {
  const double inverse_diameter = r_ > 0.0 ? 0.5 / r_ : 0.0;
  AllLanes complete;
  for (uint32_t c = 0; c < batch_.count + 1; c += lane_count) {
    const LaneVector v = batch_.axis(c);
    const Lanes other_radius = load_lanes(&batch_.twice_height[c]);
    const Lanes U = dot(v, v);
    const Lanes inverse = 1.0 / square_root(U);
    const LaneVector u = inverse * v;
    const Lanes twice_height = (U + (r_ - other_radius) * (r_ + other_radius)) * inverse;
    const Lanes cosine = twice_height * inverse_diameter;
    const Lanes far = mask_and(U > most_square_of_distance * r_ * r_, all_lanes(1.0));
    const LaneMask well_conditioned = (1.0 - cosine) * (1.0 + cosine) >= least_square_of_radius + far;
    store_lanes(&batch_.ux[c], u.x);
    store_lanes(&batch_.uy[c], u.y);
    store_lanes(&batch_.uz[c], u.z);
    store_lanes(&batch_.inverse_distance[c], inverse);
    store_lanes(&batch_.twice_height[c], twice_height);
    store_mask(&well_conditioned_circle_[c], well_conditioned);
    complete.require(well_conditioned);
  }
  batch_.any_touching = false;
  if (complete) return;
  for (uint32_t c = 0; c < batch_.count + lane_count; ++c) batch_.touching[c] = Touching::no;
  for (uint32_t c = 0; c < batch_.count; ++c) {
    if (well_conditioned_circle_[c] == 0) circle_from_integers(c);
  }
}

void ArcBatches::vertex_from_integers(uint32_t c) {
  const exact::LatticeBall own = balls_.ball(ball_);
  const exact::Plane in = exact::plane_of(own, balls_.ball(batch_.other[c]));
  const exact::Plane out = exact::plane_of(own, balls_.ball(batch_.other[c + 1]));
  const Vec3 p = crossing_point(out, in, -1, root_D_[c]);
  px_[c + 1] = 2 * p.x;
  py_[c + 1] = 2 * p.y;
  pz_[c + 1] = 2 * p.z;
  if (turns_[c] != 0) turn_.add_angle(exterior_angle(root_D_[c], exact::sphere_of(own), out, in));
}

// A loop comes in along the circle u, h and leaves along u', h'. With n = u x u' and q = 2 h u' - 2 h' u twice the
// vertex is (q x n + sqrt(D)/(d d') n)/n.n, where q is orthogonal to n, so that q x n has no cancellation; and the loop
// turns there by the angle of (u.u' - h h'/r^2, sqrt(D)/(2 r d d')).
void ArcBatches::evaluate_vertices() {
  const double inverse_diameter = r_ > 0.0 ? 0.5 / r_ : 0.0;
  const double inverse_W = inverse_diameter * inverse_diameter;
  AllLanes complete;
  ExteriorAngleSum turn = turn_;
  for (uint32_t c = 0; c < batch_.count; c += lane_count) {
    const LaneVector u_in = batch_.axis(c);
    const LaneVector u_out = batch_.axis(c + 1);
    const Lanes h_in = load_lanes(&batch_.twice_height[c]);
    const Lanes h_out = load_lanes(&batch_.twice_height[c + 1]);
    const Lanes root = load_lanes(&root_D_[c]) *
                       (load_lanes(&batch_.inverse_distance[c]) * load_lanes(&batch_.inverse_distance[c + 1]));
    const CircleCrossing<LaneVector, Lanes> crossing(u_in, h_in, u_out, h_out);
    const LaneVector p = crossing.point(root);
    const LaneMask well_conditioned =
        mask_and(crossing.nn >= least_square_of_sine,
                 load_mask(&well_conditioned_circle_[c]) & load_mask(&well_conditioned_circle_[c + 1]));
    const LaneMask counted = well_conditioned & load_mask(&turns_[c]);
    turn.add_directions(select(counted, dot(u_in, u_out) - h_in * h_out * inverse_W, all_lanes(1.0)),
                        mask_and(counted, root * inverse_diameter));
    store_lanes(&px_[c + 1], p.x);
    store_lanes(&py_[c + 1], p.y);
    store_lanes(&pz_[c + 1], p.z);
    store_mask(&well_conditioned_vertex_[c + 1], well_conditioned);
    complete.require(well_conditioned | ~load_mask(&vertex_[c]));
  }
  turn_ = turn;
  turn_.rescale();
  if (complete) return;
  for (uint32_t c = 0; c + 1 < batch_.count; ++c) {
    if (well_conditioned_vertex_[c + 1] == 0 && vertex_[c] != 0) vertex_from_integers(c);
  }
}

void ArcBatches::evaluate_arcs() {
  AllLanes complete;
  for (uint32_t c = 0; c < batch_.count; c += lane_count) {
    const LaneVector u = batch_.axis(c);
    const LaneVector from{load_lanes(&px_[c]), load_lanes(&py_[c]), load_lanes(&pz_[c])};
    const LaneVector to{load_lanes(&px_[c + 1]), load_lanes(&py_[c + 1]), load_lanes(&pz_[c + 1])};
    // The loop runs clockwise, from q to p.
    const LaneVector centre = load_lanes(&batch_.twice_height[c]) * u;
    const LaneVector p = to - centre;
    const LaneVector q = from - centre;
    const LaneVector X = cross(from - to, u);
    const Lanes x = dot(p, q);
    const Lanes y = dot(p, X);  // u.(p x q)
    const LaneMask arc = load_mask(&arc_[c]);
    const LaneMask certain = arc & load_mask(&well_conditioned_vertex_[c]) &
                             load_mask(&well_conditioned_vertex_[c + 1]) & (absolute(y) >= branch_cut_margin * x);
    store_lanes(&batch_.angle[c],
                mask_and(certain, turn_angle(select(certain, x, all_lanes(1.0)), mask_and(certain, y))));
    store_lanes(&batch_.Xx[c], mask_and(arc, X.x));
    store_lanes(&batch_.Xy[c], mask_and(arc, X.y));
    store_lanes(&batch_.Xz[c], mask_and(arc, X.z));
    store_mask(&certain_[c], certain);
    complete.require(certain | ~arc);
  }
  if (complete && !has_circles_) return;
  for (uint32_t c = 0; c < batch_.count; ++c) {
    const uint32_t half_edge = batch_.arc_half_edge[c];
    if (half_edge == ArcBatch::whole_circle) {
      batch_.angle[c] = 2 * pi;
    } else if (arc_[c] != 0 && certain_[c] == 0) {
      batch_.angle[c] = angle_of(balls_, boundary_, ball_, half_edge);
    }
  }
}

}  // namespace hsp
