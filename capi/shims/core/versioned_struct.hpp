// Structs of the header that grow with it. Each begins with struct_size, which says how much of it a program knows. A
// program with an older header gives less: the fields that it lacks have their default values. A program with a newer
// header gives more: the rest has to be zeros, which mean that nothing unknown to this library is asked for.
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
// The size in an earlier header; specialised for structs that have grown.
template <class Struct>
constexpr uint32_t earlier_bytes = 0;
template <class Struct>
constexpr StructSize size_of_struct{sizeof(Struct), earlier_bytes<Struct>};

// Reads a program's struct over the defaults in `complete`. HSP_E_VERSION if it asks for anything that is not known
// here.
int32_t read_versioned(const void *given, StructSize known, void *complete);
// Whether a struct of this size can be read and written.
bool is_struct_size(StructSize known, uint32_t struct_size);
// Writes as much of a value as a program knows, and zeros behind. On failure nothing is written.
int32_t write_versioned(const void *value, StructSize known, void *out, uint32_t struct_size);

// The limits of a kind of handles, a struct of the header with struct_size and numbers alone. The table has the offset
// of each number, in the order of the fields of the struct of lib.
struct LimitTable {
  StructSize known;
  Span<const uint8_t> offsets;
};
inline constexpr uint32_t largest_limits = 64;
// HSP_E_RANGE if a limit is larger than any count can be.
int32_t read_limits(const void *given, LimitTable table, void *limits);
int32_t write_limits(const void *limits, LimitTable table, void *given, uint32_t struct_size);

// The same functions by the type of a struct.
template <class Struct>
int32_t read_struct(const Struct *given, const Struct &defaults, Struct &complete) {
  complete = defaults;
  return read_versioned(given, size_of_struct<Struct>, &complete);
}

// The same for a request, whose defaults are zeros; null means the defaults.
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

// Whether results can be handed back in a program's struct: null, or one whose size is set.
template <class Struct>
int32_t check_struct(const Struct *out) {
  return out == nullptr ? HSP_OK : check_struct(out, out->struct_size);
}

template <class Struct>
int32_t write_struct(const Struct &value, Struct *out, uint32_t struct_size) {
  return write_versioned(&value, size_of_struct<Struct>, out, struct_size);
}

}  // namespace hsp::capi
