// Paths as path_finder_test.cpp tries few of: hundreds of pairs of points on each molecule, and sets of all kinds.
#include <gtest/gtest.h>

#include <iterator>

#include "checked_paths.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;

TEST(SlowPaths, AroundSetsOfAllKinds) {
  oracle::RandomSource random(2);
  checked_paths::Seen seen;
  const int sets = oracle::rounds(120, 2000);
  for (int k = 0; k < sets; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 30)));
    ASSERT_NO_FATAL_FAILURE(checked_paths::check(balls, random, 20, seen)) << k;
  }
  EXPECT_GT(seen.found, static_cast<uint32_t>(10 * sets));
  EXPECT_GT(100 * seen.certified, 97 * seen.found);
}

TEST(SlowPaths, ThroughLattices) {
  oracle::RandomSource random(3);
  checked_paths::Seen seen;
  for (const int64_t radius : {5000, 7000, 7071, 7072, 7500, 8600, 8660, 8661}) {
    ASSERT_NO_FATAL_FAILURE(checked_paths::check_lattice(radius, 40, random, seen));
  }
  EXPECT_EQ(seen.certified, seen.found);
  EXPECT_GT(seen.apart, 50U);
  EXPECT_GT(seen.covered, 15U);
}

TEST(SlowPaths, AmongTheLargestNumbers) {
  oracle::RandomSource random(4);
  checked_paths::Seen seen;
  for (int k = 0; k < oracle::rounds(40, 400); ++k) {
    ASSERT_NO_FATAL_FAILURE(checked_paths::check_large_numbers(20, random, seen)) << k;
  }
  EXPECT_EQ(seen.certified, seen.found);
}

TEST(SlowPaths, ThroughMolecules) {
  oracle::RandomSource random(5);
  checked_paths::Seen seen;
  const int pairs = oracle::rounds(400, 1000);
  const struct {
    const char *name;
    int64_t probe;
  } molecules[] = {{"caffeine.pdb", 0}, {"acetyl_coa.pdb", 300}, {"crambin.pdb", 0}, {"crambin.pdb", 1400}};
  for (const auto &one : molecules) {
    ASSERT_NO_FATAL_FAILURE(checked_paths::check(checked_paths::molecule(one.name, one.probe), random, pairs, seen));
  }
  EXPECT_EQ(seen.certified, seen.found);
  EXPECT_EQ(seen.found, static_cast<uint32_t>(pairs) * std::size(molecules));
  EXPECT_GT(10 * seen.bent, 3 * seen.found);
  EXPECT_GT(100 * seen.of_many, 5 * seen.found);
}

}  // namespace
