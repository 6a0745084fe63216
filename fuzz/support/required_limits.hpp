// Limits below what a handle needs: HSP_E_CAPACITY, nothing written beside the memory, and no more enlargements than
// the header says.
#pragma once

#include <owned_handle.hpp>

#include <cstring>

#include "fuzz_input.hpp"

namespace fuzz {

inline size_t most_bytes(const hsp_surface_limits &limits) {
  return HSP_SURFACE_BYTES(limits.vertices, limits.faces, limits.neighbours, limits.pieces, limits.arcs,
                           limits.cusped_circles);
}
inline size_t most_bytes(const hsp_mesh_limits &limits) {
  return HSP_MESH_BYTES(limits.balls, limits.curves, limits.vertices, limits.triangles, limits.points);
}
inline size_t most_bytes(const hsp_topology_limits &limits) {
  return HSP_TOPOLOGY_BYTES(limits.balls, limits.neighbours, limits.edges, limits.cut_arcs);
}
inline size_t most_bytes(const hsp_contacts_limits &limits) {
  return HSP_CONTACTS_BYTES(limits.balls, limits.neighbours, limits.contacts, limits.triangles, limits.tetrahedra);
}
inline size_t most_bytes(const hsp_view_limits &limits) {
  return HSP_VIEW_BYTES(limits.balls, limits.neighbours, limits.arcs);
}
inline size_t most_bytes(const hsp_map_limits &limits) {
  return HSP_MAP_BYTES(limits.balls, limits.neighbours, limits.edges);
}
inline size_t most_bytes(const hsp_sticks_limits &limits) {
  return HSP_STICKS_BYTES(limits.balls, limits.sticks, limits.pairs, limits.edges);
}
inline size_t most_bytes(const hsp_cells_limits &limits) {
  return HSP_CELLS_BYTES(limits.cubes, limits.entries, limits.cells, limits.adjacencies, limits.landmarks,
                         limits.facets, limits.corners, limits.cube_balls, limits.cube_corners);
}
inline size_t most_bytes(const hsp_paths_limits &limits) {
  return HSP_PATHS_BYTES(limits.cubes, limits.entries, limits.cells, limits.adjacencies, limits.landmarks,
                         limits.facets, limits.corners, limits.cube_balls, limits.cube_corners, limits.points);
}
inline size_t most_bytes(const hsp_gate_limits &limits) {
  return HSP_GATE_BYTES(limits.balls, limits.cubes, limits.entries, limits.cells, limits.adjacencies, limits.landmarks,
                        limits.facets, limits.corners, limits.cube_balls, limits.cube_corners);
}

inline size_t most_bytes(const hsp_pores_limits &limits) {
  return HSP_PORES_BYTES(limits.balls, limits.maxima, limits.gates, limits.tied, limits.candidates, limits.neighbours,
                         limits.points);
}
inline size_t most_bytes(const hsp_periodic_limits &limits) {
  return HSP_PERIODIC_BYTES(limits.balls, limits.images, limits.neighbours, limits.vertices, limits.circles,
                            limits.contacts);
}
inline size_t most_bytes(const hsp_moving_limits &limits) {
  return HSP_MOVING_BYTES(limits.balls, limits.neighbours);
}

// `exact`: the limits that the computation needs. `compute` takes a handle and limits to hand back and returns its
// status, `read` takes it and returns the status of reading; where that is HSP_OK it has compared what it read.
template <class Kind, class Compute, class Read>
void require_limits(const typename Kind::Limits &exact, Bytes &bytes, Compute compute, Read read) {
  typename Kind::Limits limits = exact;
  const uint32_t which = bytes.below(1U << Kind::limits.size());
  for (uint32_t k = 0; k < Kind::limits.size(); ++k) {
    uint32_t &number = limits.*Kind::limits[k];
    if ((which >> k & 1U) != 0) number = bytes.below(number + 1);
  }
  for (int enlargements = 0;; ++enlargements) {
    bool enough = true;
    for (const auto limit : Kind::limits) enough = enough && limits.*limit >= exact.*limit;
    size_t size = 0;
    typename Kind::Handle *handle = nullptr;
    FUZZ_REQUIRE(Kind::bytes(&limits, &size) == HSP_OK, Kind::name);
    FUZZ_REQUIRE(size <= most_bytes(limits), Kind::name);
    std::vector<uint8_t> memory(size + 1, 0x3C);
    FUZZ_REQUIRE(Kind::init(memory.data(), size, &limits, &handle) == HSP_OK, Kind::name);
    typename Kind::Limits returned = limits;
    const int32_t status = compute(handle, &returned);
    FUZZ_REQUIRE(memory.back() == 0x3C, "written past a handle's memory");
    FUZZ_REQUIRE(status == (enough ? HSP_OK : HSP_E_CAPACITY), "status of a computation, by its limits");
    FUZZ_REQUIRE(read(handle) == (enough ? HSP_OK : HSP_E_STATE), "results, by the limits");
    if (enough) {
      FUZZ_REQUIRE(std::memcmp(&returned, &exact, sizeof exact) == 0, "needed limits differ with more room");
      return;
    }
    FUZZ_REQUIRE(enlargements < Kind::enlargements, "more enlargements than promised");
    for (const auto limit : Kind::limits)
      FUZZ_REQUIRE(returned.*limit >= limits.*limit, "a limit to retry with shrinks");
    limits = returned;
  }
}

}  // namespace fuzz
