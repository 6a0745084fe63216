// The creases of a smooth surface and the concave patches that creases cut, in memory of their own.
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
    uint32_t near = 0, creases = 0, corners = 0;
    do {
      crease_memory_.carve(creases_, near, creases, corners);
      status_ = creases_.build(actual_, chosen_, grid_, built.surface().cusped_circles(), triangles_, endless);
      near = creases_.most_near();
      creases = creases_.required_creases();
      corners = creases_.required_corners();
    } while (status_ == hsp::Status::capacity);
    if (status_ != hsp::Status::ok) return;
    const uint32_t words = (2 * creases + 6) * hsp::CreasedPatches::words_of_arc;
    border_memory_.resize(words);
    patches_.use({border_memory_.data(), words});
    cut_memory_.carve(cut_, vertices, 2 * creases + vertices, 2 * creases + 6 * vertices);
    status_ = patches_.fill(inputs(), cut_, endless);
  }
  BuiltCreases(const BuiltCreases &) = delete;
  BuiltCreases &operator=(const BuiltCreases &) = delete;

  hsp::Status status() const { return status_; }
  const hsp::ActualBalls &actual() const { return actual_; }
  const hsp::Creases &creases() const { return creases_; }
  // The border of a vertex's patch after the creases have cut it.
  hsp::Span<hsp::BorderArc> border(uint32_t vertex) { return patches_.find_border(inputs(), vertex); }
  const hsp::CutPatches &cut() const { return cut_; }
  const hsp::ProbeGrid &grid() const { return grid_; }

  // The rest of the patch of a vertex after the cuts; a patch that no crease cuts is the surface's.
  hsp::ConcavePatch patch(uint32_t v) const { return cut_.is_cut(v) ? cut_.patch(v) : built_.surface().patch(v); }

 private:
  hsp::CreasedPatches::Inputs inputs() { return {actual_, grid_, built_.surface().cusped_circles(), creases_}; }

  const BuiltSurface &built_;
  hsp::ActualBalls actual_;
  const hsp::ChosenFaces &chosen_;
  CarvedMemory grid_memory_, crease_memory_, cut_memory_;
  std::vector<uint64_t> border_memory_;
  hsp::ProbeGrid grid_;
  hsp::ProbeTriangles triangles_;
  hsp::Creases creases_;
  hsp::CreasedPatches patches_;
  hsp::CutPatches cut_;
  hsp::Status status_ = hsp::Status::ok;
};
