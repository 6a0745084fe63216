// The limits of a kind of handles: a struct of the header, and one of lib with the same numbers.
//
// A handle has a LimitFields, or what is derived from one, as its member type Limits.
#pragma once

#include "versioned_struct.hpp"

namespace hsp::capi {

// The fields of Given without struct_size, by their offsets, in the order of the fields of Limits.
template <class Limits, class Given, size_t... offset>
struct LimitFields {
  using InLibrary = Limits;
  using InHeader = Given;
  static_assert(sizeof(Limits) == sizeof...(offset) * sizeof(uint32_t));
  static_assert(sizeof(Given) == sizeof(uint32_t) + sizeof(Limits) && sizeof(Given) <= largest_limits);

  static int32_t read(const Given *given, Limits &limits) { return read_limits(given, table, &limits); }
  static int32_t write(const Limits &limits, Given *given, uint32_t struct_size) {
    return write_limits(&limits, table, given, struct_size);
  }

 private:
  static constexpr uint8_t offsets[] = {offset...};
  static constexpr LimitTable table{size_of_struct<Given>, {offsets, sizeof...(offset)}};
};

}  // namespace hsp::capi
