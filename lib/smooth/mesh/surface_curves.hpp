// The edges of the smooth surface (surface_map.hpp) as polygons: how many points each has, and where. The two rims of a
// saddle have equally many, and so have its two sides, as bands demand.
#pragma once

#include "mesh/boundary_outline.hpp"
#include "mesh/probe_sphere.hpp"
#include "mesh/saddle_band.hpp"

namespace hsp {

// The points of a crease from its start corner on; start is no_id for a whole circle.
CirclePoints points_of_crease(const SurfaceMap &map, uint32_t edge, uint32_t start);

class SurfaceCurves {
 public:
  // Memory for the map's edges; none if only lengths are asked for. The surface must be closed, its probe not 0.
  SurfaceCurves(const BallSet &balls, const Boundary &boundary, const Surface &surface, Span<MeshCurve> room)
      : map_(balls, boundary, surface), curve_(room) {}

  const BallSet &balls() const { return map_.balls(); }
  const Boundary &boundary() const { return map_.boundary(); }
  const Surface &surface() const { return map_.surface(); }
  const SurfaceMap &map() const { return map_; }
  ProbeSphere probe_at(uint32_t v) const { return {balls(), boundary(), v}; }
  // The part that is measured.
  MeshedFaces faces() const { return {boundary(), surface().chosen()}; }
  double probe() const { return static_cast<double>(balls().probe_steps); }

  uint32_t curve_count() const { return map_.edge_count(); }
  const MeshCurve &curve(uint32_t c) const { return curve_[c]; }
  MeshCurve &curve(uint32_t c) { return curve_[c]; }
  bool is_closed(uint32_t c) const { return map_.origin(2 * c) == no_id; }

  // Segments of about the given length, in doubles, which may be more than fits.
  double segments(uint32_t c, double length) const;
  // Gives all curves their segments. False if there are more than max_count, or if `patience` stops it.
  bool divide(double length, Patience &patience);
  // Whether points would lie too near each other if the curve had more of them.
  bool is_too_fine(uint32_t c) const;
  // The curve that must have as many points as c; c itself if there is none.
  uint32_t partner(uint32_t c) const;

  // The vertices that patches share (surface_vertices.cpp): a corner by the map's number, and every point between the
  // ends of a divided curve.
  MeshVertex corner(uint32_t id) const;
  void add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const;

  uint32_t saddle_count() const { return boundary().arc_count() + boundary().circle_count(); }
  SaddleBand band_of(LoopElement e) const;

 private:
  Vec3 normal_at_cusp(uint32_t k, uint32_t side, const Position &position) const;
  MeshVertex at_creases(const Position &position, const uint32_t *vertices, uint32_t count) const;

  const SurfaceMap map_;
  Span<MeshCurve> curve_;
};

// The point of a band as a vertex.
inline MeshVertex vertex_of_band(const BallSet &balls, const SaddleBand::Point &point) {
  return mesh_vertex(balls, point.position, point.normal, point.ball);
}

}  // namespace hsp
