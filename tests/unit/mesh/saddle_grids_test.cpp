#include "mesh/saddle_grids.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "divided_curves.hpp"

namespace {

struct Bands {
  std::vector<hsp::MeshVertex> vertex_room;
  std::vector<hsp::MeshTriangle> triangle_room;
  hsp::FixedVector<hsp::MeshVertex> vertices;
  hsp::FixedVector<hsp::MeshTriangle> triangles;

  Bands(const BuiltSurface &built, double length) : vertex_room(100000), triangle_room(200000) {
    vertices = hsp::FixedVector(hsp::Span<hsp::MeshVertex>(vertex_room.data(), 100000U));
    triangles = hsp::FixedVector(hsp::Span<hsp::MeshTriangle>(triangle_room.data(), 200000U));
    DividedCurves divided(built, length);
    hsp::SurfaceCurves &curves = divided.get();
    for (uint32_t id = 0; id < curves.map().corner_count(); ++id) vertices.push(curves.corner(id));
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
      curves.curve(c).first_sample = vertices.size();
      curves.add_samples(c, vertices);
    }
    hsp::Patience endless;
    EXPECT_TRUE(hsp::SaddleGrids(curves).add_triangles(length, endless, vertices, triangles));
    EXPECT_FALSE(vertices.overflowed() || triangles.overflowed());
  }

  double area() const {
    double sum = 0.0;
    for (uint32_t t = 0; t < triangles.size(); ++t) {
      const hsp::Vec3 a = at(t, 0);
      const hsp::Vec3 normal = cross(at(t, 1) - a, at(t, 2) - a);
      const double *const n = vertices[triangles[t].vertex[0]].normal;
      sum += 0.5 * std::sqrt(dot(normal, normal));
      EXPECT_GT(dot(normal, hsp::Vec3{n[0], n[1], n[2]}), -1e-6 * dot(normal, normal));
    }
    return sum;
  }
  hsp::Vec3 at(uint32_t t, uint32_t k) const {
    const double *const p = vertices[triangles[t].vertex[k]].position;
    return {p[0], p[1], p[2]};
  }
};

// Of arcs, with and without cusps, and of whole circles: half the length, a quarter of the error.
TEST(SaddleGrids, AreasConverge) {
  for (const double circumradius : {2.0, 2.9, 3.09, 3.2}) {
    const BuiltSurface built(three_around(circumradius), 1400.0);
    const double exact = built.total().saddle;
    const double error[2] = {exact - Bands(built, 100.0).area(), exact - Bands(built, 50.0).area()};
    EXPECT_LT(std::fabs(error[0]), 0.01 * exact) << circumradius;
    EXPECT_NEAR(error[1], error[0] / 4, 0.1 * std::fabs(error[0])) << circumradius;
  }
}

// Every saddle has triangles, of its own kind, and nothing else has.
TEST(SaddleGrids, EverySaddleHasTriangles) {
  const BuiltSurface built(three_around(3.09), 1400.0);
  const Bands bands(built, 300.0);
  const hsp::SurfaceMap map(built.balls(), built.boundary(), built.surface());
  std::vector<uint32_t> seen(map.patch_count(), 0);
  for (uint32_t t = 0; t < bands.triangles.size(); ++t) {
    const hsp::MeshTriangle &triangle = bands.triangles[t];
    EXPECT_EQ(map.patch(triangle.patch).kind, triangle.kind);
    ++seen[triangle.patch];
  }
  for (uint32_t p = 0; p < map.patch_count(); ++p) {
    const hsp::PatchKind kind = map.patch(p).kind;
    const bool is_saddle = kind == hsp::PatchKind::saddle || kind == hsp::PatchKind::circle_saddle;
    EXPECT_EQ(seen[p] > 0, is_saddle);
  }
}

}  // namespace
