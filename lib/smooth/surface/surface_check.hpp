// The invariants of a smooth surface as a map, and of the areas of its patches, checked from its records and positions.
#pragma once

#include "core/violation.hpp"
#include "surface/surface_map.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class SurfaceInvariant : uint32_t {
  none = 0,
  rings = 1,
  steps = 2,
  loops = 3,
  creases = 4,
  corners = 5,
  shells = 6,
  areas = 7,
  closure = 8,
  totals = 9,
};

// Its id is that of a directed edge, patch, vertex or shell, as the invariant demands; no_id for some sums over all.
using SurfaceViolation = Violation<SurfaceInvariant>;

SurfaceViolation check_surface(const SurfaceMap &map);

// Calls add(shell, n) for all parts of the shells' Euler characteristics: a corner counts 1, an edge -1, a patch with k
// loops 2 - k. A whole circle is no edge, and has no corner.
template <class Add>
void count_euler(const SurfaceMap &map, Add add) {
  for (uint32_t h = 0; h < 2 * map.edge_count(); h += 2) {
    if (map.origin(h) != no_id) add(map.shell_of(map.left(h)), -1);
  }
  for (uint32_t corner = 0; corner < map.corner_count(); ++corner) {
    const uint32_t shell = map.shell_of_corner(corner);
    if (shell != no_id) add(shell, 1);
    const uint32_t other = map.other_shell_of_cusp(corner);
    if (other != no_id) add(other, 1);
  }
  for (uint32_t patch = 0; patch < map.patch_count(); ++patch) {
    int32_t loops = 0;
    map.for_each_loop(patch, [&loops](uint32_t) { ++loops; });
    add(map.shell_of(patch), 2 - loops);
  }
}

}  // namespace hsp
