// What all handles have in common: they lie at the start of the caller's memory, with what their builder carves behind
// them, and they hold results or none.
//
// A handle is a struct with its builder first, named by its member type Builder, and default values for the rest.
#pragma once

#include "conversion.hpp"
#include "core/workspace.hpp"

namespace hsp::capi {

template <class Handle, class Limits>
Handle *carve(Workspace &workspace, const Limits &limits, typename Handle::Builder &builder) {
  const Span<Handle> handle = workspace.take<Handle>(1);
  builder.carve(workspace, limits);
  return handle.data();
}

// The bytes that suffice for the limits; 0 if they do not fit a size_t.
template <class Handle, class Limits>
size_t bytes_of(const Limits &limits) {
  Workspace measure;
  typename Handle::Builder builder;
  carve<Handle>(measure, limits, builder);
  return measure.bytes();
}

// What every hsp_X_bytes ends with.
template <class Handle, class Limits>
int32_t get_bytes(const Limits &limits, size_t *bytes) {
  const size_t required = bytes_of<Handle>(limits);
  if (required == 0) return HSP_E_RANGE;
  *bytes = required;
  return HSP_OK;
}

// And every hsp_X_init.
template <class Handle, class Limits>
int32_t init(void *memory, size_t bytes, const Limits &limits, Handle **handle) {
  const size_t required = bytes_of<Handle>(limits);
  if (required == 0) return HSP_E_RANGE;
  if (bytes < required) return HSP_E_MEMORY;
  Workspace workspace(memory, bytes);
  typename Handle::Builder builder;
  Handle *const carved = carve<Handle>(workspace, limits, builder);
  *carved = Handle{builder};
  *handle = carved;
  return HSP_OK;
}

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

}  // namespace hsp::capi
