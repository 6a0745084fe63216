// The first word of every handle, its tag. By the tag a pointer to something else is refused and not followed. A handle
// is a struct that begins with `uintptr_t tag` and has a constant `kind`, which no other type of handle has.
#pragma once

#include <cstdint>
#include <cstring>

namespace hsp::capi {

// Small numbers, so that tags differ in a word of any width.
enum class HandleKind : uint8_t {
  body,
  boundary,
  cells,
  contacts,
  map,
  mesh,
  model,
  moving,
  paths,
  periodic,
  pores,
  sticks,
  surface,
  topology,
  view,
};

// The tag of a live handle, which depends on its kind and its address. Memory with other contents, another kind of
// handle, or a handle copied from elsewhere does not have it.
template <class Handle>
uintptr_t tag_of(const Handle *handle) {
  constexpr uintptr_t of_handles = 0x68737021;  // "hsp!" in ASCII
  return (of_handles + static_cast<uintptr_t>(Handle::kind)) ^
         reinterpret_cast<uintptr_t>(handle) * static_cast<uintptr_t>(0x9E3779B97F4A7C15U);
}

// Whether a pointer is a live handle. Languages without pointer types may pass anything, so that nothing else of the
// memory is read before. A misaligned address cannot hold its own tag.
template <class Handle>
bool is_live(const Handle *handle) {
  if (handle == nullptr) return false;
  uintptr_t tag;
  std::memcpy(&tag, static_cast<const void *>(handle), sizeof tag);
  return tag == tag_of(handle);
}

}  // namespace hsp::capi
