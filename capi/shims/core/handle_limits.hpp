// The limits of a kind of handles: a struct of the header, and one of lib with the same numbers.
//
// A handle has a LimitFields, or what is derived from one, as its member type Limits.
#pragma once

#include "versioned_struct.hpp"

namespace hsp::capi {

// All fields of Given but struct_size, in the order of those of Limits.
template <class Limits, class Given, uint32_t Given::*...field>
struct LimitFields {
  using InLibrary = Limits;
  using InHeader = Given;
  static_assert(sizeof(Limits) == sizeof...(field) * sizeof(uint32_t));
  static_assert(sizeof(Given) == sizeof(uint32_t) + sizeof(Limits));

  // Reads a program's limits. HSP_E_RANGE if one is larger than any count.
  static int32_t read(const Given *given, Limits &limits) {
    Given complete;
    if (const int32_t status = read_struct(given, {}, complete); status != HSP_OK) return status;
    if (((complete.*field > HSP_MAX_BALLS) || ...)) return HSP_E_RANGE;
    auto *to = reinterpret_cast<unsigned char *>(&limits);
    ((std::memcpy(to, &(complete.*field), sizeof(uint32_t)), to += sizeof(uint32_t)), ...);
    return HSP_OK;
  }

  // Writes as much as a program knows.
  static int32_t write(const Limits &limits, Given *given, uint32_t struct_size) {
    Given complete;
    const auto *from = reinterpret_cast<const unsigned char *>(&limits);
    ((std::memcpy(&(complete.*field), from, sizeof(uint32_t)), from += sizeof(uint32_t)), ...);
    complete.struct_size = sizeof(Given);
    return write_struct(complete, given, struct_size);
  }
};

}  // namespace hsp::capi
