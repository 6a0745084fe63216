// Fills batches of arcs, loop by loop.
//
// As an example a ball with one loop of two half-edges, on the circles of balls 1 and 2:
//   slot        0    1
//   other       1    2           the ball of the circle
//   next        1    0
//   previous    1    0
// A loop of 40 half-edges does not fit into 32 slots. The first batch has slot 0 for the circle before it, arcs in
// slots 1 to 30, and slot 31 for the circle after them; the second one has the other ten arcs, in slots 1 to 10.
#include "measure/arc_batches.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {

bool ArcBatches::fill() {
  batch_.count = 0;
  if (fits_) {
    gather_whole_ball();
    finished_ = true;
  } else if (is_single_) {
    gather_element();
    finished_ = true;
  } else {
    gather_loops();
  }
  first_circle_ = batch_.count;
  put_circles();
  if (batch_.count == 0) return false;
  pad();
  return true;
}

void ArcBatches::evaluate() {
  const bool complete = evaluate_arcs(boundary_.target(), ball_of_set(balls_, ball_), batch_);
  for (uint32_t s = first_circle_; s < batch_.count; ++s) batch_.angle[s] = 2 * pi;
  batch_.any_touching = false;
  if (!complete) complete_from_integers();
}

// Fills the next slot: a circle, and a half-edge on it or none.
void ArcBatches::put(uint32_t other, double root_discriminant, uint32_t half_edge) {
  const uint32_t s = batch_.count++;
  batch_.other[s] = other;
  half_edge_[s] = half_edge;
  batch_.root_discriminant[s] = root_discriminant;
  batch_.previous[s] = s > 0 ? s - 1 : s;
  batch_.next[s] = s + 1;
  batch_.arc[s] = -static_cast<int64_t>(half_edge != no_id);
}

// All half-edges of the ball, each in the slot of its number among them.
void ArcBatches::gather_whole_ball() {
  const HalfEdge *const half_edges = boundary_.half_edge_data() + half_edges_.first;
  const double *const roots = boundary_.root_discriminant_data();
  const uint32_t first = half_edges_.first;
  const uint32_t count = half_edges_.size();
  for (uint32_t s = 0; s < count; ++s) {
    const HalfEdge &half_edge = half_edges[s];
    const uint32_t next = half_edge.next - first;
    batch_.other[s] = half_edge.circle;
    batch_.root_discriminant[s] = roots[half_edge.vertex];
    batch_.next[s] = next;
    batch_.previous[next] = s;
    batch_.arc[s] = -1;
  }
  batch_.count = count;
  half_edges_.first = half_edges_.last;
}

