// The sphere of the probe at a vertex of the boundary, on which the concave patch of the smooth surface lies.
#pragma once

#include "mesh/mesh_curve.hpp"

namespace hsp {

class ProbeSphere {
 public:
  ProbeSphere(const BallSet &balls, const Boundary &boundary, uint32_t vertex)
      : balls_(balls), record_(boundary.vertex(vertex)), centre_(position_of_vertex(balls, boundary, vertex)) {}

  const Position &centre() const { return centre_; }
  // The way from a point to the centre, along the outward normal of the patch.
  Vec3 way_from(const Position &position) const { return difference(balls_, position, centre_); }
  // The ball that the probe touches nearest to where this direction from the centre leads; the first one in the
  // caller's order of several.
  uint32_t nearest_ball(const Vec3 &direction) const {
    uint32_t nearest = no_id;
    double most = 0.0;
    for (const uint32_t b : record_.ball) {
      const Vec3 arm = balls_.difference(centre_.ball, b) - centre_.offset;
      const double along = dot(direction, arm) / balls_.r[b];
      if (nearest != no_id && (along < most || (along == most && balls_.given_before(nearest, b)))) continue;
      nearest = b;
      most = along;
    }
    return nearest;
  }

 private:
  const BallSet &balls_;
  const VertexRecord &record_;
  const Position centre_;
};

}  // namespace hsp
