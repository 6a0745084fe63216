// Fills a surface: the pass over all vertices of a boundary.
#pragma once

#include "surface/flat_patches.hpp"
#include "surface/free_region.hpp"
#include "surface/settled_circles.hpp"
#include "surface/surface.hpp"

namespace hsp {

class SurfaceBuilder : public Limited<SurfaceLimits> {
 public:
  void carve(Workspace &workspace, const SurfaceLimits &limits);

  // Status::capacity if a limit is too small; needed() then reports what suffices. Status::degenerate if the caps of a
  // patch yield no region of it, neither in doubles nor in integers.
  // Status::stopped if more is not allowed.
  Status build(const BallSet &balls, const Boundary &boundary, Patience patience = Patience());
  // Of some shells of the boundary alone.
  Status build(const BallSet &balls, const Boundary &boundary, Span<const uint32_t> shells,
               Patience patience = Patience());

  const Surface &surface() const { return surface_; }

 private:
  Status build(const BallSet &balls, const Boundary &boundary, const Span<const uint32_t> *shells, Patience &patience);
  // Of each concave patch on its own, or such that all patches that meet in a point share them (settled_circles.hpp).
  enum class Decisions : uint8_t { of_each_patch, shared };
  Status cut_patches(const BallSet &balls, const Boundary &boundary, Decisions decisions, Patience &patience);
  bool is_crowded(const BallSet &balls, const Boundary &boundary, uint32_t vertex) const;
  bool has_opposite_probes(const BallSet &balls, const Boundary &boundary);
  bool store_flat_patch(FlatPatches &flat, uint32_t vertex);
  bool settle(const SettledCircles &circles, double steradians, const Vec3 &vector_area, const SurfaceCounts &before);
  bool measure_cut_patch(double &steradians, Vec3 &vector_area);
  bool accept(const FreeRegion &region, double &steradians, Vec3 &vector_area);
  void number_arcs(const Boundary &boundary);
  void store_pieces(const Boundary &boundary, uint32_t vertex, const ConcaveScale &scale, double whole,
                    const SettledCircles *settled);
  void add_crease(const RegionArc &arc, CreaseSums &creases) const;

  Surface surface_;
  ProbeGrid grid_;
  ProbeCaps probe_;
  FixedVector<RegionCorner> corners_;
  FixedVector<RegionArc> arcs_;
  uint32_t uncertain_pieces_ = 0;
};

}  // namespace hsp
