#include "cells/free_space_builder.hpp"

#include <bit>

#include "core/disjoint_sets.hpp"

namespace hsp {

void FreeSpaceBuilder::carve(Workspace &workspace, const FreeSpaceLimits &limits, bool with_portals) {
  limit(limits);
  structure_.carve(workspace, limits, with_portals);
  cell_.carve(workspace, limits.cube_balls);
  contacts_.carve(workspace, limits.cube_balls, limits.cube_corners);
  overlay_.carve(workspace, limits.cube_balls);
  kept_.carve(workspace, limits.facets, limits.corners);
  open_.carve(workspace, clamped_count(3 * PowerPolytope::most_planes(limits.cube_balls)), limits.cube_corners);
  first_kept_ = workspace.take<uint32_t>(static_cast<uint64_t>(limits.cubes) + 1);
  touched_ = workspace.take<uint8_t>(PowerPolytope::most_vertices(limits.cube_balls));
}

Status FreeSpaceBuilder::build(const CubeGrid &grid, Patience patience) {
  const BallSet &balls = grid.balls();
  FreeSpace &space = structure_;
  needed_ = {};
  contacts_known_ = true;
  space.cells.clear();
  space.landmarks.clear();
  space.contacts.clear();
  kept_.clear();
  space.side = grid.side();
  space.regions = space.power_cells = 0;
  const bool covered = space.cover.build(grid, patience);
  if (!patience.allows(0)) return Status::stopped;
  needed_.cubes = space.cover.needed_cubes();
  needed_.entries = space.cover.needed_entries();
  if (!covered) return Status::capacity;
  needed_.cube_balls = space.cover.most_balls();
  if (needed_.cube_balls > limits_.cube_balls) return Status::capacity;

  add_runs(patience);
  for (uint32_t &next : beside_) next = 0;
  for (uint32_t k = 0; k < space.cover.cubes(); ++k) {
    const Status status = add_cube(balls, surroundings(k), patience);
    if (status != Status::ok) return status;
  }
  space.first_part[space.cover.entries()] = clamped_count(space.cells.required());
  if (!gather_needs()) return Status::capacity;
  link_cells(patience);
  find_regions(patience);
  return patience.allows(0) ? Status::ok : Status::stopped;
}

// Whether there was room for everything.
bool FreeSpaceBuilder::gather_needs() {
  note(needed_.cells, structure_.cells.required());
  note(needed_.landmarks, structure_.landmarks.required());
  note(needed_.facets, kept_.facets().required());
  note(needed_.corners, kept_.corners().required());
  if (contacts_known_) note(needed_.adjacencies, structure_.contacts.required());
  return contacts_known_ && !structure_.cells.overflowed() && !structure_.landmarks.overflowed() &&
         !structure_.contacts.overflowed();
}

void FreeSpaceBuilder::add_runs(Patience &patience) {
  FreeSpace &space = structure_;
  space.runs.build(space.cover);
  for (uint32_t run = 0; run < space.runs.count(); ++run) space.cells.push({no_id, no_id, CellKind::run, 0, 0});
  space.runs.for_each_contact(space.cover, [&](uint32_t a, uint32_t b) {
    static_cast<void>(patience.allows(50));
    space.contacts.push({{a, b}});
  });
}

// The cube with its neighbours. Has to be called for each cube in turn: the neighbours on one side come in order, too.
FreeSpaceBuilder::Cube FreeSpaceBuilder::surroundings(uint32_t number) {
  const CubeCover &cover = structure_.cover;
  const CubeCoordinates &at = cover.cube(number);
  Cube cube{number, CubeFrame(at, structure_.side), {}, {}};
  for (uint32_t side = 0; side < cube_sides; ++side) {
    const CubeCoordinates there = beside(at, side);
    uint32_t next = beside_[side];
    while (next < cover.cubes() && comes_before(cover.cube(next), there)) ++next;
    beside_[side] = next;
    cube.neighbour[side] = next < cover.cubes() && cover.cube(next) == there ? next : no_id;
    cube.run[side] = cube.neighbour[side] == no_id ? structure_.runs.find(cover, there) : no_id;
  }
  return cube;
}

Status FreeSpaceBuilder::add_cube(const BallSet &balls, const Cube &cube, Patience &patience) {
  FreeSpace &space = structure_;
  const Span<const uint32_t> members = space.cover.balls(cube.number);
  cell_.enter(balls, cube.frame, members);
  cell_.drop_dominated();
  contacts_.clear(members.size());
  open_.clear();
  first_kept_[cube.number] = clamped_count(kept_.facets().required());
  for (uint32_t k = 0; k < members.size(); ++k) {
    if (!patience.allows(3000 + 50 * uint64_t{members.size()})) return Status::stopped;
    const uint32_t first_cell = clamped_count(space.cells.required());
    space.first_part[space.cover.first_entry(cube.number) + k] = first_cell;
    cell_.build_unless_covered(k);
    if (cell_.empty()) continue;
    ++space.power_cells;
    cell_.find_free_parts();
    if (cell_.parts() == 0) continue;
    add_parts(cube);
    const Status status = contacts_.add(balls, cell_, k, first_cell, space.contacts);
    if (status == Status::check) return status;
    if (status == Status::capacity) contacts_known_ = false;
    // Which sides have free vertices cannot be predicted, so that no branch depends on it.
    uint32_t free_sides = 0;
    for (uint32_t side = 0; side < cube_sides; ++side)
      free_sides |= (cell_.first_free(side) != no_id ? 1U : 0U) << side;
    for (; free_sides != 0; free_sides &= free_sides - 1) {
      const uint32_t side = static_cast<uint32_t>(std::countr_zero(free_sides)), first = cell_.first_free(side);
      if (cube.neighbour[side] == no_id) {
        touch_run(cube, side, first, first_cell);
      } else {
        const bool meets_both = meets_cube(balls.ball(members[k]), space.cover.cube(cube.neighbour[side]), space.side);
        (side % 2 == 0 ? open_ : kept_).add(cell_, side, first, first_cell, meets_both);
      }
    }
  }
  note(needed_.cube_corners, contacts_.needed_corners());
  note(needed_.cube_corners, open_.corners().required());
  first_kept_[cube.number + 1] = clamped_count(kept_.facets().required());
  if (kept_.overflowed() || open_.overflowed()) contacts_known_ = false;
  return contacts_known_ ? touch_cubes(balls, cube) : Status::ok;
}

// Adds the free parts of a power cell as cells.
void FreeSpaceBuilder::add_parts(const Cube &cube) {
  FreeSpace &space = structure_;
  const PowerPolytope &polytope = cell_.polytope();
  for (uint32_t part = 0; part < cell_.parts(); ++part) {
    const CellKind kind = cell_.parts() > 1 || cell_.meets_ball() ? CellKind::at_ball : CellKind::apart;
    space.cells.push({cube.number, cell_.ball(), kind, 0, clamped_count(space.landmarks.required())});
    if (cell_.parts() == 1) continue;
    for (uint32_t v = 0; v < polytope.size(); ++v) {
      if (cell_.part_of(v) != part) continue;
      const uint32_t *const plane = polytope[v].plane;
      space.landmarks.push({{cell_.code_of(plane[0]), cell_.code_of(plane[1]), cell_.code_of(plane[2])}});
    }
  }
}

// Adds the contacts of a power cell with the run beyond a side: no ball meets the cube there, so that all of it is
// free. `first` is the first vertex on that side outside the ball.
void FreeSpaceBuilder::touch_run(const Cube &cube, uint32_t side, uint32_t first, uint32_t first_cell) {
  const PowerPolytope &polytope = cell_.polytope();
  for (uint32_t part = 0; part < cell_.parts(); ++part) touched_[part] = 0;
  for (uint32_t v = first; v < polytope.size(); ++v) {
    const uint32_t part = cell_.part_of(v);
    if (part == no_id || touched_[part] != 0 || !polytope[v].has(side)) continue;
    touched_[part] = 1;
    const Vec3 at = structure_.contacts.has_portals() ? cell_.position(v) : Vec3{};
    structure_.contacts.push({{cube.run[side], first_cell + part}}, cube.frame, at);
    if (cell_.parts() == 1) return;
  }
}

Status FreeSpaceBuilder::touch_cubes(const BallSet &balls, const Cube &cube) {
  for (uint32_t axis = 0; axis < 3; ++axis) {
    const uint32_t below = cube.neighbour[2 * axis];
    if (below == no_id) continue;
    const FacetOverlay::Side lower{kept_, {first_kept_[below], first_kept_[below + 1]}};
    const FacetOverlay::Side upper{open_, {0, open_.facets().size()}};
    const Status status = overlay_.find(balls, cube.frame, axis, lower, upper, structure_.contacts);
    if (status == Status::check) return status;
    note(needed_.cube_balls, overlay_.needed_balls());
    if (status == Status::capacity) {
      contacts_known_ = false;
      break;
    }
  }
  return Status::ok;
}

// Makes the lists of neighbours from the contacts: of each cell those before it, then those behind it. Cells are
// entered into the lists of others in ascending order, so that no list has to be sorted.
void FreeSpaceBuilder::link_cells(Patience &patience) {
  FreeSpace &space = structure_;
  const uint32_t cells = space.cells.size();
  uint32_t *const first = space.first_neighbour.data(), *const end = space.region_sets.data();
  uint32_t *const neighbour = space.neighbour.data();
  const Span<const AdjacentCells> contacts = space.contacts.items();
  const auto lower_of = [](const AdjacentCells &pair) {
    return pair.cell[0] < pair.cell[1] ? pair.cell[0] : pair.cell[1];
  };
  for (uint32_t c = 0; c < cells; ++c) first[c] = end[c] = 0;
  for (const AdjacentCells &pair : contacts) {
    if (!patience.allows(20)) return;
    const uint32_t low = lower_of(pair);
    ++end[pair.cell[0] ^ pair.cell[1] ^ low];
    ++first[low];
  }
  uint32_t count = 0;
  for (uint32_t c = 0; c < cells; ++c) {
    if (!patience.allows(20)) return;
    const uint32_t neighbours = end[c] + first[c];
    first[c] = end[c] = count;
    count += neighbours;
  }
  first[cells] = count;
  // First the cells before each cell, in the order of contacts; then those behind it, in order; then those before it
  // once more, in order.
  for (const AdjacentCells &pair : contacts) {
    if (!patience.allows(20)) return;
    const uint32_t low = lower_of(pair);
    neighbour[end[pair.cell[0] ^ pair.cell[1] ^ low]++] = low;
  }
  for (uint32_t c = 0; c < cells; ++c) {
    if (!patience.allows(50)) return;
    for (uint32_t k = first[c], before = end[c]; k < before; ++k) neighbour[end[neighbour[k]]++] = c;
  }
  for (uint32_t c = 0; c < cells; ++c) end[c] = first[c];
  for (uint32_t c = 0; c < cells; ++c) {
    if (!patience.allows(50)) return;
    for (uint32_t k = end[c]; k < first[c + 1]; ++k) neighbour[end[neighbour[k]]++] = c;
  }
}

void FreeSpaceBuilder::find_regions(Patience &patience) {
  FreeSpace &space = structure_;
  const uint32_t cells = space.cells.size();
  DisjointSets sets(space.region_sets.part(0, cells));
  sets.reset();
  for (const AdjacentCells &pair : space.contacts.items()) {
    if (!patience.allows(50)) return;
    static_cast<void>(sets.join(pair.cell[0], pair.cell[1]));
  }

  for (uint32_t c = 0; c < cells; ++c) {
    if (!patience.allows(30)) return;
    const uint32_t root = sets.root(c);  // the smallest cell of its set
    space.cells[c].region = root == c ? space.regions++ : space.cells[root].region;
  }
}

}  // namespace hsp
