// What is behind the handle hsp_model.
#pragma once

#include "handle_memory.hpp"
#include "model/cube_grid.hpp"
#include "source.hpp"

struct hsp_model {
  using Builder = hsp::CubeGrid;
  static constexpr auto kind = hsp::capi::HandleKind::model;

  uintptr_t tag;
  Builder grid;
  uint64_t revision = 0;  // counts hsp_model_set, so that a boundary notices when its model has changed

  uint64_t version() const { return revision; }
  static constexpr bool has_results() { return true; }  // of no ball at least
  const hsp::BallSet &balls() const { return grid.balls(); }
};
