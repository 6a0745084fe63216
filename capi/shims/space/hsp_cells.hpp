// The inside of the handle hsp_cells.
#pragma once

#include "cells/free_space_builder.hpp"
#include "hsp_model.hpp"
#include "source.hpp"

struct hsp_cells {
  using Builder = hsp::FreeSpaceBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::cells;
  using Given = hsp_cells_limits;
  using Limits = hsp::capi::LimitFields<hsp::FreeSpaceLimits, Given, offsetof(Given, cubes), offsetof(Given, entries),
                                        offsetof(Given, cells), offsetof(Given, adjacencies),
                                        offsetof(Given, landmarks), offsetof(Given, facets), offsetof(Given, corners),
                                        offsetof(Given, cube_balls), offsetof(Given, cube_corners)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && model.is_unchanged(); }
  const hsp::FreeSpace &structure() const { return builder.structure(); }
  const hsp::BallSet &balls() const { return model->balls(); }
};