// Advances to the next loop of half-edges: of a face in the order of its loops, of a ball in that of their first
// half-edges.
bool ArcBatches::find_loop() {
  if (face_ != no_id) {
    if (loops_.empty() || boundary_.loop_start(loops_.first).is_circle()) {
      half_edges_.first = half_edges_.last;
      return false;
    }
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

// Gathers loop after loop, as many half-edges as there is room for.
void ArcBatches::gather_loops() {
  // A half-edge needs a slot of its own, one before it and one after it.
  while (batch_.count + 3 <= ArcBatch::capacity) {
    if (walk_ == no_id) {
      if (!find_loop()) return;
      walk_ = start_;
    }
    put(boundary_.previous_circle(ball_, boundary_.half_edge(walk_)), 0.0);
    do {
      put(boundary_.half_edge(walk_).circle, root_at(walk_), walk_);
      walk_ = boundary_.half_edge(walk_).next;
    } while (walk_ != start_ && batch_.count + 1 < ArcBatch::capacity);
    put(boundary_.half_edge(walk_).circle, root_at(walk_));
    if (walk_ == start_) walk_ = no_id;
  }
}

// An arc, with the slots before and after it. A circle becomes the only loop that is left.
void ArcBatches::gather_element() {
  if (element_.is_circle()) {
    loops_ = {boundary_.loop_of(element_), boundary_.loop_of(element_) + 1};
    return;
  }
  const uint32_t e = element_.half_edge();
  const HalfEdge &half_edge = boundary_.half_edge(e);
  put(boundary_.previous_circle(ball_, half_edge), 0.0);
  put(half_edge.circle, root_at(e), e);
  put(boundary_.half_edge(half_edge.next).circle, root_at(half_edge.next));
}

// After the loops of half-edges: circles, as many as there is room for.
void ArcBatches::put_circles() {
  if (walk_ != no_id || !half_edges_.empty()) return;
  if (face_ == no_id) {
    while (circle_ < circles_.size() && batch_.count < ArcBatch::capacity) {
      put(boundary_.neighbour(circles_[circle_++]), 0.0);
    }
    return;
  }
  while (!loops_.empty() && batch_.count < ArcBatch::capacity) {
    put(boundary_.neighbour(boundary_.loop_start(loops_.first++)), 0.0);
  }
}

// Lanes beyond the last slot are computed, too. They repeat its circle, and no slot leads behind the last one, where
// nothing has been written.
void ArcBatches::pad() {
  const uint32_t last = batch_.count - 1;
  if (batch_.next[last] > last) batch_.next[last] = last;
  for (uint32_t s = batch_.count; s < batch_.count + sum_lanes - 1; ++s) {
    batch_.other[s] = batch_.other[last];
    batch_.root_discriminant[s] = 0.0;
    batch_.previous[s] = last;
    batch_.next[s] = last;
    batch_.arc[s] = 0;
  }
}

void ArcBatches::complete_from_integers() {
  const uint32_t count = batch_.count;
  const auto is_missing = [](double x) { return x != x; };
  for (uint32_t s = 0; s < count; ++s) {
    batch_.touching[s] = Touching::no;
    if (is_missing(batch_.twice_height[s])) circle_from_integers(s);
  }
  for (uint32_t s = 0; s < count; ++s) {
    if (batch_.arc[s] == 0 || !is_missing(batch_.px[s])) continue;
    vertex_from_integers(s);
    batch_.exterior_angles += exterior_angle(batch_.root_discriminant[s], exact::sphere_of(balls_.ball(ball_)),
                                             plane(batch_.other[s]), plane(batch_.other[batch_.previous[s]]));
  }
  for (uint32_t s = 0; s < count; ++s) {
    if (batch_.arc[s] != 0 && is_missing(batch_.px[batch_.next[s]])) vertex_from_integers(batch_.next[s]);
  }
  // Most arcs that lacked only a vertex are well-conditioned.
  complete_arcs(boundary_.target(), batch_);
  for (uint32_t s = 0; s < count; ++s) {
    if (batch_.arc[s] != 0 && is_missing(batch_.angle[s])) arc_from_integers(s);
  }
  for (uint32_t s = count; s < count + sum_lanes - 1; ++s) batch_.twice_height[s] = batch_.twice_height[count - 1];
}

void ArcBatches::circle_from_integers(uint32_t s) {
  const exact::LatticeBall own = balls_.ball(ball_);
  const exact::LatticeBall other = balls_.ball(batch_.other[s]);
  const exact::Plane P = exact::plane_of(own, other);
  const int64_t U = dot(P.v, P.v);
  const int64_t sum = own.radius + other.radius;
  batch_.twice_height[s] = static_cast<double>(P.h) * batch_.inverse_distance[s];
  batch_.touching[s] = U == sum * sum ? Touching::yes : Touching::no;
  batch_.any_touching = batch_.any_touching || batch_.touching[s] != Touching::no;
}

void ArcBatches::vertex_from_integers(uint32_t s) {
  const Vec3 p =
      crossing_point(plane(batch_.other[s]), plane(batch_.other[batch_.previous[s]]), -1, batch_.root_discriminant[s]);
  batch_.px[s] = 2 * p.x;
  batch_.py[s] = 2 * p.y;
  batch_.pz[s] = 2 * p.z;
}

void ArcBatches::arc_from_integers(uint32_t s) {
  const uint32_t end = batch_.next[s];
  const Vec3 chord{batch_.px[s] - batch_.px[end], batch_.py[s] - batch_.py[end], batch_.pz[s] - batch_.pz[end]};
  const Vec3 X = cross(chord, {batch_.ux[s], batch_.uy[s], batch_.uz[s]});
  batch_.Xx[s] = X.x;
  batch_.Xy[s] = X.y;
  batch_.Xz[s] = X.z;
  batch_.angle[s] = angle_of(balls_, boundary_, ball_, half_edge(s));
}

}  // namespace hsp
