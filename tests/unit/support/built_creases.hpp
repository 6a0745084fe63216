// Creases and creased patches beside those of a surface, in memory of their own.
#pragma once

#include "built_surface.hpp"
#include "surface/creased_patches.hpp"

class BuiltCreases {
 public:
  explicit BuiltCreases(const BuiltSurface &built)
      : built_(built), actual_(built.balls(), built.boundary()), chosen_(built.surface().chosen()) {
    const uint32_t vertices = built.boundary().vertex_count();
    cut_memory_.carve(cut_, vertices, uint32_t{0}, uint32_t{0});
    if (built.balls().probe_steps == 0 || vertices == 0) {
      status_ = hsp::Status::ok;
      return;
    }
    grid_memory_.carve(grid_, vertices);
    hsp::Patience endless;
    grid_.build(built.balls(), built.boundary(), endless);
    const hsp::CuspedCircles &cusped = built.surface().cusped_circles();
    status_ =
        crease_memory_.build(creases_, hsp::CreaseLimits{vertices, 0, 0, 0, 0, 0}, actual_, chosen_, grid_, cusped);
    const auto count = static_cast<uint32_t>(creases_.creases().size());
    uint32_t arcs = 0, pieces = 0, all_arcs = 0;
    while (status_ == hsp::Status::ok) {
      patch_memory_.carve(patches_, count, arcs);
      cut_memory_.carve(cut_, vertices, pieces, all_arcs);
      status_ = patches_.fill(actual_, creases_, cusped, grid_, cut_);
      if (status_ != hsp::Status::capacity) break;
      status_ = hsp::Status::ok;
      arcs = std::max(arcs, patches_.most_arcs());
      pieces = std::max(pieces, static_cast<uint32_t>(cut_.required_pieces()));
      all_arcs = std::max(all_arcs, static_cast<uint32_t>(cut_.required_arcs()));
    }
  }
  BuiltCreases(const BuiltCreases &) = delete;
  BuiltCreases &operator=(const BuiltCreases &) = delete;

  hsp::Status status() const { return status_; }
  const hsp::ActualBalls &actual() const { return actual_; }
  const hsp::Creases &creases() const { return creases_; }
  const hsp::CutPatches &cut() const { return cut_; }
  const hsp::ProbeGrid &grid() const { return grid_; }

  // The rest of the patch of a vertex; what is whole as the surface has it.
  hsp::ConcavePatch patch(uint32_t v) const { return cut_.is_cut(v) ? cut_.patch(v) : built_.surface().patch(v); }

 private:
  const BuiltSurface &built_;
  hsp::ActualBalls actual_;
  const hsp::ChosenFaces &chosen_;
  CarvedMemory grid_memory_, crease_memory_, patch_memory_, cut_memory_;
  hsp::ProbeGrid grid_;
  hsp::Creases creases_;
  hsp::CreasedPatches patches_;
  hsp::CutPatches cut_;
  hsp::Status status_ = hsp::Status::ok;
};
