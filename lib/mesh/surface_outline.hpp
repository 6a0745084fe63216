// What a mesh asks of the smooth surface, of the part of it that is measured (boundary_outline.hpp). Corners and curves
// are those of SurfaceMap. Convex patches lie on balls, concave ones on the probe's sphere at a vertex; on both a patch
// is triangulated by its outward normals. Saddles are bands of equal numbers of points on opposite edges.
//
// No two patches join the same points twice but along a shared edge: bands join neighbours alone, patches on balls
// share no two points of theirs with others but along an edge, and pieces at vertices share their creases' points.
#pragma once

#include "mesh/boundary_outline.hpp"
#include "mesh/saddle_band.hpp"

namespace hsp {

// Limits that nearly always suffice, as for a boundary. Status::check if the surface is not closed.
Status expected_mesh_limits(const BallSet &balls, const Boundary &boundary, const Surface &surface, double edge,
                            MeshLimits &limits);

class SurfaceOutline {
 public:
  // The surface must be closed, and its probe is not 0.
  SurfaceOutline(const BallSet &balls, const Boundary &boundary, const Surface &surface, Span<MeshCurve> curves)
      : balls_(balls),
        boundary_(boundary),
        surface_(surface),
        map_(balls, boundary, surface),
        faces_(boundary, &surface.chosen()),
        curve_(curves) {}

  // Balls, then vertices.
  uint32_t sphere_count() const { return balls_.n + boundary_.vertex_count(); }
  uint32_t corner_count() const { return map_.corner_count(); }
  uint32_t curve_count() const { return map_.edge_count(); }
  MeshCurve &curve(uint32_t c) { return curve_[c]; }
  bool divide_curves(double length);
  Status expected_limits(double edge, MeshLimits &limits) const;

  MeshVertex corner(uint32_t id) const;
  void add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const;
  bool is_too_fine(uint32_t c) const;
  uint32_t partner(uint32_t c) const;
  template <class Sink>
  void for_each_sphere(uint32_t c, Sink sink) const {
    for (uint32_t h = 2 * c; h < 2 * c + 2; ++h) {
      const SurfacePatch patch = map_.patch(map_.left(h));
      if (patch.kind == PatchKind::convex) sink(boundary_.face(patch.source).ball);
      if (patch.kind == PatchKind::concave) sink(balls_.n + patch.source);
    }
  }

  bool has_patches(uint32_t sphere) const {
    return sphere < balls_.n ? faces_.any(sphere) : faces_.has(face_at_vertex(boundary_, sphere - balls_.n));
  }
  double spacing(uint32_t sphere, double edge) const;
  void add_border(uint32_t sphere, SphericalPatch &patch) const;
  MeshVertex inner_vertex(uint32_t sphere, const Vec3 &direction) const;
  uint32_t patch(uint32_t sphere, uint32_t face) const;
  PatchKind kind(uint32_t sphere) const { return sphere < balls_.n ? PatchKind::convex : PatchKind::concave; }
  uint32_t ball_at(uint32_t sphere, const double (&middle)[3]) const;

  // The saddles. False if there are more triangles than any limit allows.
  bool add_bands(double length, FixedVector<MeshVertex> &vertices, FixedVector<MeshTriangle> &triangles) const;

 private:
  double segments_of_edge(uint32_t c, double length) const;
  double probe() const { return static_cast<double>(balls_.probe_steps); }
  bool is_closed(uint32_t c) const { return map_.origin(2 * c) == no_id; }
  SaddleBand band_of_arc(uint32_t half_edge) const;
  SaddleBand band_of_circle(uint32_t circle) const;
  SaddleBand band_of_saddle(uint32_t k) const;  // of arc k, or behind all arcs of a circle
  ClosedHalfEdge on_ball(uint32_t circle, uint32_t side) const;
  MeshVertex vertex_of(const SaddleBand::Point &point) const {
    return mesh_vertex(balls_, point.position, point.normal, point.ball);
  }
  Position probe_at(uint32_t v) const { return position_of_vertex(balls_, boundary_, v); }
  // From a point to where the probe of a vertex stands.
  Vec3 towards_vertex(const Position &position, uint32_t v) const;
  uint32_t nearest_ball(uint32_t v, const Vec3 &from_probe) const;
  Vec3 normal_at_cusp(uint32_t circle, uint32_t side, const Position &position) const;
  MeshVertex crease_vertex(const Position &position, const uint32_t *vertices, uint32_t count) const;
  void add_ball_loop(uint32_t ball, uint32_t loop, SphericalPatch &patch) const;
  void add_probe_loop(uint32_t v, uint32_t loop, SphericalPatch &patch) const;
  void keep_off_sides(uint32_t v, SphericalPatch &patch) const;
  void keep_off_probes(uint32_t v, SphericalPatch &patch) const;

  struct Grid;
  Grid grid_of_arc(uint32_t arc, uint32_t part, bool has_cusps) const;
  Grid grid_of_circle(uint32_t circle, uint32_t part, const SaddleBand &band, double length) const;
  void add_grid(const SaddleBand &band, Grid &grid, FixedVector<MeshVertex> &vertices,
                FixedVector<MeshTriangle> &triangles) const;

  const BallSet &balls_;
  const Boundary &boundary_;
  const Surface &surface_;
  const SurfaceMap map_;
  const MeshedFaces faces_;
  Span<MeshCurve> curve_;
};

}  // namespace hsp
