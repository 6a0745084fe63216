// Handles of the component smooth that own their memory.
#pragma once

#include "owned_handle.hpp"

namespace support {

struct SurfaceKind : KindOf<hsp_surface, hsp_surface_limits, 4, hsp_surface_bytes, hsp_surface_init> {
  static constexpr const char *name = "hsp_surface";
  static constexpr std::array limits = {&Limits::vertices, &Limits::faces, &Limits::neighbours,
                                        &Limits::pieces,   &Limits::arcs,  &Limits::cusped_circles};
  static size_t most_bytes(const Limits &most) {
    return HSP_SURFACE_BYTES(most.vertices, most.faces, most.neighbours, most.pieces, most.arcs, most.cusped_circles);
  }
};
struct MeshKind : KindOf<hsp_mesh, hsp_mesh_limits, 20, hsp_mesh_bytes, hsp_mesh_init> {
  static constexpr const char *name = "hsp_mesh";
  static constexpr std::array limits = {&Limits::balls, &Limits::curves, &Limits::vertices, &Limits::triangles,
                                        &Limits::points};
  static size_t most_bytes(const Limits &most) {
    return HSP_MESH_BYTES(most.balls, most.curves, most.vertices, most.triangles, most.points);
  }
};
using OwnedSurface = OwnedHandle<SurfaceKind>;

inline hsp_surface_limits surface_limits_for(const hsp_boundary *boundary) {
  hsp_surface_limits limits;
  expect_ok(hsp_surface_limits_init(&limits, sizeof limits, boundary), "hsp_surface_limits_init");
  return limits;
}

}  // namespace support
