// What is behind the handle hsp_boundary.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "hsp_model.hpp"

struct hsp_boundary {
  using Builder = hsp::BoundaryBuilder;

  Builder builder;
  const hsp_model *model = nullptr;  // what was computed last
  uint64_t revision = 0;
  uint64_t computed = 0;   // counts hsp_boundary_compute, so that a topology notices when its boundary has changed
  bool attempted = false;  // the builder's needed() means something
  bool complete = false;   // and the boundary is there

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && revision == model->revision; }
  const hsp::Boundary &structure() const { return builder.boundary(); }
  const hsp::BallSet &balls() const { return model->balls(); }
};
