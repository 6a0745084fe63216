// The inside of the handle hsp_cells.
#pragma once

#include "cells/free_space_builder.hpp"
#include "hsp_model.hpp"

struct hsp_cells : hsp::capi::FromModel<hsp::FreeSpaceBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::cells;
  using Given = hsp_cells_limits;
  using Limits = hsp::capi::LimitFields<hsp::FreeSpaceLimits, Given, offsetof(Given, cubes), offsetof(Given, entries),
                                        offsetof(Given, cells), offsetof(Given, adjacencies),
                                        offsetof(Given, landmarks), offsetof(Given, facets), offsetof(Given, corners),
                                        offsetof(Given, cube_balls), offsetof(Given, cube_corners)>;
};
