// The inside of the handle hsp_mesh.
#pragma once

#include "hsp_surface.hpp"
#include "mesh/mesh_builder.hpp"

struct hsp_mesh {
  using Builder = hsp::MeshBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::mesh;
  using Given = hsp_mesh_limits;
  using Limits = hsp::capi::LimitFields<hsp::MeshLimits, Given, offsetof(Given, balls), offsetof(Given, curves),
                                        offsetof(Given, vertices), offsetof(Given, triangles), offsetof(Given, points)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_boundary> boundary{};
  bool complete = false;

  // Whether results may be read: computed, and neither the boundary nor the model has changed since.
  bool has_results() const { return complete && boundary.is_unchanged(); }
};
