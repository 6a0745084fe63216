#include "model/cube_order.hpp"

#include "core/sorting.hpp"

namespace hsp {

void order_cubes_by_rows(CubeTable &table, CubeOrderScratch scratch) {
  const uint32_t cubes = table.count();
  const uint32_t slots = static_cast<uint32_t>(CubeTable::slots_for(cubes));
  for (uint32_t k = 0; k < slots; ++k) scratch.slots[k] = no_id;
  const auto same_row = [&table](uint32_t a, uint32_t b) {
    return table.coordinates(a).y == table.coordinates(b).y && table.coordinates(a).z == table.coordinates(b).z;
  };
  // The slot of a cube's row holds the first cube that was met in it.
  const auto row_slot = [&](uint32_t cube) {
    const CubeCoordinates &at = table.coordinates(cube);
    CubeProbe probe(linear_hash({0, at.y, at.z}), slots);
    while (scratch.slots[probe.slot] != no_id && !same_row(scratch.slots[probe.slot], cube)) probe.next();
    return probe.slot;
  };
  // Each row is a circular list through its first cube.
  for (uint32_t cube = 0; cube < cubes; ++cube) {
    const uint32_t slot = row_slot(cube);
    if (scratch.slots[slot] == no_id) {
      scratch.slots[slot] = cube;
      scratch.links[cube] = cube;
    } else {
      const uint32_t first = scratch.slots[slot];
      scratch.links[cube] = scratch.links[first];
      scratch.links[first] = cube;
    }
  }
  uint32_t placed = 0;
  for (uint32_t cube = 0; cube < cubes; ++cube) {
    if (scratch.slots[row_slot(cube)] != cube) continue;
    const uint32_t start = placed;
    uint32_t member = cube;
    do {
      scratch.order[placed++] = member;
      member = scratch.links[member];
    } while (member != cube);
    sort_in_place(scratch.order.part(start, placed),
                  [&table](uint32_t a, uint32_t b) { return table.coordinates(a).x < table.coordinates(b).x; });
    for (uint32_t k = start; k < placed; ++k) scratch.links[scratch.order[k]] = k;
  }
  table.renumber(scratch.links, scratch.order);
}

}  // namespace hsp
