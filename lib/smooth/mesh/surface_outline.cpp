#include "mesh/surface_outline.hpp"

namespace hsp {

double SurfaceOutline::spacing(uint32_t sphere, double edge) const {
  return spacing_on(sphere < ball_count() ? balls().r[sphere] - probe() : probe(), edge);
}

double SurfaceOutline::steradians(uint32_t sphere) const {
  if (sphere < ball_count()) return faces().steradians(balls(), sphere);
  if (!has_patches(sphere)) return 0.0;
  return surface().patch(sphere - ball_count()).area / (probe() * probe());
}

bool SurfaceOutline::has_next_to_no_area(uint32_t sphere, double least) const {
  return sphere >= ball_count() &&
         (surface().is_of_actual_balls() || surface().cut_patches().is_cut(sphere - ball_count())) &&
         steradians(sphere) < least;
}

uint32_t SurfaceOutline::patch(uint32_t sphere, uint32_t face) const {
  if (sphere < ball_count()) return faces().face(sphere, face);
  const uint32_t v = sphere - ball_count();
  return map().concave_patch(v, surface().cut_patches().pieces(v).first + face);
}

void SurfaceOutline::add_border(uint32_t sphere, SphericalPatch &patch) const {
  if (sphere < ball_count()) {
    add_convex_border(sphere, patch);
  } else {
    add_concave_border(sphere - ball_count(), patch);
  }
}

MeshVertex SurfaceOutline::inner_vertex(uint32_t sphere, const Vec3 &direction) const {
  if (sphere < ball_count()) return vertex_on_ball(balls(), sphere, balls().r[sphere] - probe(), direction);
  const ProbeSphere at = probe_at(sphere - ball_count());
  const Vec3 normal = unit(direction, upwards);
  return mesh_vertex(balls(), {at.centre().ball, at.centre().offset - probe() * normal}, normal,
                     at.nearest_ball(-normal));
}

uint32_t SurfaceOutline::ball_at(uint32_t sphere, const double (&middle)[3]) const {
  if (sphere < ball_count()) return sphere;
  const ProbeSphere at = probe_at(sphere - ball_count());
  double centre[3];
  to_coordinates(balls(), at.centre(), centre);
  return at.nearest_ball({middle[0] - centre[0], middle[1] - centre[1], middle[2] - centre[2]});
}

// ---- limits ----

Status expected_mesh_limits(const MeshedSurface &from, double edge, MeshLimits &limits) {
  if (!from.is_smooth()) return expected_limits_of_boundary(from.balls, from.boundary, edge, limits);
  return SurfaceOutline(from.balls, from.boundary, *from.smooth, {}).expected_limits(edge, limits);
}

double SurfaceOutline::segments_around(uint32_t patch, double edge) const {
  double border = 0.0;
  map().for_each_loop(
      patch, [&](uint32_t loop) { map().for_each_edge(loop, [&](uint32_t h) { border += segments(h / 2, edge); }); });
  return border;
}

Status SurfaceOutline::expected_limits(double edge, MeshLimits &limits) const {
  MeshSizes sizes;
  sizes.add_points(map().corner_count());
  for (uint32_t c = 0; c < curve_count(); ++c) sizes.add_points(segments(c, edge));
  for (uint32_t s = 0; s < sphere_count(); ++s) {
    if (!has_patches(s)) continue;
    double border = 0.0;
    if (s < ball_count()) {
      for (const uint32_t face : boundary().faces(s)) border += segments_around(face, edge);
    } else {
      const uint32_t v = s - ball_count();
      const IdRange pieces = surface().cut_patches().pieces(v);
      const uint32_t count = pieces.empty() ? 1 : pieces.size();
      for (uint32_t k = 0; k < count; ++k) border += segments_around(map().concave_patch(v, pieces.first + k), edge);
    }
    sizes.add_sphere(border, steradians(s), spacing(s, edge));
  }
  SaddleGrids(*this).add_sizes(edge, sizes);
  return sizes.limits(sphere_count(), curve_count(), limits);
}

}  // namespace hsp
