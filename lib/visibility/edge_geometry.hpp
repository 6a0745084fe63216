// Edges of a map in the view plane: points of an ellipse.
#pragma once

#include "visibility/curves.hpp"
#include "visibility/visibility_map.hpp"

namespace hsp {

// The points centre + cos t first + sin t second.
struct EdgeEllipse {
  double centre[2], first[2], second[2];

  EdgeEllipse(Span<const SeenBall> balls, const MapEdge &edge) {
    const SeenBall &ball = balls[edge.ball];
    if (edge.is_silhouette()) {
      set({ball.x, ball.y, ball.z}, {ball.r, 0.0, 0.0}, {0.0, ball.r, 0.0});
      return;
    }
    const Crease crease(ball, balls[edge.nearer]);
    set(crease.m, crease.rho * crease.a, crease.rho * crease.b);
  }

  double x(const SinCos &t) const { return centre[0] + first[0] * t.cosine + second[0] * t.sine; }
  double y(const SinCos &t) const { return centre[1] + first[1] * t.cosine + second[1] * t.sine; }

 private:
  void set(const Vec3 &m, const Vec3 &a, const Vec3 &b) {
    centre[0] = m.x;
    centre[1] = m.y;
    first[0] = a.x;
    first[1] = a.y;
    second[0] = b.x;
    second[1] = b.y;
  }
};

// Whether a loop runs around a point, by the parity of its crossings with a ray.
bool surrounds(const VisibilityMap &map, uint32_t loop, double x, double y);

}  // namespace hsp
