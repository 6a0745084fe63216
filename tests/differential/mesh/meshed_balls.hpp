// Balls with their boundary, the smooth surface over it, and meshes of both, which own their memory.
#pragma once

#include <mesh_result.h>

#include <vector>

#include "ball_list.hpp"

class MeshedBalls {
 public:
  // Radii are without the probe. A step of 0 lets the set choose.
  MeshedBalls(const support::BallList &balls, double probe, double step = 0.0);
  ~MeshedBalls();
  MeshedBalls(const MeshedBalls &) = delete;
  MeshedBalls &operator=(const MeshedBalls &) = delete;

  const computed &boundary() const { return computed_; }
  const surface_result &surface() const { return surface_; }
  bool has_closed_surface() const { return surface_.counts.open_joints == 0; }
  // The sum over all shells of the smooth surface; without a probe, of the boundary.
  int64_t surface_euler() const;
  std::vector<hsp_surface_shell> surface_shells() const;
  // The shell of each patch of the smooth surface.
  std::vector<uint32_t> shells_of_patches() const;

 private:
  double probe_;
  computed computed_{};
  surface_result surface_{};
};

class MadeMesh {
 public:
  MadeMesh(const computed &base, double edge) : status_(mesh_result_make(&base, edge, &mesh_)) {}
  MadeMesh(const surface_result &base, double edge) : status_(mesh_result_make_surface(&base, edge, &mesh_)) {}
  ~MadeMesh() { mesh_result_release(&mesh_); }
  MadeMesh(const MadeMesh &) = delete;
  MadeMesh &operator=(const MadeMesh &) = delete;

  int32_t status() const { return status_; }
  const mesh_result &get() const { return mesh_; }
  int64_t euler() const { return int64_t{mesh_.counts.vertices} - int64_t{mesh_.counts.triangles} / 2; }
  // Of one triangle, and of the tetrahedron that it makes with the origin.
  double triangle_area(uint32_t t) const;
  double triangle_volume(uint32_t t) const;

 private:
  mesh_result mesh_{};
  int32_t status_;
};
