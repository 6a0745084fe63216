// The borders of the convex patches of one ball. They are triangulated by the directions of the probe's centre, seen
// from the ball: a ball that is nothing but a point has its patches, too.
#pragma once

#include "mesh/surface_curves.hpp"

namespace hsp {

class ConvexOutline {
 public:
  ConvexOutline(const SurfaceCurves &curves, uint32_t ball) : curves_(curves), ball_(ball) {}

  void add_border(SphericalPatch &patch) const;
  // A point inside a patch.
  MeshVertex inner_vertex(const Vec3 &direction) const {
    return vertex_on_ball(curves_.balls(), ball_, curves_.balls().r[ball_] - curves_.probe(), direction);
  }

 private:
  void add_loop(uint32_t loop, SphericalPatch &patch) const;
  void add_circle(uint32_t h, SphericalPatch &patch) const;
  void add_arc(uint32_t h, uint32_t corner, SphericalPatch &patch) const;

  const SurfaceCurves &curves_;
  uint32_t ball_;
};

}  // namespace hsp
