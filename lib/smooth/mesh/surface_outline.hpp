// The questions of boundary_outline.hpp about the smooth surface: about the part of it that is measured. Corners and
// curves are those of SurfaceMap. Convex patches lie on balls, concave ones on the probe's sphere at a vertex; saddles
// are bands between them.
//
// Two vertices of the mesh must not be joined by edges in two patches, unless along a curve that these share. Bands
// join neighbouring points alone. A patch on a ball has no two points in common with another patch but along a curve.
// Pieces at vertices have points of creases in common: see BorderSample::other_patch.
#pragma once

#include "mesh/saddle_grids.hpp"

namespace hsp {

// Limits that nearly always suffice.
Status expected_mesh_limits(const MeshedSurface &from, double edge, MeshLimits &limits);

class SurfaceOutline : public SurfaceCurves {
 public:
  using SurfaceCurves::SurfaceCurves;

  // Balls, then vertices.
  uint32_t sphere_count() const { return ball_count() + boundary().vertex_count(); }
  uint32_t corner_count() const { return map().corner_count(); }
  bool divide_curves(double length, Patience &patience) {
    return divide(length, patience) && SaddleGrids(*this).fit(length, patience);
  }
  Status expected_limits(double edge, MeshLimits &limits) const;

  template <class Sink>
  void for_each_sphere(uint32_t c, Sink sink) const {
    for (uint32_t h = 2 * c; h < 2 * c + 2; ++h) {
      const SurfacePatch patch = map().patch(map().left(h));
      if (patch.kind == PatchKind::convex) sink(boundary().face(patch.source).ball);
      if (patch.kind == PatchKind::concave) sink(ball_count() + patch.source);
    }
  }

  bool has_patches(uint32_t sphere) const {
    return sphere < ball_count() ? faces().any(sphere)
                                 : surface().chosen().has(face_at_vertex(boundary(), sphere - ball_count()));
  }
  double spacing(uint32_t sphere, double edge) const;
  double steradians(uint32_t sphere) const;
  // Whether the concave patch of a vertex, if other probes may cut it, has less area than this on the unit sphere.
  bool has_next_to_no_area(uint32_t sphere, double least) const;
  void add_border(uint32_t sphere, SphericalPatch &patch) const;
  // A point inside a patch.
  MeshVertex inner_vertex(uint32_t sphere, const Vec3 &direction) const;
  uint32_t patch(uint32_t sphere, uint32_t face) const;
  PatchKind kind(uint32_t sphere) const { return sphere < ball_count() ? PatchKind::convex : PatchKind::concave; }
  // Of a triangle with this middle, the ball that the probe touches nearest to it.
  uint32_t ball_at(uint32_t sphere, const double (&middle)[3]) const;

  // The saddles. False if there are more triangles than any limit allows.
  bool add_bands(double length, Patience &patience, FixedVector<MeshVertex> &vertices,
                 FixedVector<MeshTriangle> &triangles) const {
    return SaddleGrids(*this).add_triangles(length, patience, vertices, triangles);
  }

 private:
  uint32_t ball_count() const { return balls().n; }
  void add_convex_border(uint32_t ball, SphericalPatch &patch) const;
  void add_concave_border(uint32_t vertex, SphericalPatch &patch) const;
  // The segments around a patch.
  double segments_around(uint32_t patch, double edge) const;
};

}  // namespace hsp
