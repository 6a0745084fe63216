// What all handles have in common: they lie at the start of the caller's memory, with what their builder carves behind
// them, and they hold results or none.
//
// A handle is a struct with a tag (handle_tag.hpp), then its builder, named by its member type Builder, and default
// values for the rest.
#pragma once

#include "conversion.hpp"
#include "core/workspace.hpp"
#include "handle_tag.hpp"
#include "versioned_struct.hpp"

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

// hsp_X_limits_init: the defaults of a kind of limits, for so many balls.
template <class Defaults, auto convert, class Limits>
int32_t init_limits(Limits *limits, uint32_t struct_size, uint32_t balls) {
  if (const int32_t status = check_struct(limits, struct_size); status != HSP_OK) return status;
  Defaults defaults;
  const Status status = default_limits(balls, defaults);
  if (status == Status::ok) write_struct(convert(defaults), limits, struct_size);
  return to_c(status);
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
  *carved = Handle{tag_of(carved), builder};
  *handle = carved;
  return HSP_OK;
}

// What every hsp_X_compute ends with. `limits` may be null. It becomes what was needed, or after a lack of capacity
// what to retry with: no limit is smaller than the handle's, and one at least is larger.
template <auto convert, class Handle, class Limits>
int32_t finish(Handle &handle, Status status, Limits *limits) {
  handle.complete = status == Status::ok;
  if (limits != nullptr && (status == Status::ok || status == Status::capacity)) {
    const auto enough = handle.complete ? handle.builder.needed() : handle.builder.retry_limits();
    write_struct(convert(enough), limits, limits->struct_size);
  }
  return to_c(status);
}

}  // namespace hsp::capi
