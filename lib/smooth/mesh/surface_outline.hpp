// The questions of a mesh to the smooth surface, to the part of it that is measured (boundary_outline.hpp). Corners and
// curves are those of SurfaceMap. Convex patches lie on balls, concave ones on the probe's sphere at a vertex; saddles
// are bands between them.
//
// No two patches join the same points twice but along a shared edge: bands join neighbours alone, patches on balls
// share no two points of theirs with others but along an edge, and pieces at vertices share their creases' points.
#pragma once

#include "mesh/concave_outline.hpp"
#include "mesh/convex_outline.hpp"
#include "mesh/saddle_grids.hpp"
#include "mesh/surface_vertices.hpp"

namespace hsp {

// Limits that nearly always suffice, as for a boundary.
Status expected_mesh_limits(const BallSet &balls, const Boundary &boundary, const Surface &surface, double edge,
                            MeshLimits &limits);

class SurfaceOutline {
 public:
  // The surface must be closed, and its probe is not 0.
  SurfaceOutline(const BallSet &balls, const Boundary &boundary, const Surface &surface, Span<MeshCurve> curves)
      : curves_(balls, boundary, surface, curves), faces_(boundary, &surface.chosen()), vertices_(curves_, faces_) {}
  SurfaceOutline(const SurfaceOutline &) = delete;
  SurfaceOutline &operator=(const SurfaceOutline &) = delete;

  // Balls, then vertices.
  uint32_t sphere_count() const { return balls() + curves_.boundary().vertex_count(); }
  uint32_t corner_count() const { return map().corner_count(); }
  uint32_t curve_count() const { return curves_.count(); }
  MeshCurve &curve(uint32_t c) { return curves_.curve(c); }
  bool divide_curves(double length, Patience &patience) {
    return curves_.divide(length, patience) && SaddleGrids(curves_).fit(length, patience);
  }
  Status expected_limits(double edge, MeshLimits &limits) const;

  MeshVertex corner(uint32_t id) const { return vertices_.corner(id); }
  void add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const { vertices_.add_samples(c, vertices); }
  bool is_too_fine(uint32_t c) const { return curves_.is_too_fine(c); }
  uint32_t partner(uint32_t c) const { return curves_.partner(c); }
  template <class Sink>
  void for_each_sphere(uint32_t c, Sink sink) const {
    for (uint32_t h = 2 * c; h < 2 * c + 2; ++h) {
      const SurfacePatch patch = map().patch(map().left(h));
      if (patch.kind == PatchKind::convex) sink(curves_.boundary().face(patch.source).ball);
      if (patch.kind == PatchKind::concave) sink(balls() + patch.source);
    }
  }

  bool has_patches(uint32_t sphere) const {
    return sphere < balls() ? faces_.any(sphere) : faces_.has(face_at_vertex(curves_.boundary(), sphere - balls()));
  }
  double spacing(uint32_t sphere, double edge) const;
  double steradians(uint32_t sphere) const;
  // A patch that others may cut has less area than this, on the unit sphere.
  bool has_next_to_no_area(uint32_t sphere, double least) const;
  void add_border(uint32_t sphere, SphericalPatch &patch) const;
  MeshVertex inner_vertex(uint32_t sphere, const Vec3 &direction) const;
  uint32_t patch(uint32_t sphere, uint32_t face) const;
  PatchKind kind(uint32_t sphere) const { return sphere < balls() ? PatchKind::convex : PatchKind::concave; }
  // Of a triangle with this middle.
  uint32_t ball_at(uint32_t sphere, const double (&middle)[3]) const;

  // The saddles. False if there are more triangles than any limit allows.
  bool add_bands(double length, Patience &patience, FixedVector<MeshVertex> &vertices,
                 FixedVector<MeshTriangle> &triangles) const {
    return SaddleGrids(curves_).add_triangles(length, patience, vertices, triangles);
  }

 private:
  uint32_t balls() const { return curves_.balls().n; }
  const SurfaceMap &map() const { return curves_.map(); }
  ConvexOutline on_ball(uint32_t ball) const { return {curves_, faces_, ball}; }
  ConcaveOutline on_probe(uint32_t sphere) const { return {curves_, sphere - balls()}; }
  // The segments around a patch.
  double segments_around(uint32_t patch, double edge) const;

  SurfaceCurves curves_;
  const MeshedFaces faces_;
  const SurfaceVertices vertices_;
};

}  // namespace hsp
