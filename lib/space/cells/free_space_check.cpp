#include "cells/free_space_check.hpp"

#include "core/disjoint_sets.hpp"
#include "core/first_index.hpp"

namespace hsp {
namespace {

class FreeSpaceCheck : FirstViolation<FreeSpaceInvariant> {
 public:
  FreeSpaceCheck(const BallSet &balls, const FreeSpace &space, FreeSpaceScratch scratch)
      : balls_(balls), space_(space), cell_(scratch.cell), sets_(scratch.sets), planes_(scratch.planes) {}

  FreeSpaceViolation run() {
    if (records() && neighbours() && regions()) power_cells();
    return violation_;
  }

 private:
  // The record of a cell must be the one that belongs at its number.
  bool records() {
    const uint32_t cells = space_.cell_count(), runs = space_.run_count(), entries = space_.cover.entries();
    if (runs == 0 || space_.first_part[0] != runs || space_.first_part[entries] != cells)
      return fail(FreeSpaceInvariant::records, 0);
    for (uint32_t c = 0; c < cells; ++c) {
      const FreeCell &cell = space_.cell(c);
      const uint32_t end = c + 1 < cells ? space_.cell(c + 1).first_landmark : space_.landmarks.size();
      const bool is_run = cell.kind == CellKind::run && cell.cube == no_id && cell.ball == no_id;
      const bool is_part = (cell.kind == CellKind::at_ball || cell.kind == CellKind::apart) && cell.cube != no_id;
      if (!(c < runs ? is_run : is_part) || cell.first_landmark > end || cell.region >= space_.region_count())
        return fail(FreeSpaceInvariant::records, c);
    }
    for (uint32_t k = 0; k < space_.cube_count(); ++k) {
      const Span<const uint32_t> members = space_.cover.balls(k);
      for (uint32_t m = 0; m < members.size(); ++m) {
        const IdRange parts = space_.parts_of(space_.cover.first_entry(k) + m);
        if (parts.first > parts.last || parts.last > cells) return fail(FreeSpaceInvariant::records, cells);
        for (const uint32_t c : parts) {
          const FreeCell &cell = space_.cell(c);
          const bool whole = parts.size() == 1;
          if (cell.cube != k || cell.ball != members[m] || space_.landmarks_of(c).empty() != whole ||
              (cell.kind == CellKind::apart && !whole))
            return fail(FreeSpaceInvariant::records, c);
        }
      }
    }
    return true;
  }

  static bool holds(Span<const uint32_t> ascending, uint32_t wanted) {
    const uint32_t at = first_index(0, ascending.size(), [&](uint32_t k) { return ascending[k] >= wanted; });
    return at < ascending.size() && ascending[at] == wanted;
  }

  bool neighbours() {
    const uint32_t cells = space_.cell_count();
    const uint64_t sides = 2 * uint64_t{space_.adjacency_count()};
    if (space_.first_neighbour[0] != 0 || space_.first_neighbour[cells] != sides)
      return fail(FreeSpaceInvariant::neighbours, 0);
    for (uint32_t c = 0; c < cells; ++c) {
      const uint32_t first = space_.first_neighbour[c], last = space_.first_neighbour[c + 1];
      if (first > last || last > sides) return fail(FreeSpaceInvariant::neighbours, c);
    }
    for (uint32_t c = 0; c < cells; ++c) {
      const Span<const uint32_t> list = space_.neighbours(c);
      for (uint32_t k = 0; k < list.size(); ++k) {
        const bool good = list[k] < cells && list[k] != c && (k == 0 || list[k - 1] < list[k]);
        if (!good || !holds(space_.neighbours(list[k]), c)) return fail(FreeSpaceInvariant::neighbours, c);
      }
    }
    for (const AdjacentCells &pair : space_.contacts.items()) {
      const auto [a, b] = pair.cell;
      if (a >= cells || b >= cells || !holds(space_.neighbours(a), b)) return fail(FreeSpaceInvariant::neighbours, a);
    }
    return true;
  }

  // Uses the lists of neighbours, whereas the build uses the pairs.
  bool regions() {
    const uint32_t cells = space_.cell_count();
    DisjointSets sets(sets_.part(0, cells));
    sets.reset();
    for (uint32_t c = 0; c < cells; ++c) {
      for (const uint32_t other : space_.neighbours(c)) static_cast<void>(sets.join(c, other));
    }
    uint32_t found = 0;
    for (uint32_t c = 0; c < cells; ++c) {
      const uint32_t root = sets.root(c);
      if (space_.cell(c).region != (root == c ? found++ : space_.cell(root).region))
        return fail(FreeSpaceInvariant::regions, c);
    }
    return found == space_.region_count() || fail(FreeSpaceInvariant::regions, cells);
  }

