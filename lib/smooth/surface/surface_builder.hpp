// Fills a surface: the pass over all vertices of a boundary.
//
// First each concave patch is cut on its own, in doubles. If every answer is certain and the patches fit together, that
// is the surface. Otherwise all patches are cut once more, by signs of one actual set of balls (creases.hpp).
#pragma once

#include "surface/creased_patches.hpp"
#include "surface/free_region.hpp"
#include "surface/surface.hpp"

namespace hsp {

class SurfaceBuilder : public Limited<SurfaceLimits> {
 public:
  void carve(Workspace &workspace, const SurfaceLimits &limits);

  // Status::capacity if a limit is too small; needed() then reports what suffices. Status::degenerate if a sign of the
  // actual set is not certain in any width, or borders do not close. Status::stopped if `patience` stops it. shells:
  // the shells of the boundary that are chosen (chosen_faces.hpp); null for all.
  Status build(const BallSet &balls, const Boundary &boundary, Patience patience = Patience(),
               const Span<const uint32_t> *shells = nullptr);

  const Surface &surface() const { return surface_; }

 private:
  Status find_patches(const ActualBalls &actual, Patience &patience);
  bool cut_patches(const BallSet &balls, const Boundary &boundary, Patience &patience);
  Status cut_actual_patches(const ActualBalls &actual, Patience &patience);
  void use_for_doubles();
  bool fits() const;
  void need_arcs(uint64_t arcs) { needed_.arcs = larger_count(needed_.arcs, clamped_count(arcs)); }
  bool cut_in_doubles(const BallSet &balls, const Boundary &boundary, uint32_t vertex);
  void number_arcs(const Boundary &boundary);
  void store_pieces(const Boundary &boundary, uint32_t vertex, const ConcaveScale &scale);

  Surface surface_;
  ProbeGrid grid_;
  ProbeCaps probe_;
  // Memory for the corners and arcs of the patch at hand, in doubles or of the actual set.
  Span<uint64_t> border_room_;
  FixedVector<RegionCorner> corners_;
  FixedVector<RegionArc> arcs_;
  CreasedPatches creased_;
  Creases creases_;
  bool certain_ = true;
};

}  // namespace hsp
