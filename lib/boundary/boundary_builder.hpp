// Steps 1 and 2 of Section 4.2 over all balls, and what follows from them: loops, faces, shells, components.
#pragma once

#include "boundary/faces.hpp"
#include "sphere/lane_search.hpp"

namespace hsp {

class BoundaryBuilder {
 public:
  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // Status::capacity if a limit is too small; needed() then reports what suffices.
  Status build(const CubeGrid &grid);

  const Boundary &boundary() const { return boundary_; }
  const BoundaryLimits &needed() const { return needed_; }
  // What to try again with after Status::capacity.
  BoundaryLimits retry_limits() const { return limits_.covering(needed_); }

  // The arrays behind the boundary, for tests that break them.
  BoundaryArrays &arrays() { return boundary_.a_; }
  // Scratch memory for checks; [loops + balls].
  Span<uint32_t> scratch() { return scratch_; }

  // For tests that do with less of the code for wide registers, or without.
  LaneSearch &lanes() { return lanes_; }
#if HSP_AVX2
  void use_wide_code(bool use) {
    caps_.wide = lanes_.enabled = use;
  }
#endif

 private:
  void find_vertices(const CubeGrid &grid);
  void find_root_discriminants(const BallSet &balls);

  BoundaryLimits limits_;
  BoundaryLimits needed_;
  Boundary boundary_;
  Caps caps_;
  VertexFinder finder_;
  LaneSearch lanes_;
  FaceFinder faces_;
  Span<uint32_t> scratch_;
};

}  // namespace hsp
