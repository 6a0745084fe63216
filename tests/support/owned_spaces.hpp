// Handles of the component space that own their memory.
#pragma once

#include "owned_handle.hpp"

namespace support {

struct CellsKind : KindOf<hsp_cells, hsp_cells_limits, 6, hsp_cells_bytes, hsp_cells_init> {
  static constexpr const char *name = "hsp_cells";
  static constexpr std::array limits = {&Limits::cubes,       &Limits::entries,    &Limits::cells,
                                        &Limits::adjacencies, &Limits::landmarks,  &Limits::facets,
                                        &Limits::corners,     &Limits::cube_balls, &Limits::cube_corners};
  static size_t most_bytes(const Limits &most) {
    return HSP_CELLS_BYTES(most.cubes, most.entries, most.cells, most.adjacencies, most.landmarks, most.facets,
                           most.corners, most.cube_balls, most.cube_corners);
  }
};
struct PathsKind : KindOf<hsp_paths, hsp_paths_limits, 7, hsp_paths_bytes, hsp_paths_init> {
  static constexpr const char *name = "hsp_paths";
  static constexpr std::array limits = {&Limits::cubes,        &Limits::entries, &Limits::cells,   &Limits::adjacencies,
                                        &Limits::landmarks,    &Limits::facets,  &Limits::corners, &Limits::cube_balls,
                                        &Limits::cube_corners, &Limits::points};
  static size_t most_bytes(const Limits &most) {
    return HSP_PATHS_BYTES(most.cubes, most.entries, most.cells, most.adjacencies, most.landmarks, most.facets,
                           most.corners, most.cube_balls, most.cube_corners, most.points);
  }
};
struct PoresKind : KindOf<hsp_pores, hsp_pores_limits, 40, hsp_pores_bytes, hsp_pores_init> {
  static constexpr const char *name = "hsp_pores";
  static constexpr std::array limits = {&Limits::balls,      &Limits::maxima,     &Limits::gates, &Limits::tied,
                                        &Limits::candidates, &Limits::neighbours, &Limits::points};
  static size_t most_bytes(const Limits &most) {
    return HSP_PORES_BYTES(most.balls, most.maxima, most.gates, most.tied, most.candidates, most.neighbours,
                           most.points);
  }
};

}  // namespace support
