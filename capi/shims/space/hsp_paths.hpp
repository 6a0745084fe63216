// The inside of the handle hsp_paths.
#pragma once

#include "hsp_model.hpp"
#include "paths/path_finder.hpp"
#include "source.hpp"

struct hsp_paths {
  using Builder = hsp::PathFinder;
  static constexpr auto kind = hsp::capi::HandleKind::paths;
  using Given = hsp_paths_limits;
  using Limits =
      hsp::capi::LimitFields<hsp::PathLimits, Given, offsetof(Given, cubes), offsetof(Given, entries),
                             offsetof(Given, cells), offsetof(Given, adjacencies), offsetof(Given, landmarks),
                             offsetof(Given, facets), offsetof(Given, corners), offsetof(Given, cube_balls),
                             offsetof(Given, cube_corners), offsetof(Given, points)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && model.is_unchanged(); }
};
