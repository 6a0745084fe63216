// Limits below those that a handle needs must lead to HSP_E_CAPACITY, with nothing written beside the memory, and to
// success after no more enlargements than the header says.
#pragma once

#include <owned_handle.hpp>

#include <cstring>

#include "fuzz_input.hpp"

namespace fuzz {

// `exact`: the limits that the computation needs. `compute` takes a handle and the struct for the limits that come
// back, and returns the status. `read` takes the handle and returns the status of reading it; if that is HSP_OK it has
// also compared the results.
template <class Kind, class Compute, class Read>
void require_limits(const typename Kind::Limits &exact, Bytes &bytes, Compute compute, Read read) {
  typename Kind::Limits limits = exact;
  const uint32_t which = bytes.below(1U << Kind::limits.size());
  for (uint32_t k = 0; k < Kind::limits.size(); ++k) {
    uint32_t &number = limits.*Kind::limits[k];
    if ((which >> k & 1U) != 0) number = bytes.below(number + 1);
  }
  for (int enlargements = 0;; ++enlargements) {
    bool enough = true;
    for (const auto limit : Kind::limits) enough = enough && limits.*limit >= exact.*limit;
    size_t size = 0;
    typename Kind::Handle *handle = nullptr;
    FUZZ_REQUIRE(Kind::bytes(&limits, &size) == HSP_OK, Kind::name);
    FUZZ_REQUIRE(size <= Kind::most_bytes(limits), Kind::name);
    std::vector<uint8_t> memory(size + 1, 0x3C);
    FUZZ_REQUIRE(Kind::init(memory.data(), size, &limits, &handle) == HSP_OK, Kind::name);
    typename Kind::Limits returned = limits;
    const int32_t status = compute(handle, &returned);
    FUZZ_REQUIRE(memory.back() == 0x3C, "written past a handle's memory");
    FUZZ_REQUIRE(status == (enough ? HSP_OK : HSP_E_CAPACITY), "status of a computation, by its limits");
    FUZZ_REQUIRE(read(handle) == (enough ? HSP_OK : HSP_E_STATE), "results, by the limits");
    if (enough) {
      FUZZ_REQUIRE(std::memcmp(&returned, &exact, sizeof exact) == 0, "needed limits differ with more room");
      return;
    }
    FUZZ_REQUIRE(enlargements < Kind::enlargements, "more enlargements than promised");
    for (const auto limit : Kind::limits)
      FUZZ_REQUIRE(returned.*limit >= limits.*limit, "a limit to retry with shrinks");
    limits = returned;
  }
}

}  // namespace fuzz
