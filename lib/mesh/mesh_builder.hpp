// Fills a mesh: patch by patch, until all that share a curve agree how many points it has.
#pragma once

#include "mesh/boundary_curves.hpp"
#include "mesh/mesh.hpp"
#include "mesh/spherical_patch.hpp"

namespace hsp {

// Limits that nearly always suffice for edges of this length, in lattice steps. Status::range if they would be too
// large.
Status expected_mesh_limits(const BallSet &balls, const Boundary &boundary, double edge, MeshLimits &limits);

class MeshBuilder {
 public:
  void carve(Workspace &workspace, const MeshLimits &limits);

  // The boundary with edges of about this length, in lattice steps. Status::capacity if a limit is too small; needed()
  // then reports what suffices as far as it is known. Status::range if there are more points than any limit allows.
  // Status::check if two borders are so close to each other that no number of points tells them apart.
  Status build(const BallSet &balls, const Boundary &boundary, double edge);

  const Mesh &mesh() const { return mesh_; }
  const MeshLimits &needed() const { return needed_; }
  MeshLimits retry_limits() const { return limits_.covering(needed_); }

 private:
  struct PatchRange {
    uint32_t first, last;  // triangles
    bool outdated;
  };

  void add_boundary_vertices(const BallSet &balls, const Boundary &boundary);
  void add_samples(const BallSet &balls, const Boundary &boundary, uint32_t curve);
  void add_vertex(const BallSet &balls, const Position &position, const uint32_t *owners, uint32_t count);
  bool triangulate_ball(const BallSet &balls, const Boundary &boundary, double edge, uint32_t i);
  void add_loop(const BallSet &balls, const Boundary &boundary, uint32_t i, uint32_t loop);
  void keep_off_neighbours(const BallSet &balls, const Boundary &boundary, uint32_t i);
  bool is_too_fine(const BallSet &balls, const Boundary &boundary, uint32_t curve) const;
  bool refine(const BallSet &balls, const Boundary &boundary);
  void remove_outdated();

  MeshLimits limits_;
  MeshLimits needed_;
  Mesh mesh_;
  BoundaryCurves curves_;
  SphericalPatch patch_;
  Span<PatchRange> range_;       // [balls]
  Span<uint32_t> vertex_moves_;  // [vertices]
};

}  // namespace hsp
