// Helpers for calls of the interface whose arguments may be anything.
#pragma once

#include <hardsphere.h>

#include <limits>

#include "fuzz_input.hpp"
#include "guarded_output.hpp"

namespace fuzz {

// Whether a pointer argument is to be null this time.
inline bool null(Bytes &bytes) {
  return bytes.one_in(40);
}

// A small whole number or, if `odd`, now and then something else, such as NaN.
inline double number(Bytes &bytes, bool odd) {
  static constexpr double special[] = {std::numeric_limits<double>::quiet_NaN(),
                                       std::numeric_limits<double>::infinity(),
                                       -std::numeric_limits<double>::infinity(),
                                       -0.0,
                                       -1.0,
                                       1e300,
                                       -1e300,
                                       std::numeric_limits<double>::denorm_min(),
                                       1e-300,
                                       1e16,
                                       1e-9,
                                       std::numeric_limits<double>::max()};
  if (odd && bytes.one_in(12)) return special[bytes.below(static_cast<uint32_t>(std::size(special)))];
  return bytes.below(8);
}

// The rules for the arguments (out, capacity, needed), the same for all functions. argument_status is the status that
// the other arguments lead to.
template <class Record, class Ask>
void check_array(Bytes &bytes, uint32_t most, int32_t argument_status, const Ask &ask) {
  const bool no_out = null(bytes), no_needed = null(bytes);
  Output<Record> out(bytes.below(most + 3), no_out);
  uint32_t needed = 12345;
  const int32_t status = ask(out.data(), out.capacity(), no_needed ? nullptr : &needed);
  if (argument_status == HSP_E_ARGUMENT || (no_out && out.capacity() > 0)) {
    FUZZ_REQUIRE(status == HSP_E_ARGUMENT, "null pointer");
  } else if (argument_status != HSP_OK) {
    FUZZ_REQUIRE(status == argument_status, "state or argument");
  } else {
    FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_CAPACITY, "status of an array function");
    FUZZ_REQUIRE(no_needed || (status == HSP_OK) == (needed <= out.capacity()), "capacity");
  }
  const bool tells = status == HSP_OK || status == HSP_E_CAPACITY;
  FUZZ_REQUIRE(tells || needed == 12345, "needed written on failure");
  if (no_needed && status == HSP_OK) return;
  FUZZ_REQUIRE(out.untouched_from(status == HSP_OK ? needed : 0), "written where nothing belongs");
}

// The rules for the arguments (first, count, out), the same for all functions. `there` is the number of records if
// argument_status is HSP_OK.
template <class Record, class Ask>
void check_range(Bytes &bytes, uint32_t most, int32_t argument_status, uint32_t there, const Ask &ask) {
  const bool no_out = null(bytes);
  const uint32_t first = bytes.one_in(20) ? 0xFFFFFFFF - bytes.below(4) : bytes.below(most);
  Output<Record> out(bytes.below(most), no_out);
  const uint32_t count = out.capacity();
  const bool in_range = first <= there && count <= there - first;
  const int32_t status = ask(first, count, out.data());
  const int32_t expected = argument_status == HSP_E_ARGUMENT || (no_out && count > 0) ? HSP_E_ARGUMENT
                           : argument_status != HSP_OK                                ? argument_status
                           : in_range                                                 ? HSP_OK
                                                                                      : HSP_E_ID;
  FUZZ_REQUIRE(status == expected, "status of a function of ranges");
  FUZZ_REQUIRE(out.untouched_from(status == HSP_OK ? count : 0), "written where nothing belongs");
}

}  // namespace fuzz
