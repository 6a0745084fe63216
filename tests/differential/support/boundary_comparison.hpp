// The library's boundary against the brute-force boundary of tests/oracle, record by record.
#pragma once

#include <string>

#include "brute_boundary.hpp"
#include "library_run.hpp"
#include "random_balls.hpp"
#include "smallest_failing.hpp"

// Compares the boundary in the given order of the balls and in `orders` random orders. Balls are named by their rank in
// the perturbation, which the order does not change.
inline Complaint boundary_differs(int orders, uint64_t seed) {
  return [orders, seed](const oracle::Balls &balls) {
    oracle::RandomSource random(seed);
    const oracle::BoundaryRecord record = oracle::brute_boundary(balls);
    const auto expected = oracle::canonical(record, oracle::tie_ranks(balls));
    for (int k = 0; k <= orders; ++k) {
      const oracle::Balls mixed = k == 0 ? balls : oracle::permuted(balls, random.permutation(balls.size()));
      const auto found = oracle::canonical(LibraryBoundary(mixed).record(), oracle::tie_ranks(mixed));
      if (found == expected) continue;
      return "library and oracle differ in " + oracle::differences(found, expected) + "for the order " +
             oracle::to_text(mixed);
    }
    return std::string();
  };
}
