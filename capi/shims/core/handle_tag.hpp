// The first word of every handle, by which a pointer to something else is refused instead of followed. A handle is a
// struct that begins with `uintptr_t tag` and has a constant `kind`, which no other one has.
#pragma once

#include <cstdint>
#include <cstring>

namespace hsp::capi {

// Small numbers: they stay apart in a word of any width.
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

// The first word of a live handle: what it is and where. Memory that holds something else, another kind of
// handle or one that was copied from elsewhere does not say that.
template <class Handle>
uintptr_t tag_of(const Handle *handle) {
  constexpr uintptr_t of_handles = 0x68737021;  // "hsp!" in ASCII
  return (of_handles + static_cast<uintptr_t>(Handle::kind)) ^
         reinterpret_cast<uintptr_t>(handle) * static_cast<uintptr_t>(0x9E3779B97F4A7C15U);
}

// Languages without pointer types pass anything for a handle, so its memory is not read as one before this. A
// misaligned address does not hold its own tag either.
template <class Handle>
bool is_live(const Handle *handle) {
  if (handle == nullptr) return false;
  uintptr_t tag;
  std::memcpy(&tag, static_cast<const void *>(handle), sizeof tag);
  return tag == tag_of(handle);
}

}  // namespace hsp::capi
