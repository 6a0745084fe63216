#include "mesh_defects.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "library_run.hpp"

namespace {

using Vector = std::array<double, 3>;

Vector less(const double *a, const double *b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double product(const Vector &a, const Vector &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector across(const Vector &a, const Vector &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double degrees_between(const Vector &a, const Vector &b) {
  const Vector n = across(a, b);
  return std::atan2(std::sqrt(product(n, n)), product(a, b)) * 57.29577951308232;
}

class Defects {
 public:
  Defects(const mesh_result &mesh, const hsp_surface *surface, double limit)
      : mesh_(mesh), is_smooth_surface_(surface != nullptr), limit_(limit) {
    if (surface != nullptr) cusps_ = surface_cusps(surface);
    sharp_.assign(mesh.counts.vertices, false);
    normal_.resize(mesh.counts.triangles);
    worst_.assign(mesh.counts.triangles, 0.0);
    for (uint32_t t = 0; t < mesh.counts.triangles; ++t) {
      const uint32_t *const c = mesh.corners[t];
      const Vector u = less(mesh.xyz[c[1]], mesh.xyz[c[0]]);
      const Vector v = less(mesh.xyz[c[2]], mesh.xyz[c[0]]);
      const Vector w = less(mesh.xyz[c[2]], mesh.xyz[c[1]]);
      const Vector n = across(u, v);
      const double longest = std::max({product(u, u), product(v, v), product(w, w)});
      const bool is_flat = product(n, n) <= 1e-12 * longest * longest;
      normal_[t] = is_flat ? Vector{0.0, 0.0, 0.0} : n;
    }
  }

  MeshDefects find() {
    find_sharp_vertices();
    for (uint32_t t = 0; t < mesh_.counts.triangles; ++t) {
      for (uint32_t k = 0; k < 3; ++k) add_edge(t, k);
    }
    double all = 0.0, bends = 0.0, tilts = 0.0, above = 0.0;
    for (uint32_t t = 0; t < mesh_.counts.triangles; ++t) {
      const double area = 0.5 * std::sqrt(product(normal_[t], normal_[t]));
      if (area == 0.0) continue;
      const double tilt = tilt_of(t);
      found_.bend = std::max(found_.bend, worst_[t]);
      found_.tilt = std::max(found_.tilt, tilt);
      all += area;
      bends += area * worst_[t];
      tilts += area * tilt;
      if (std::max(worst_[t], tilt) > limit_) above += area;
    }
    found_.mean_bend = bends / all;
    found_.mean_tilt = tilts / all;
    found_.share_above = above / all;
    return found_;
  }

 private:
  // Whether the surface has one tangent plane where two patches meet.
  bool is_smooth_between(uint32_t s, uint32_t t) const {
    return mesh_.patches[s] == mesh_.patches[t] || (is_smooth_surface_ && mesh_.kinds[s] != mesh_.kinds[t]);
  }

  // Where patches meet that have different normals there, vertices have none of them.
  void find_sharp_vertices() {
    std::vector<uint32_t> first(mesh_.counts.vertices, HSP_NONE);
    for (uint32_t t = 0; t < mesh_.counts.triangles; ++t) {
      for (const uint32_t v : mesh_.corners[t]) {
        const bool counts = !is_smooth_surface_ || mesh_.kinds[t] == HSP_PATCH_CONCAVE;
        if (!counts) continue;
        if (first[v] == HSP_NONE) first[v] = mesh_.patches[t];
        if (first[v] != mesh_.patches[t]) sharp_[v] = true;
      }
    }
    for (uint32_t v = 0; v < mesh_.counts.vertices; ++v) {
      const double *const x = mesh_.xyz[v];
      if (cusps_.count({x[0], x[1], x[2]}) > 0) sharp_[v] = true;
    }
  }

  void add_edge(uint32_t t, uint32_t k) {
    const uint32_t a = mesh_.corners[t][k];
    const uint32_t b = mesh_.corners[t][(k + 1) % 3];
    const auto other = edges_.find({b, a});
    if (other == edges_.end()) {
      edges_[{a, b}] = t;
      return;
    }
    const uint32_t s = other->second;
    edges_.erase(other);
    if (!is_smooth_between(s, t) || is_cusp(a) || is_cusp(b)) return;
    if (product(normal_[s], normal_[s]) == 0.0 || product(normal_[t], normal_[t]) == 0.0) return;
    const double angle = degrees_between(normal_[s], normal_[t]);
    worst_[s] = std::max(worst_[s], angle);
    worst_[t] = std::max(worst_[t], angle);
  }
  bool is_cusp(uint32_t v) const {
    const double *const x = mesh_.xyz[v];
    return !cusps_.empty() && cusps_.count({x[0], x[1], x[2]}) > 0;
  }

  double tilt_of(uint32_t t) const {
    double most = 0.0;
    for (const uint32_t v : mesh_.corners[t]) {
      if (sharp_[v]) continue;
      const double *const n = mesh_.normals[v];
      most = std::max(most, degrees_between(normal_[t], {n[0], n[1], n[2]}));
    }
    return most;
  }

  const mesh_result &mesh_;
  const bool is_smooth_surface_;
  const double limit_;
  std::set<Vector> cusps_;
  std::vector<bool> sharp_;
  std::vector<Vector> normal_;  // not of length 1; of triangles without area 0
  std::vector<double> worst_;   // angles to neighbours
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> edges_;
  MeshDefects found_;
};

}  // namespace

MeshDefects mesh_defects(const mesh_result &mesh, const hsp_surface *surface, double limit) {
  return Defects(mesh, surface, limit).find();
}

std::set<std::array<double, 3>> surface_cusps(const hsp_surface *surface) {
  hsp_surface_part_counts counts{};
  expect_ok(hsp_surface_get_part_counts(surface, &counts), "hsp_surface_get_part_counts");
  std::vector<hsp_surface_corner> corners(counts.corners);
  expect_ok(hsp_surface_get_corners(surface, 0, counts.corners, corners.data()), "hsp_surface_get_corners");
  std::set<std::array<double, 3>> cusps;
  for (const hsp_surface_corner &corner : corners) {
    if (corner.kind != HSP_CORNER_BALL) cusps.insert({corner.xyz[0], corner.xyz[1], corner.xyz[2]});
  }
  return cusps;
}
