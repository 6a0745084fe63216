// The inside of the handle hsp_paths.
#pragma once

#include "hsp_model.hpp"
#include "paths/path_finder.hpp"

struct hsp_paths : hsp::capi::FromModel<hsp::PathFinder> {
  static constexpr auto kind = hsp::capi::HandleKind::paths;
  using Given = hsp_paths_limits;
  using Limits =
      hsp::capi::LimitFields<hsp::PathLimits, Given, offsetof(Given, cubes), offsetof(Given, entries),
                             offsetof(Given, cells), offsetof(Given, adjacencies), offsetof(Given, landmarks),
                             offsetof(Given, facets), offsetof(Given, corners), offsetof(Given, cube_balls),
                             offsetof(Given, cube_corners), offsetof(Given, points)>;
};
