// Whole concave patches against spherical triangles computed from where their vertices lie; cut ones against their
// pieces.
#pragma once

#include "core/elementary.hpp"
#include "patch_corners_cases.hpp"
#include "surface/concave_patches.hpp"

namespace cases {

// The triangle's angles by its planes, and its vector area by its sides: half the sum of angle times normal.
struct SmallTriangle {
  double steradians = -hsp::pi;
  hsp::Vec3 vector_area{0, 0, 0};
  bool proper = true;

  SmallTriangle(const hsp::BallSet &balls, const hsp::Boundary &boundary, uint32_t vertex) {
    const hsp::Position at = hsp::position_of_vertex(balls, boundary, vertex);
    hsp::Vec3 towards[3];
    for (uint32_t k = 0; k < 3; ++k) {
      towards[k] = balls.difference(at.ball, boundary.vertex(vertex).ball[k]) - at.offset;
      towards[k] = (1 / std::sqrt(dot(towards[k], towards[k]))) * towards[k];
    }
    for (uint32_t k = 0; k < 3; ++k) {
      const hsp::Vec3 &a = towards[k], &b = towards[(k + 1) % 3], &c = towards[(k + 2) % 3];
      const hsp::Vec3 ab = cross(a, b), ac = cross(a, c);
      proper = proper && dot(ab, ab) > 1e-6 && dot(a, cross(b, c)) * dot(a, cross(b, c)) > 1e-10;
      const hsp::Vec3 turn = cross(ab, ac);
      steradians += hsp::arc_tangent(std::sqrt(dot(turn, turn)), dot(ab, ac));
      const double sine = std::sqrt(dot(ab, ab));
      const double side = hsp::arc_tangent(sine, dot(a, b)) / sine / 2;
      vector_area = vector_area + (dot(ab, c) < 0 ? -side : side) * ab;
    }
  }
};

inline bool patches_are_triangles(uint32_t &whole, uint32_t &cut) {
  const hsp::BallSet &balls = small_union().balls();
  const hsp::Boundary &boundary = small_union().boundary();
  const hsp::Surface &surface = small_surface().builder().surface();
  const double p = static_cast<double>(balls.probe_steps);
  for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
    const hsp::ConcavePatch patch = surface.patch(v);
    if (surface.cut_patches().is_cut(v)) {
      ++cut;
      double area = 0, volume = 0;
      for (const uint32_t piece : surface.cut_patches().pieces(v)) {
        area += surface.cut_patches().piece(piece).area;
        volume += surface.cut_patches().piece(piece).volume;
      }
      if (!near(area, patch.area, 1e-9 * p * p) || !near(volume, patch.volume, 1e-8 * p * p * p)) return false;
      continue;
    }
    const SmallTriangle triangle(balls, boundary, v);
    if (!triangle.proper) continue;
    ++whole;
    const hsp::Vec3 off = patch.vector_area - triangle.vector_area;
    const hsp::Position at = hsp::position_of_vertex(balls, boundary, v);
    const hsp::Vec3 arm = balls.difference(boundary.component_origin(at.ball), at.ball) + at.offset;
    const double volume = -p * p * (p * triangle.steradians + dot(arm, triangle.vector_area)) / 3;
    if (!near(patch.area, p * p * triangle.steradians, 1e-9 * p * p) || dot(off, off) > 1e-18 ||
        !near(patch.volume, volume, 1e-8 * p * p * p)) {
      return false;
    }
  }
  return true;
}

inline uint32_t triangles_and_pieces() {
  uint32_t whole = 0, cut = 0;
  for (uint32_t seed = 0; seed < 200; ++seed) {
    if (!small_surface().build(random_scene(seed)) || !patches_are_triangles(whole, cut)) return seed;
  }
  return whole > 300 && cut > 50 ? all_hold : 200;
}

inline constexpr Check surface_concave_patches[] = {{"triangles_and_pieces", triangles_and_pieces}};

}  // namespace cases