  // Invariants 4 and 5, with each power cell cut once; of 5 the first violation, if 4 has none.
  void power_cells() {
    FreeSpaceViolation across;
    uint32_t found = 0;
    for (uint32_t k = 0; k < space_.cube_count(); ++k) {
      cube_ = k;
      const CubeCoordinates &at = space_.cover.cube(k);
      const Span<const uint32_t> members = space_.cover.balls(k);
      for (uint32_t side = 0; side < cube_sides; ++side) {
        const CubeCoordinates there = beside(at, side);
        cube_beside_[side] = space_.cover.find(there);
        run_beside_[side] = cube_beside_[side] == no_id ? space_.runs.find(space_.cover, there) : no_id;
      }
      const CubeFrame frame(at, space_.side);
      cell_.enter(balls_, frame, members);
      cell_.drop_dominated();
      for (uint32_t m = 0; m < members.size(); ++m) {
        const IdRange parts = space_.parts_of(space_.cover.first_entry(k) + m);
        cell_.build(m);
        found += cell_.empty() ? 0 : 1;
        if (!cell_.empty()) cell_.find_free_parts();
        if (!is_polytope(members.size()) || !has_parts(parts)) {
          fail(FreeSpaceInvariant::power_cells, k);
          return;
        }
        for (const uint32_t c : parts) {
          if (across.invariant == FreeSpaceInvariant::none && !has_neighbours_across(c, c - parts.first))
            across = {FreeSpaceInvariant::facets, c};
        }
      }
    }
    if (found != space_.power_cells) {
      fail(FreeSpaceInvariant::power_cells, space_.cube_count());
    } else {
      violation_ = across;
    }
  }

  // Three planes at each vertex and two on each edge, which both its ends name; and Euler's relation, with 3 V / 2
  // edges.
  bool is_polytope(uint32_t members) {
    const PowerPolytope &polytope = cell_.polytope();
    if (cell_.empty()) return true;
    plane_count_ = cube_sides + members;
    for (uint32_t number = 0; number < plane_count_; ++number) planes_[number] = 0;
    for (uint32_t v = 0; v < polytope.size(); ++v) {
      const PolytopeVertex &vertex = polytope[v];
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = vertex.plane[(k + 1) % 3], b = vertex.plane[(k + 2) % 3];
        const uint32_t other = vertex.neighbour(k);
        if (vertex.plane[k] >= plane_count_ || a == b || other >= polytope.size() || other == v) return false;
        const PolytopeVertex &end = polytope[other];
        if (!end.has(a) || !end.has(b) || end.has(vertex.plane[k])) return false;
        for (uint32_t back = 0; back < 3; ++back) {
          const bool along = end.plane[back] != a && end.plane[back] != b;
          if (along && (end.neighbour(back) != v || vertex.back(k) != back)) return false;
        }
        planes_[vertex.plane[k]] = 1;
      }
    }
    uint32_t facets = 0;
    for (uint32_t number = 0; number < plane_count_; ++number) facets += planes_[number];
    return 2 * facets == polytope.size() + 4;
  }

  bool has_parts(IdRange parts) const {
    const uint32_t expected = cell_.empty() ? 0 : cell_.parts();
    if (parts.size() != expected) return false;
    if (expected == 1) {
      return (space_.cell(parts.first).kind == CellKind::at_ball) == cell_.meets_ball();
    }
    for (const uint32_t c : parts) {
      uint32_t vertices = 0;
      for (uint32_t v = 0; v < cell_.polytope().size(); ++v) {
        vertices += cell_.part_of(v) == c - parts.first ? 1 : 0;
      }
      if (vertices != space_.landmarks_of(c).size()) return false;
    }
    return true;
  }

  // Each plane with a vertex of a free part has a neighbour of it on the other side, and there are no other neighbours.
  bool has_neighbours_across(uint32_t c, uint32_t part) {
    const PowerPolytope &polytope = cell_.polytope();
    constexpr uint8_t none = 0, facet = 1, crossed = 2;
    for (uint32_t number = 0; number < plane_count_; ++number) planes_[number] = none;
    for (uint32_t v = 0; v < polytope.size(); ++v) {
      if (cell_.part_of(v) != part) continue;
      for (const uint32_t number : polytope[v].plane) planes_[number] = facet;
    }
    for (const uint32_t other : space_.neighbours(c)) {
      const uint32_t number = plane_to(other);
      if (number == no_id || planes_[number] == none) return false;
      planes_[number] = crossed;
    }
    for (uint32_t number = 0; number < plane_count_; ++number) {
      if (planes_[number] == facet) return false;
    }
    return true;
  }

  // The plane of a power cell of this cube beyond which another cell lies.
  uint32_t plane_to(uint32_t other) const {
    const FreeCell &cell = space_.cell(other);
    if (cell.cube == cube_) {
      const Span<const uint32_t> members = space_.cover.balls(cube_);
      for (uint32_t m = 0; m < members.size(); ++m) {
        if (members[m] == cell.ball) return cube_sides + m;
      }
      return no_id;
    }
    for (uint32_t side = 0; side < cube_sides; ++side) {
      if (cell.kind == CellKind::run ? run_beside_[side] == other : cube_beside_[side] == cell.cube) return side;
    }
    return no_id;
  }

  const BallSet &balls_;
  const FreeSpace &space_;
  PowerCell &cell_;
  Span<uint32_t> sets_;
  Span<uint8_t> planes_;
  uint32_t plane_count_ = 0;
  uint32_t cube_ = 0;
  uint32_t cube_beside_[cube_sides]{}, run_beside_[cube_sides]{};
};

}  // namespace

FreeSpaceViolation check_free_space(const BallSet &balls, const FreeSpace &space, FreeSpaceScratch scratch) {
  return FreeSpaceCheck(balls, space, scratch).run();
}

}  // namespace hsp
