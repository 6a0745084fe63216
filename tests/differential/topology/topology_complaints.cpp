#include "topology_complaints.hpp"

#include <topology_invariants.h>

#include <algorithm>
#include <array>

#include "computed_balls.hpp"
#include "random_balls.hpp"

namespace {

using oracle::Balls;

class ComputedTopology {
 public:
  explicit ComputedTopology(const Balls &balls) : balls_(balls) {
    expect_ok(topology_result_make(balls_.get(), &topology_), "topology_result_make");
  }
  ~ComputedTopology() { topology_result_release(&topology_); }
  ComputedTopology(const ComputedTopology &) = delete;
  ComputedTopology &operator=(const ComputedTopology &) = delete;

  const topology_result *get() const { return &topology_; }

 private:
  ComputedBalls balls_;
  topology_result topology_{};
};

std::array<Balls, 3> other_orders(const Balls &balls) {
  oracle::RandomSource random(balls.size() + 1);
  Balls sorted = balls;
  std::sort(sorted.begin(), sorted.end());
  return {Balls(balls.rbegin(), balls.rend()), sorted, oracle::permuted(balls, random.permutation(balls.size()))};
}

}  // namespace

std::string topology_invariant_broken(const Balls &balls) {
  return complaint_of(broken_topology(ComputedTopology(balls).get()));
}

std::string topology_orders_disagree(const Balls &balls) {
  const ComputedTopology expected(balls);
  for (const Balls &order : other_orders(balls)) {
    const ComputedTopology found(order);
    const std::string what = complaint_of(topology_difference_after_permutation(expected.get(), found.get()));
    if (!what.empty()) return what + "depending on the order, e.g. " + oracle::to_text(order);
  }
  return "";
}
