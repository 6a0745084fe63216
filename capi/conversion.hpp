// The only place where the C interface and the rooms of lib/ meet: what is behind the handles, and how values cross.
#pragma once

#include "boundary/boundary.hpp"
#include "core/status.hpp"
#include "core/workspace.hpp"
#include "grid/cube_grid.hpp"
#include "hardsphere.h"

struct hsp_model {
  hsp::CubeGrid grid;
  uint64_t revision;  // counts hsp_model_set, so that a boundary notices when its model has changed
};

struct hsp_boundary {
  hsp::BoundaryBuilder builder;
  hsp::BoundaryLimits limits;
  const hsp_model *model;  // what was computed last, or null
  uint64_t revision;
  bool attempted;  // the builder's needed() means something
  bool complete;   // and the structure is there
};

namespace hsp::capi {

constexpr int32_t to_c(Status status) {
  return static_cast<int32_t>(status);
}

static_assert(to_c(Status::ok) == HSP_OK && to_c(Status::argument) == HSP_E_ARGUMENT);
static_assert(to_c(Status::capacity) == HSP_E_CAPACITY && to_c(Status::memory) == HSP_E_MEMORY);
static_assert(to_c(Status::state) == HSP_E_STATE && to_c(Status::id) == HSP_E_ID);
static_assert(to_c(Status::check) == HSP_E_CHECK);
static_assert(to_c(Status::not_finite) == HSP_E_NOT_FINITE && to_c(Status::negative) == HSP_E_NEGATIVE);
static_assert(to_c(Status::range) == HSP_E_RANGE);
static_assert(no_id == HSP_NONE);

// Whether results may be read: computed, and the model unchanged since.
inline bool has_results(const hsp_boundary &boundary) {
  return boundary.complete && boundary.revision == boundary.model->revision;
}

// The part every (out, capacity, needed) function shares: HSP_OK means that exactly `count` records are to be written.
inline int32_t check_output(const void *out, uint32_t capacity, uint32_t count, uint32_t *needed) {
  *needed = count;
  if (count > capacity) return HSP_E_CAPACITY;
  return out == nullptr && count > 0 ? HSP_E_ARGUMENT : HSP_OK;
}

}  // namespace hsp::capi
