// The vertices of a mesh that patches of the smooth surface share: its corners, and the points of its curves.
#pragma once

#include "mesh/boundary_outline.hpp"
#include "mesh/probe_sphere.hpp"
#include "mesh/surface_curves.hpp"

namespace hsp {

class SurfaceVertices {
 public:
  // The curves are divided before their points are asked for.
  SurfaceVertices(const SurfaceCurves &curves, const MeshedFaces &faces) : curves_(curves), faces_(faces) {}

  // By the map's number.
  MeshVertex corner(uint32_t id) const;
  // Every point between the curve's ends.
  void add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const;

 private:
  ProbeSphere probe_at(uint32_t v) const { return {curves_.balls(), curves_.boundary(), v}; }
  Vec3 normal_at_cusp(uint32_t k, uint32_t side, const Position &position) const;
  MeshVertex at_creases(const Position &position, const uint32_t *vertices, uint32_t count) const;

  const SurfaceCurves &curves_;
  const MeshedFaces &faces_;
};

// The point of a band as a vertex.
inline MeshVertex vertex_of_band(const BallSet &balls, const SaddleBand::Point &point) {
  return mesh_vertex(balls, point.position, point.normal, point.ball);
}

}  // namespace hsp
