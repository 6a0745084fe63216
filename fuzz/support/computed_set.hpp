// A set as a `computed` (tests/api/support/computed.h), on which the invariants of the interface tests work, released
// with the object.
#pragma once

#include <computed.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "checked_model.hpp"
#include "random_balls.hpp"

namespace fuzz {

class ComputedSet {
 public:
  explicit ComputedSet(const ScaledBalls &set) {
    const support::BallList list = set.in_lengths();
    const hsp_model_options options = options_of(set);
    const int32_t status = computed_make(list.size(), list.xyz.data(), list.radius.data(), &options, &computed_);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  }
  ~ComputedSet() { computed_release(&computed_); }
  ComputedSet(const ComputedSet &) = delete;
  ComputedSet &operator=(const ComputedSet &) = delete;

  // Once more, by several workers in an order that the input chooses.
  void compute_by_workers(uint32_t workers, Bytes &bytes);

  const computed &get() const { return computed_; }

 private:
  computed computed_{};
};

inline bool close(double a, double b) {
  return std::fabs(a - b) <= 1e-10 * (1 + std::fabs(a));
}

template <class Record>
bool same(const Record *a, const Record *b, uint32_t count) {
  return count == 0 || std::memcmp(a, b, count * sizeof(Record)) == 0;
}

// An order of 0 .. n-1 that the input chooses.
inline std::vector<uint32_t> shuffled(uint32_t n, Bytes &bytes) {
  std::vector<uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  for (uint32_t i = n; i > 1; --i) std::swap(order[i - 1], order[bytes.below(i)]);
  return order;
}

inline void ComputedSet::compute_by_workers(uint32_t workers, Bytes &bytes) {
  const int32_t status = computed_by_workers(&computed_, workers, bytes.byte());
  FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
}

// The set in another order: ball i of the result is ball order[i] of the set.
inline ScaledBalls permuted(const ScaledBalls &set, const std::vector<uint32_t> &order) {
  ScaledBalls result = set;
  result.balls = oracle::permuted(set.balls, order);
  return result;
}

}  // namespace fuzz
