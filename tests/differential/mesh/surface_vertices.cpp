#include "surface_vertices.hpp"

#include <mesh_invariants.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "excluded_surface.hpp"
#include "mesh_defects.hpp"

namespace {

using Cube = std::array<int64_t, 3>;

double distance_between(const double *a, const double *b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The balls that reach a cube or come nearer to it than twice the probe's radius: those further away are not what is
// nearest to a point in it, if that is not much further away than it should be.
oracle::DistanceFromOutside distance_in(const Cube &cube, double side, const computed &balls, double probe) {
  double middle[3];
  for (size_t axis = 0; axis < 3; ++axis) middle[axis] = (static_cast<double>(cube[axis]) + 0.5) * side;
  std::vector<oracle::ProbedBall> near;
  for (uint32_t i = 0; i < balls.n; ++i) {
    const double *const c = balls.xyz + 3 * size_t{i};
    if (distance_between(c, middle) < balls.radius[i] + 2 * probe + side) {
      near.push_back({{c[0], c[1], c[2]}, balls.radius[i]});
    }
  }
  return oracle::DistanceFromOutside(std::move(near));
}

}  // namespace

VertexErrors surface_vertex_errors(const mesh_result &mesh, double probe) {
  const double side = 2 * probe;
  std::map<Cube, std::vector<uint32_t>> vertices;
  for (uint32_t v = 0; v < mesh.counts.vertices; ++v) {
    Cube cube;
    for (size_t axis = 0; axis < 3; ++axis) cube[axis] = static_cast<int64_t>(std::floor(mesh.xyz[v][axis] / side));
    vertices[cube].push_back(v);
  }
  uint32_t *const patch = patches_of_vertices(&mesh);
  const std::set<std::array<double, 3>> cusps = surface_cusps(mesh.surface);
  VertexErrors errors;
  for (const auto &[cube, inside] : vertices) {
    const oracle::DistanceFromOutside distance = distance_in(cube, side, *mesh.base, probe);
    for (const uint32_t v : inside) {
      const double *const x = mesh.xyz[v];
      const oracle::DistanceFromOutside::Nearest nearest = distance({x[0], x[1], x[2]});
      errors.off = std::max(errors.off, std::fabs(nearest.distance - probe));
      if (patch[v] == HSP_NONE || cusps.count({x[0], x[1], x[2]}) > 0) continue;
      double tip[3];
      for (size_t axis = 0; axis < 3; ++axis) tip[axis] = x[axis] + probe * mesh.normals[v][axis];
      errors.normal = std::max(errors.normal, distance_between(tip, nearest.point.data()) / probe);
    }
  }
  std::free(patch);
  return errors;
}
