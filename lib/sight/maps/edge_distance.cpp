#include "maps/edge_distance.hpp"

#include "maps/edge_geometry.hpp"
#include "maps/trigonometric_roots.hpp"

namespace hsp {
namespace {

class EdgeDistance {
 public:
  EdgeDistance(const MapEdge &edge, double x, double y, NearestPoint &nearest)
      : edge_(edge), x_(x), y_(y), nearest_(nearest) {}

  void look_at_point(double x, double y) {
    const double dx = x - x_;
    const double dy = y - y_;
    const double squared = dx * dx + dy * dy;
    if (squared < nearest_.squared) nearest_ = {x, y, squared};
  }

  void look_at_circle(const SeenBall &ball) {
    const double dx = x_ - ball.x;
    const double dy = y_ - ball.y;
    const double squared = dx * dx + dy * dy;
    if (squared == 0.0) return;  // its ends are as near as all
    double t = arc_tangent(dy, dx);
    while (t >= edge_.from) t -= 2 * pi;
    while (t < edge_.from) t += 2 * pi;
    const double scale = ball.r / std::sqrt(squared);
    if (t <= edge_.to) look_at_point(ball.x + scale * dx, ball.y + scale * dy);
  }

  // Half the derivative of the squared distance is B cos t - A sin t - K sin t cos t, where A and B are the products of
  // the vector from the point to the centre with both semi-axes, and K the difference of the squares of these. At an
  // angle of pi / 4 less the product becomes a square: sin t cos t = cos^2 s - 1/2 for t = s + pi / 4.
  void look_at_ellipse(const EdgeEllipse &ellipse) {
    constexpr double eighth = 0.25 * pi, root_half = 0.7071067811865476;
    const double wx = ellipse.centre[0] - x_;
    const double wy = ellipse.centre[1] - y_;
    const double *const p = ellipse.first;
    const double *const q = ellipse.second;
    const double A = wx * p[0] + wy * p[1];
    const double B = wx * q[0] + wy * q[1];
    const double K = p[0] * p[0] + p[1] * p[1] - q[0] * q[0] - q[1] * q[1];
    const TrigonometricPolynomial slope{0.5 * K, root_half * (B - A), -root_half * (A + B), -K};
    double root[most_trigonometric_roots];
    const uint32_t count = find_roots(slope, edge_.from - eighth, edge_.to - eighth, root);
    for (uint32_t k = 0; k < count; ++k) {
      const SinCos t = sin_cos(root[k] + eighth);
      look_at_point(ellipse.x(t), ellipse.y(t));
    }
  }

 private:
  const MapEdge &edge_;
  double x_, y_;
  NearestPoint &nearest_;
};

}  // namespace

void look_at_edge(const VisibilityMap &map, uint32_t e, double x, double y, NearestPoint &nearest) {
  const MapEdge &edge = map.edges[e];
  const SeenBall &ball = map.balls[edge.ball];
  // The edge lies in the disc of that ball.
  const double dx = x - ball.x;
  const double dy = y - ball.y;
  const double from_disc = std::sqrt(dx * dx + dy * dy) - ball.r;
  if (from_disc > 0.0 && from_disc * from_disc > nearest.squared) return;
  EdgeDistance distance(edge, x, y, nearest);
  for (const uint32_t v : edge.vertex) distance.look_at_point(map.vertices[v].x, map.vertices[v].y);
  if (edge.is_silhouette()) {
    distance.look_at_circle(ball);
  } else {
    distance.look_at_ellipse(EdgeEllipse(map.balls, edge));
  }
}

}  // namespace hsp
