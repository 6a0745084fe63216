// The inside of the handle hsp_surface.
#pragma once

#include "hsp_boundary.hpp"
#include "surface/surface_builder.hpp"

struct hsp_surface : hsp::capi::FromBoundary<hsp::SurfaceBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::surface;
  using Given = hsp_surface_limits;
  using Limits = hsp::capi::LimitFields<hsp::SurfaceLimits, Given, offsetof(Given, vertices), offsetof(Given, faces),
                                        offsetof(Given, neighbours), offsetof(Given, pieces), offsetof(Given, arcs),
                                        offsetof(Given, cusped_circles)>;

  const hsp::Surface &structure() const { return builder.surface(); }
};
