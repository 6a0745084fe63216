// Steps 1 and 2 of Section 4.2 over all balls, and the assembly of what they find.
#pragma once

#include "boundary/faces.hpp"
#include "boundary/boundary.hpp"
#include "sphere/vertex_finder.hpp"

namespace hsp {

class BoundaryBuilder {
 public:
  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // Builds everything up to faces. Status::capacity if a limit is too small; needed() then tells what suffices.
  Status build(const CubeGrid &grid);

  const BoundaryStructure &structure() const { return structure_; }
  BoundaryStructure &structure() { return structure_; }
  const BoundaryLimits &needed() const { return needed_; }

 private:
  void find_vertices(const CubeGrid &grid);

  BoundaryLimits limits_;
  BoundaryLimits needed_;
  BoundaryStructure structure_;
  Caps caps_;
  VertexFinder finder_;
  FaceScratch scratch_;
};

}  // namespace hsp
