// The only place where the C interface and the rooms of lib/ meet: what is behind the handles, and how values cross.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "core/status.hpp"
#include "core/workspace.hpp"
#include "hardsphere.h"
#include "measure/positions.hpp"
#include "model/cube_grid.hpp"
#include "topology/topology_builder.hpp"
#include "view/view_builder.hpp"

struct hsp_model {
  hsp::CubeGrid grid;
  uint64_t revision;  // counts hsp_model_set, so that a boundary notices when its model has changed
};

struct hsp_boundary {
  hsp::BoundaryBuilder builder;
  const hsp_model *model;  // what was computed last, or null
  uint64_t revision;
  uint64_t computed;  // counts hsp_boundary_compute, so that a topology notices when its boundary has changed
  bool attempted;     // the builder's needed() means something
  bool complete;      // and the structure is there
};

struct hsp_topology {
  hsp::TopologyBuilder builder;
  const hsp_boundary *boundary;  // what was computed last, or null
  uint64_t computed;
  bool attempted;
  bool complete;
};

struct hsp_view {
  hsp::ViewBuilder builder;
  const hsp_model *model;  // what was computed last, or null
  uint64_t revision;
  bool attempted;
  bool complete;
};

namespace hsp::capi {

constexpr int32_t to_c(Status status) {
  return static_cast<int32_t>(status);
}

static_assert(to_c(Status::ok) == HSP_OK && to_c(Status::argument) == HSP_E_ARGUMENT);
static_assert(to_c(Status::capacity) == HSP_E_CAPACITY && to_c(Status::memory) == HSP_E_MEMORY);
static_assert(to_c(Status::state) == HSP_E_STATE && to_c(Status::id) == HSP_E_ID);
static_assert(to_c(Status::check) == HSP_E_CHECK && to_c(Status::sink) == HSP_E_SINK);
static_assert(to_c(Status::not_finite) == HSP_E_NOT_FINITE && to_c(Status::negative) == HSP_E_NEGATIVE);
static_assert(to_c(Status::range) == HSP_E_RANGE);
static_assert(no_id == HSP_NONE);

// The rule of the header for every computation: a call that fails leaves the handle without results, and only a lack of
// capacity leaves limits to be read. `forget` comes before the first refusal, `remember` after the computation.
template <class Handle>
void forget(Handle &handle) {
  handle.attempted = false;
  handle.complete = false;
}

template <class Handle>
int32_t remember(Handle &handle, Status status) {
  handle.attempted = status == Status::ok || status == Status::capacity;
  handle.complete = status == Status::ok;
  return to_c(status);
}

// Whether results may be read: computed, and the model unchanged since.
inline bool has_results(const hsp_boundary &boundary) {
  return boundary.complete && boundary.revision == boundary.model->revision;
}

inline bool has_results(const hsp_topology &topology) {
  return topology.complete && topology.computed == topology.boundary->computed && has_results(*topology.boundary);
}

inline bool has_results(const hsp_view &view) {
  return view.complete && view.revision == view.model->revision;
}

inline void to_array(const Vec3 &v, double out[3]) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

// A position in the caller's coordinates.
inline void to_position(const BallSet &balls, const Position &position, double xyz[3]) {
  xyz[0] = balls.lattice.length(balls.x[position.ball] + position.offset.x);
  xyz[1] = balls.lattice.length(balls.y[position.ball] + position.offset.y);
  xyz[2] = balls.lattice.length(balls.z[position.ball] + position.offset.z);
}

// The part every (out, capacity, needed) function shares: HSP_OK means that exactly `count` records are to be written.
inline int32_t check_output(const void *out, uint32_t capacity, uint32_t count, uint32_t *needed) {
  *needed = count;
  if (count > capacity) return HSP_E_CAPACITY;
  return out == nullptr && count > 0 ? HSP_E_ARGUMENT : HSP_OK;
}

// What every copying function of a computed handle checks: arguments, state, and that exactly count(*handle) records
// fit.
template <class Handle, class Count>
int32_t check_request(const Handle *handle, const void *out, uint32_t capacity, uint32_t *needed, Count count) {
  if (handle == nullptr || needed == nullptr || (out == nullptr && capacity > 0)) return HSP_E_ARGUMENT;
  if (!has_results(*handle)) return HSP_E_STATE;
  return check_output(out, capacity, count(*handle), needed);
}

}  // namespace hsp::capi
