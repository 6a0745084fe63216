// Structs of the header that grow with it. Each begins with struct_size, which says how much of it a program knows. A
// program with an older header gives less: what it lacks has its default value. One with a newer header gives more: the
// rest has to be zeros, which mean nothing was asked for that this library does not know.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "hardsphere.h"

namespace hsp::capi {

// More than this is no size of a struct, but memory that was never initialised.
inline constexpr uint32_t largest_struct = 1024;

// Whether the struct had this size in an earlier header; specialised for those that have grown.
template <class Struct>
constexpr bool is_earlier_size(uint32_t) {
  return false;
}

template <class Struct>
constexpr bool is_struct_size(uint32_t size) {
  if (size < sizeof(Struct)) return is_earlier_size<Struct>(size);
  return size <= largest_struct && size % 4 == 0;
}

template <class Struct>
size_t common_bytes(uint32_t size) {
  return size < sizeof(Struct) ? size : sizeof(Struct);
}

// Whether all bytes from `begin` to `end` are zeros. Where it is compiled into callers whose struct is their own, g++
// warns of bytes behind it that are never read.
[[gnu::noinline]] inline bool are_zeros(const void *given, size_t begin, size_t end) {
  const auto *const bytes = static_cast<const unsigned char *>(given);
  for (size_t i = begin; i < end; ++i) {
    if (bytes[i] != 0) return false;
  }
  return true;
}

// A program's struct, completed from `defaults`. HSP_E_VERSION if it asks for anything that is not known here.
template <class Struct>
int32_t read_struct(const Struct *given, const Struct &defaults, Struct &complete) {
  if (given == nullptr) return HSP_E_ARGUMENT;
  const uint32_t size = given->struct_size;
  if (!is_struct_size<Struct>(size)) return HSP_E_VERSION;
  if (size > sizeof(Struct) && !are_zeros(given, sizeof(Struct), size)) return HSP_E_VERSION;
  complete = defaults;
  std::memcpy(&complete, given, common_bytes<Struct>(size));
  complete.struct_size = sizeof(Struct);
  return HSP_OK;
}

// The same of a request, whose defaults are zeros; null asks for these.
template <class Request>
int32_t read_request(const Request *given, Request &complete) {
  complete = {};
  return given == nullptr ? HSP_OK : read_struct(given, complete, complete);
}

// Whether a struct of this size can be written.
template <class Struct>
int32_t check_struct(const Struct *out, uint32_t struct_size) {
  if (out == nullptr) return HSP_E_ARGUMENT;
  return is_struct_size<Struct>(struct_size) ? HSP_OK : HSP_E_VERSION;
}

// Whether results can be handed back in a struct that a program has: none, or one whose size is set.
template <class Struct>
int32_t check_struct(const Struct *out) {
  return out == nullptr ? HSP_OK : check_struct(out, out->struct_size);
}

// Writes as much of a value as a program knows, and zeros behind. Nothing is written if it cannot be.
template <class Struct>
int32_t write_struct(const Struct &value, Struct *out, uint32_t struct_size) {
  if (const int32_t status = check_struct(out, struct_size); status != HSP_OK) return status;
  auto *const bytes = reinterpret_cast<unsigned char *>(out);
  const size_t common = common_bytes<Struct>(struct_size);
  std::memcpy(bytes, &value, common);
  for (size_t i = common; i < struct_size; ++i) bytes[i] = 0;
  out->struct_size = struct_size;
  return HSP_OK;
}

}  // namespace hsp::capi
