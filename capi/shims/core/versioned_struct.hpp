// Structs of the header that grow with it. Each begins with struct_size, which says how much of it a program knows. A
// program with an older header gives less: what it lacks has its default value. One with a newer header gives more: the
// rest has to be zeros, which mean nothing was asked for that this library does not know.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/span.hpp"
#include "hardsphere.h"

namespace hsp::capi {

// The bytes of a struct, and those that it had in an earlier header, or 0.
struct StructSize {
  uint32_t bytes;
  uint32_t earlier;
};
// Specialised for structs that have grown.
template <class Struct>
constexpr uint32_t earlier_bytes = 0;
template <class Struct>
constexpr StructSize size_of_struct{sizeof(Struct), earlier_bytes<Struct>};

// A program's struct, over defaults that `complete` has. HSP_E_VERSION if it asks for anything that is not known here.
int32_t read_versioned(const void *given, StructSize known, void *complete);
// Whether a struct of this size can be read and written.
bool is_struct_size(StructSize known, uint32_t struct_size);
// Writes as much of a value as a program knows, and zeros behind. Nothing is written if it cannot be.
int32_t write_versioned(const void *value, StructSize known, void *out, uint32_t struct_size);

// The limits of a kind of handles, a struct of the header with struct_size and numbers alone: where each of these is,
// in the order of those of a struct of lib.
struct LimitTable {
  StructSize known;
  Span<const uint8_t> offsets;
};
inline constexpr uint32_t largest_limits = 64;
// HSP_E_RANGE if one is larger than any count.
int32_t read_limits(const void *given, LimitTable table, void *limits);
int32_t write_limits(const void *limits, LimitTable table, void *given, uint32_t struct_size);

// The same by the type of a struct.
template <class Struct>
int32_t read_struct(const Struct *given, const Struct &defaults, Struct &complete) {
  complete = defaults;
  return read_versioned(given, size_of_struct<Struct>, &complete);
}

// The same of a request, whose defaults are zeros; null asks for these.
template <class Request>
int32_t read_request(const Request *given, Request &complete) {
  complete = {};
  return given == nullptr ? HSP_OK : read_struct(given, complete, complete);
}

template <class Struct>
int32_t check_struct(const Struct *out, uint32_t struct_size) {
  if (out == nullptr) return HSP_E_ARGUMENT;
  return is_struct_size(size_of_struct<Struct>, struct_size) ? HSP_OK : HSP_E_VERSION;
}

// Whether results can be handed back in a struct that a program has: none, or one whose size is set.
template <class Struct>
int32_t check_struct(const Struct *out) {
  return out == nullptr ? HSP_OK : check_struct(out, out->struct_size);
}

template <class Struct>
int32_t write_struct(const Struct &value, Struct *out, uint32_t struct_size) {
  return write_versioned(&value, size_of_struct<Struct>, out, struct_size);
}

}  // namespace hsp::capi
