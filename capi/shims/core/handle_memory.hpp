// The memory of all handles: a handle lies at the start of the caller's memory, and the arrays that its builder carves
// lie behind it. A handle holds results or none.
//
// A handle is a struct with a tag (handle_tag.hpp), then its builder, whose type is the member type Builder, and then
// members with default values. If limits fix its memory, their type is the member type Limits (handle_limits.hpp).
#pragma once

#include "conversion.hpp"
#include "core/workspace.hpp"
#include "handle_limits.hpp"
#include "handle_tag.hpp"

namespace hsp::capi {

// Called once for each handle: not inlined, and short, as it is compiled for every kind of handle.
template <class Handle, class Limits>
[[gnu::noinline, gnu::cold]] Handle *carve(Workspace &workspace, const Limits &limits,
                                           typename Handle::Builder &builder) {
  const Span<Handle> handle = workspace.make<Handle>(1);
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

// hsp_X_limits_init: the defaults for so many balls.
template <class Handle>
int32_t init_limits(typename Handle::Limits::InHeader *limits, uint32_t struct_size, uint32_t balls) {
  if (const int32_t status = check_struct(limits, struct_size); status != HSP_OK) return status;
  typename Handle::Limits::InLibrary defaults;
  const Status status = default_limits(balls, defaults);
  return status == Status::ok ? Handle::Limits::write(defaults, limits, struct_size) : to_c(status);
}

// The end of every hsp_X_bytes.
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

// hsp_X_bytes, and hsp_X_init, of handles with limits.
template <class Handle>
int32_t get_bytes_by_limits(const typename Handle::Limits::InHeader *limits, size_t *bytes) {
  typename Handle::Limits::InLibrary wanted;
  const int32_t status = Handle::Limits::read(limits, wanted);
  if (bytes == nullptr && status != HSP_E_VERSION) return HSP_E_ARGUMENT;
  return status == HSP_OK ? get_bytes<Handle>(wanted, bytes) : status;
}
template <class Handle>
int32_t init_by_limits(void *memory, size_t bytes, const typename Handle::Limits::InHeader *limits, Handle **handle) {
  typename Handle::Limits::InLibrary wanted;
  const int32_t status = Handle::Limits::read(limits, wanted);
  if ((memory == nullptr || handle == nullptr) && status != HSP_E_VERSION) return HSP_E_ARGUMENT;
  return status == HSP_OK ? init(memory, bytes, wanted, handle) : status;
}

// hsp_X_bytes and hsp_X_init as the header declares them, of the handle X; with hsp_X_limits_init by a number of balls.
#define HSP_HANDLE_MEMORY(X)                                                           \
  int32_t X##_bytes(const X##_limits *limits, size_t *bytes) {                         \
    return hsp::capi::get_bytes_by_limits<X>(limits, bytes);                           \
  }                                                                                    \
  int32_t X##_init(void *memory, size_t bytes, const X##_limits *limits, X **handle) { \
    return hsp::capi::init_by_limits(memory, bytes, limits, handle);                   \
  }                                                                                    \
  struct X
#define HSP_HANDLE_BY_BALLS(X)                                                        \
  int32_t X##_limits_init(X##_limits *limits, uint32_t struct_size, uint32_t balls) { \
    return hsp::capi::init_limits<X>(limits, struct_size, balls);                     \
  }                                                                                   \
  HSP_HANDLE_MEMORY(X)

// Sets `limits`, which may be null, to the limits that were needed; after a lack of capacity to those to retry with:
// none is smaller than the handle's, and at least one is larger. Returns the status for the caller.
template <class Handle>
int32_t hand_back_limits(const Handle &handle, Status status, typename Handle::Limits::InHeader *limits) {
  if (limits != nullptr && (status == Status::ok || status == Status::capacity)) {
    const auto enough = status == Status::ok ? handle.builder.needed() : handle.builder.retry_limits();
    Handle::Limits::write(enough, limits, limits->struct_size);
  }
  return to_c(status);
}

// The end of every hsp_X_compute.
template <class Handle>
int32_t finish(Handle &handle, Status status, typename Handle::Limits::InHeader *limits) {
  handle.complete = status == Status::ok;
  return hand_back_limits(handle, status, limits);
}

}  // namespace hsp::capi
