// Free space, the space that no ball of a set covers, cut into simple cells (Theorem 2.4). There are two kinds: runs of
// cubes that no ball meets; and, in every other cube of the grid, the free parts of the power cells of its balls, each
// of which lies at one ball. Ids of balls are in grid order. The order of cells:
//
//   the runs, cell 0 below all balls | the free parts, by cubes, in each by balls, in each by parts
//
// Cells are adjacent if they have a piece of a facet or of a side of cubes in common. A region is a connected component
// of free space, made up by adjacent cells. The region of cell 0 is the outside, and has number 0.
#pragma once

#include "cells/cell_contacts.hpp"
#include "cells/cube_cover.hpp"
#include "cells/cube_frame.hpp"
#include "cells/empty_runs.hpp"
#include "core/fixed_vector.hpp"
#include "core/id_range.hpp"
#include "core/limits.hpp"
#include "core/workspace.hpp"

namespace hsp {

struct FreeSpaceLimits {
  uint32_t cubes = 0;
  uint32_t entries = 0;  // pairs of a cube and a ball that meets it
  uint32_t cells = 0;
  uint32_t adjacencies = 0;
  uint32_t landmarks = 0;     // vertices of power cells with several free parts
  uint32_t facets = 0;        // of power cells on sides between cubes that balls meet
  uint32_t corners = 0;       // of these facets
  uint32_t cube_balls = 0;    // balls that meet one cube
  uint32_t cube_corners = 0;  // corners of all power cells of one cube
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, FreeSpaceLimits &limits) {
  if (balls > (max_count - 2048) / 80) return Status::range;
  const uint32_t in_cube = balls < 192 ? balls : 192;
  limits = {2 * balls + 64,   8 * balls + 64,    10 * balls + 256, 40 * balls + 1024, 16 * balls + 512,
            16 * balls + 512, 80 * balls + 2048, in_cube,          40 * in_cube + 64};
  return Status::ok;
}

enum class CellKind : uint32_t {
  run,      // cubes that no ball meets
  at_ball,  // a free part of a power cell that its ball meets
  apart,    // a whole power cell that its ball does not meet
};

struct FreeCell {
  uint32_t cube;  // the number of its cube in the cover, and its ball; no_id for a run
  uint32_t ball;
  CellKind kind;
  uint32_t region;
  uint32_t first_landmark;  // landmarks of a cell are consecutive, those of the next cell follow
};

// A vertex of a power cell outside its ball, named by the codes of the three other balls or sides. It tells which free
// part is the cell that has this landmark.
struct Landmark {
  uint32_t code[3];
};

// A code is the number of a side of the cube, or that of a ball plus six.
constexpr PowerPlane plane_of_code(uint32_t code, uint32_t ball) {
  return code < cube_sides ? side_plane(code) : PowerPlane{ball, code - cube_sides};
}

class FreeSpace {
 public:
  uint32_t cube_count() const { return cover.cubes(); }
  uint32_t cell_count() const { return cells.size(); }
  uint32_t run_count() const { return runs.count(); }
  uint32_t adjacency_count() const { return contacts.size(); }
  uint32_t region_count() const { return regions; }
  const FreeCell &cell(uint32_t c) const { return cells[c]; }
  // The adjacent cells, in ascending order.
  Span<const uint32_t> neighbours(uint32_t c) const {
    return neighbour.part(first_neighbour[c], first_neighbour[c + 1]);
  }
  IdRange landmarks_of(uint32_t c) const {
    return {cells[c].first_landmark, c + 1 < cells.size() ? cells[c + 1].first_landmark : landmarks.size()};
  }
  // The cells that are the free parts of the power cell of an entry of the cover.
  IdRange parts_of(uint32_t entry) const { return {first_part[entry], first_part[entry + 1]}; }

  void carve(Workspace &workspace, const FreeSpaceLimits &limits, bool with_portals) {
    cover.carve(workspace, limits.cubes, limits.entries);
    runs.carve(workspace, limits.cubes);
    cells = FixedVector<FreeCell>(workspace.take<FreeCell>(limits.cells));
    landmarks = FixedVector<Landmark>(workspace.take<Landmark>(limits.landmarks));
    contacts.carve(workspace, limits.adjacencies, with_portals);
    first_part = workspace.take<uint32_t>(static_cast<uint64_t>(limits.entries) + 1);
    first_neighbour = workspace.take<uint32_t>(static_cast<uint64_t>(limits.cells) + 1);
    neighbour = workspace.take<uint32_t>(2 * static_cast<uint64_t>(limits.adjacencies));
    region_sets = workspace.take<uint32_t>(limits.cells);
  }

  CubeCover cover;
  EmptyRuns runs;
  FixedVector<FreeCell> cells;
  FixedVector<Landmark> landmarks;
  CellContacts contacts;
  Span<uint32_t> first_part;       // [entries + 1]
  Span<uint32_t> first_neighbour;  // [cells + 1]
  Span<uint32_t> neighbour;        // [2 adjacencies]
  Span<uint32_t> region_sets;      // [cells] scratch memory of the builder
  int64_t side = 1;
  uint32_t regions = 0;
  uint32_t power_cells = 0;  // how many are not empty
};

}  // namespace hsp
