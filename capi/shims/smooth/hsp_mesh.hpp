// The inside of the handle hsp_mesh.
#pragma once

#include "hsp_surface.hpp"
#include "mesh/mesh_builder.hpp"

struct hsp_mesh : hsp::capi::FromBoundary<hsp::MeshBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::mesh;
  using Given = hsp_mesh_limits;
  using Limits = hsp::capi::LimitFields<hsp::MeshLimits, Given, offsetof(Given, balls), offsetof(Given, curves),
                                        offsetof(Given, vertices), offsetof(Given, triangles), offsetof(Given, points)>;
};
