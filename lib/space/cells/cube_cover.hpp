// The cubes of the grid that balls meet, and the balls that meet each of them. A ball that touches a cube meets it, as
// the symbolic perturbation inflates it.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "core/workspace.hpp"
#include "model/cube_grid.hpp"
#include "model/cube_table.hpp"

namespace hsp {

// Whether a ball meets a cube of this side.
bool meets_cube(const exact::LatticeBall &ball, const CubeCoordinates &cube, int64_t side);

class CubeCover {
 public:
  // Takes memory for so many cubes, and so many entries: pairs of a cube and a ball that meets it.
  void carve(Workspace &workspace, uint32_t cubes, uint32_t entries);
  // False if the memory does not suffice; needed_cubes() and needed_entries() then do.
  bool build(const CubeGrid &grid, Patience &patience);

  uint32_t needed_cubes() const { return needed_cubes_; }
  uint32_t needed_entries() const { return needed_entries_; }

  // The cubes are in the order of comes_before().
  uint32_t cubes() const { return table_.count(); }
  const CubeCoordinates &cube(uint32_t k) const { return table_.coordinates(k); }
  // The corners of the box around all cubes, if there are any.
  const CubeCoordinates &low() const { return table_.low(); }
  const CubeCoordinates &high() const { return table_.high(); }
  // The number of a cube; no_id if no ball meets it.
  uint32_t find(const CubeCoordinates &cube) const { return table_.find(cube); }
  uint32_t first_entry(uint32_t k) const { return first_entry_[k]; }
  // The balls that meet a cube, in the grid's order.
  Span<const uint32_t> balls(uint32_t k) const { return entries_.part(first_entry_[k], first_entry_[k + 1]); }
  uint32_t entries() const { return first_entry_[cubes()]; }
  uint32_t most_balls() const { return most_balls_; }

 private:
  CubeTable table_;
  Span<CubeCoordinates> sorted_;
  Span<uint32_t> first_entry_;  // [cubes + 1]
  Span<uint32_t> entries_;
  uint32_t capacity_ = 0;
  uint32_t needed_cubes_ = 0, needed_entries_ = 0, most_balls_ = 0;
};

}  // namespace hsp
