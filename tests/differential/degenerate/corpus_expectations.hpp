// The corpus, and expectations of all its sets up to a size.
#pragma once

#include <gtest/gtest.h>

#include <exception>

#include "degenerate_set.hpp"
#include "set_arrangements.hpp"
#include "set_checks.hpp"
#include "sweep_length.hpp"

namespace degenerate {

inline std::vector<DegenerateSet> listed_sets() {
  return read_sets(HSP_DEGENERATE_SETS);
}

inline std::vector<DegenerateSet> corpus() {
  std::vector<DegenerateSet> sets = listed_sets();
  for (DegenerateSet &set : made_sets()) sets.push_back(std::move(set));
  return sets;
}

using Check = std::string (*)(const oracle::Balls &);

// The fault of a result, for a set small enough to be tried many times with balls left out.
inline std::string complaint_about(const oracle::Balls &balls, Check check) {
  if (balls.size() <= 40) return complaint_about_smallest(balls, check);
  try {
    return check(balls);
  } catch (const std::exception &error) {
    return std::string("exception: ") + error.what();
  }
}

// After so many failures the rest of a corpus is left out.
inline constexpr int enough_failures = 5;

// The sets with at least `least` and at most `most` balls pass the check. Of every `part` of them one is tried, of more
// where tests are repeated, all in the long form of the slow tests.
inline void expect_of_all(size_t least, size_t most, Check check, size_t part = 1) {
  size_t seen = 0;
  size_t met = 0;
  int failures = 0;
  for (const DegenerateSet &set : corpus()) {
    if (set.balls.size() < least || set.balls.size() > most) continue;
    if (check == nerve_disagrees && !small_enough_for_nerve(set.balls)) continue;
    if (!oracle::long_tests() && met++ % (part * oracle::sets_for_one) != 0) continue;
    ++seen;
    const std::string complaint = complaint_about(set.balls, check);
    EXPECT_EQ(complaint, "") << set.name;
    if (!complaint.empty() && ++failures == enough_failures) return;
  }
  EXPECT_GT(seen, 0U);
}

// Every set that is one lattice step from one with `least` to `most` balls passes the check, scaled or not; `part` as
// above.
enum class Scale { as_given, half_of_lattice };
inline void expect_one_step_off(size_t least, size_t most, Scale scale, Check check, size_t part = 1) {
  size_t seen = 0;
  size_t met = 0;
  for (const DegenerateSet &set : corpus()) {
    if (set.balls.size() < least || set.balls.size() > most) continue;
    const int64_t factor = scale == Scale::as_given ? 1 : largest_scale(set.balls) / 2;
    if (factor == 0) continue;  // fills the lattice as it is
    for (const oracle::Balls &balls : one_step_off(scaled(set.balls, factor))) {
      if (check == nerve_disagrees && !small_enough_for_nerve(balls)) continue;
      if (!oracle::long_tests() && met++ % (part * oracle::sets_for_one) != 0) continue;
      ASSERT_EQ(complaint_about(balls, check), "") << "one step from " << set.name;
      ++seen;
    }
  }
  EXPECT_GT(seen, 0U);
}

}  // namespace degenerate
