// The comparisons of this folder on larger molecules and on many more sets.
#include "cell_comparison.hpp"
#include "nested_balls.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"
#include "topology_complaints.hpp"
#include "void_expectations.hpp"

namespace {

using oracle::Balls;

TEST(Slow, BettiNumbersOfDegenerateSets) {
  oracle::RandomSource random(81);
  for (int k = 0; k < oracle::rounds(150, 20000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(4, 11)));
    ASSERT_EQ(complaint_about_smallest(balls, [](const Balls &set) { return betti_numbers_disagree(set, 2, 82); }), "");
    ASSERT_EQ(complaint_about_smallest(balls, topology_invariant_broken), "");
  }
}

TEST(Slow, InvariantsAndOrdersOfAnySets) {
  oracle::RandomSource random(83);
  for (int k = 0; k < oracle::rounds(60, 6000); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(10, 50)));
    ASSERT_EQ(complaint_about_smallest(balls, topology_invariant_broken), "");
    ASSERT_EQ(complaint_about_smallest(balls, topology_orders_disagree), "");
  }
}

TEST(Slow, NestingOfShellsInShells) {
  oracle::RandomSource random(84);
  for (int k = 0; k < oracle::rounds(20, 1000); ++k) {
    const Balls balls = nested_balls(random);
    ASSERT_EQ(complaint_about_smallest(balls, nesting_disagrees), "");
    ASSERT_EQ(complaint_about_smallest(balls, [](const Balls &set) { return locations_disagree(set, 40, 85); }), "");
  }
}

TEST(Slow, LocationInDegenerateSets) {
  oracle::RandomSource random(86);
  for (int k = 0; k < oracle::rounds(300, 15000); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(3, 14)));
    ASSERT_EQ(complaint_about_smallest(balls, [](const Balls &set) { return locations_disagree(set, 40, 87); }), "");
  }
}

void expect_voids_of_further_molecule(const std::string &file) {
  const auto path = support::further_molecule(file);
  if (!path) GTEST_SKIP() << "skipped: no " << file << " in the folder of further molecules";
  const Balls atoms = read_molecule(*path, support::Records::protein);
  expect_voids(file + ", accessible", atoms, 1400, 0.99L);
  if (oracle::long_tests()) expect_voids(file + ", van der Waals", atoms, 0, 0.99L);
}

TEST(Slow, VoidsOfSuperoxideDismutase) {
  expect_voids_of_further_molecule("sod_model_4392.pdb");
}
TEST(Slow, VoidsOfEnterotoxin) {
  if (!oracle::long_tests()) GTEST_SKIP() << "in the long form";
  expect_voids_of_further_molecule("1tii.pdb.gz");
}

}  // namespace
