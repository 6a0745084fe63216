// The inside of the handles hsp_paths and hsp_gate.
#pragma once

#include "hsp_model.hpp"
#include "paths/path_finder.hpp"
#include "pockets/gate_finder.hpp"
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

struct hsp_gate {
  using Builder = hsp::GateFinder;
  static constexpr auto kind = hsp::capi::HandleKind::gate;
  using Given = hsp_gate_limits;
  using Limits =
      hsp::capi::LimitFields<hsp::ProbeLimits, Given, offsetof(Given, cubes), offsetof(Given, entries),
                             offsetof(Given, cells), offsetof(Given, adjacencies), offsetof(Given, landmarks),
                             offsetof(Given, facets), offsetof(Given, corners), offsetof(Given, cube_balls),
                             offsetof(Given, cube_corners), offsetof(Given, balls)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  hsp::WidestProbe widest{};
  bool complete = false;

  bool has_results() const { return complete && model.is_unchanged(); }
};
