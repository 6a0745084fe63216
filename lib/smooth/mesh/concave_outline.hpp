// The borders of the concave patch of one vertex, or of the pieces that other probes leave of it. They are triangulated
// by their outward normals, which point to the probe's centre.
#pragma once

#include "mesh/surface_curves.hpp"

namespace hsp {

class ConcaveOutline {
 public:
  ConcaveOutline(const SurfaceCurves &curves, uint32_t vertex)
      : curves_(curves), vertex_(vertex), sphere_(curves.balls(), curves.boundary(), vertex) {}

  void add_border(SphericalPatch &patch) const;
  // A point inside a patch.
  MeshVertex inner_vertex(const Vec3 &direction) const;
  // The ball that the probe touches nearest to a point.
  uint32_t ball_at(const double (&point)[3]) const;

 private:
  void add_loop(uint32_t loop, SphericalPatch &patch) const;
  void add_corner(uint32_t corner, uint32_t curve, SphericalPatch &patch) const;
  void add_crease(uint32_t h, uint32_t first, SphericalPatch &patch) const;
  void add_side(uint32_t h, SphericalPatch &patch) const;
  void keep_off_sides(SphericalPatch &patch) const;
  void keep_off_probes(SphericalPatch &patch) const;

  const SurfaceCurves &curves_;
  uint32_t vertex_;
  const ProbeSphere sphere_;
};

}  // namespace hsp
