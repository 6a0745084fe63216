// Walks along the boundary loops of one ball, for everything that is summed over its free arcs and circles: areas,
// vector areas, derivatives. The order of the walks follows from the order of the uses, which does not depend on ids,
// so neither do the bits of the sums.
//
// Vertices and angles come from doubles where these are sure to be good, and else from the exact integers of
// arc_angles.hpp.
#pragma once

#include "measure/arc_angles.hpp"
#include "measure/areas.hpp"
#include "measure/circle_geometry.hpp"
#include "measure/loop_turn.hpp"

namespace hsp {

class LoopWalk {
 public:
  LoopWalk(const BallSet &balls, const BoundaryStructure &boundary, uint32_t ball)
      : balls_(balls),
        boundary_(boundary),
        ball_(ball),
        origin_(balls, ball),
        W_(4 * origin_.radius * origin_.radius),
        scale_(W_ > 0.0 ? 1.0 / W_ : 0.0) {}

  const CircleOrigin &origin() const { return origin_; }

  // Calls on_arc(circle, angle, X) for every arc of every loop of the given face, or of all faces if it is no_id. From
  // its end p to its end q the arc runs counter-clockwise about the circle's axis u, and X = 2 (q - p) x u. A free
  // circle is an arc of 2 pi with X = 0. Returns the sum of the angles by which the loops turn at their vertices.
  template <class OnArc>
  double visit(uint32_t face, OnArc on_arc) const {
    double exteriors = 0.0;
    uint32_t loop = boundary_.first_loop[ball_];
    for (uint32_t u = boundary_.first_use[ball_]; u < boundary_.first_use[ball_ + 1]; ++u) {
      if (boundary_.uses[u].loop != loop) continue;  // loops are numbered by their first uses
      if (face == no_id || boundary_.loop_face[loop] == face) exteriors += walk(u, on_arc);
      ++loop;
    }
    for (uint32_t s = boundary_.first_circle_side[ball_]; s < boundary_.first_circle_side[ball_ + 1]; ++s) {
      const uint32_t side = boundary_.circle_side[s] % 2;
      const CircleRecord &record = boundary_.circles[boundary_.circle_side[s] / 2];
      if (face != no_id && boundary_.loop_face[record.loop[side]] != face) continue;
      on_arc(origin_.circle(balls_, record.ball[1 - side]), 2 * pi, exact::DoubleVector{0.0, 0.0, 0.0});
    }
    return exteriors;
  }

 private:
  struct Vertex {
    exact::DoubleVector place;  // twice the vector from the ball's centre
    bool plain;
  };

  exact::Plane plane(uint32_t other) const { return exact::plane_of(origin_.ball, balls_.ball(other)); }

  // The vertex where a loop comes in along one circle and leaves along another: with n = v_in x v_out, N = n.n and
  // q = h_in v_out - h_out v_in it is (q x n + sqrt(D) n)/N, and the loop turns there by the angle of
  // (W v_in.v_out - h_in h_out, 2 r sqrt(D)).
  Vertex vertex(const VertexUse &use, const Circle &in, const Circle &out, LoopTurn &turn) const {
    const double root_D = boundary_.root_discriminant[use.vertex];
    const exact::DoubleVector n = exact::to_double(exact::cross(in.v, out.v));
    const double N = exact::dot(n, n);
    const double inverse_distances = in.inverse_distance * out.inverse_distance;
    // The sine of the angle between the axes is at least 1/8.
    if (in.plain && out.plain && N * (inverse_distances * inverse_distances) >= 1.0 / 64) [[likely]] {
      const exact::DoubleVector q = exact::combine(in.h, exact::to_double(out.v), -out.h, exact::to_double(in.v));
      const exact::DoubleVector p = exact::combine(1.0, exact::cross(q, n), root_D, n);
      const double inverse = 1.0 / N;
      const double scale = scale_ * inverse_distances;
      turn.add_direction((W_ * static_cast<double>(exact::dot(in.v, out.v)) - in.h * out.h) * scale,
                         2 * origin_.radius * root_D * scale);
      return {{p.x * inverse, p.y * inverse, p.z * inverse}, true};
    }
    double offset[3];
    vertex_offset(plane(use.out), plane(use.in), -1, root_D, offset);
    turn.add_angle(exterior_angle(root_D, exact::sphere_of(origin_.ball), plane(use.out), plane(use.in)));
    return {{2 * offset[0], 2 * offset[1], 2 * offset[2]}, false};
  }

  // The arc that the loop walks clockwise from q to p, leaving from a use.
  template <class OnArc>
  void arc(uint32_t use, const Circle &circle, const Vertex &from, const Vertex &to, OnArc &on_arc) const {
    const double along = 2 * circle.height;
    const exact::DoubleVector q = exact::combine(1.0, from.place, -along, circle.axis);
    const exact::DoubleVector p = exact::combine(1.0, to.place, -along, circle.axis);
    const exact::DoubleVector X = exact::cross(exact::combine(1.0, q, -1.0, p), circle.axis);
    const double x = exact::dot(p, q);
    const double y = exact::dot(p, X);  // u.(p x q)
    constexpr double near_the_cut = 0x1p-20;
    const bool sure = from.plain && to.plain && !(x > 0.0 && std::fabs(y) < near_the_cut * x);
    double angle;
    if (sure) [[likely]] {
      angle = turn_angle(x, y);
    } else {
      angle = arc_angle(balls_, boundary_, ball_, use);
    }
    on_arc(circle, angle, X);
  }

  template <class OnArc>
  double walk(uint32_t start, OnArc &on_arc) const {
    LoopTurn turn;
    const VertexUse &first_use = boundary_.uses[start];
    const Circle first = origin_.circle(balls_, first_use.in);
    Circle room[2];  // the circles before and after a vertex
    room[0] = origin_.circle(balls_, first_use.out);
    const Circle *in = &room[0];
    uint32_t free_room = 1;
    const Vertex first_vertex = vertex(first_use, first, room[0], turn);
    Vertex from = first_vertex;
    uint32_t left = start;
    for (uint32_t u = first_use.next;; u = boundary_.uses[u].next) {
      Vertex to = first_vertex;
      const Circle *out = nullptr;
      if (u != start) {
        const VertexUse &use = boundary_.uses[u];
        out = &first;
        if (use.next != start) {
          room[free_room] = origin_.circle(balls_, use.out);
          out = &room[free_room];
          free_room ^= 1U;
        }
        to = vertex(use, *in, *out, turn);
      }
      arc(left, *in, from, to, on_arc);
      if (u == start) break;
      in = out;
      from = to;
      left = u;
    }
    return turn.total();
  }

  const BallSet &balls_;
  const BoundaryStructure &boundary_;
  const uint32_t ball_;
  const CircleOrigin origin_;
  const double W_, scale_;
};

}  // namespace hsp
