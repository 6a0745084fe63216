// The borders of the convex patches of one ball. They are triangulated by the directions of the probe's centre, seen
// from the ball: a ball that is nothing but a point has its patches, too.
#pragma once

#include "mesh/boundary_outline.hpp"
#include "mesh/surface_curves.hpp"

namespace hsp {

class ConvexOutline {
 public:
  ConvexOutline(const SurfaceCurves &curves, const MeshedFaces &faces, uint32_t ball)
      : curves_(curves), faces_(faces), ball_(ball) {}

  void add_border(SphericalPatch &patch) const;
  // A point inside a patch.
  MeshVertex inner_vertex(const Vec3 &direction) const;

 private:
  void add_loop(uint32_t loop, SphericalPatch &patch) const;
  void add_circle(uint32_t h, SphericalPatch &patch) const;
  void add_arc(uint32_t h, uint32_t corner, SphericalPatch &patch) const;

  const SurfaceCurves &curves_;
  const MeshedFaces &faces_;
  uint32_t ball_;
};

}  // namespace hsp
