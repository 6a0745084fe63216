// The quad-edge topology of the corpus of degenerate sets: its invariants, order, axes, one step off, and nesting.
#include <gtest/gtest.h>

#include "cell_comparison.hpp"
#include "corpus_expectations.hpp"
#include "random_balls.hpp"
#include "topology_complaints.hpp"

namespace {

using degenerate::DegenerateSet;
using oracle::Balls;

std::string invariant_broken_in_some_order(const Balls &balls) {
  oracle::RandomSource random(balls.size());
  const Balls mixed = oracle::permuted(balls, random.permutation(balls.size()));
  for (const Balls &order : {balls, Balls(balls.rbegin(), balls.rend()), mixed})
    if (const std::string broken = topology_invariant_broken(order); !broken.empty())
      return broken + "in the order " + oracle::to_text(order);
  return "";
}

std::string invariant_broken_along_other_axes(const Balls &balls) {
  for (const Balls &turned : oracle::axis_images(balls))
    if (const std::string broken = topology_invariant_broken(turned); !broken.empty())
      return broken + "for " + oracle::to_text(turned);
  return "";
}

std::string invariant_broken_elsewhere(const Balls &balls) {
  for (const auto &shift : oracle::shifts_within_lattice(balls))
    if (const std::string broken = topology_invariant_broken(oracle::moved(balls, shift)); !broken.empty())
      return broken + "when moved by " + std::to_string(shift[0]) + " " + std::to_string(shift[1]) + " " +
             std::to_string(shift[2]);
  const Balls large = oracle::scaled(balls, oracle::largest_scale(balls));
  const std::string broken = topology_invariant_broken(large);
  return broken.empty() ? broken : broken + "when scaled to fill the lattice";
}

std::string cells_disagree(const Balls &balls) {
  if (!small_enough_for_dual_complex(balls)) return "";
  const std::string nesting = nesting_disagrees(balls);
  return nesting.empty() ? locations_disagree(balls, 30, balls.size()) : nesting;
}

TEST(DegenerateTopology, KeepsTheInvariantsInAnyOrder) {
  degenerate::expect_of_all(0, 1000, invariant_broken_in_some_order);
}
TEST(DegenerateTopology, KeepsTheInvariantsAlongOtherAxes) {
  degenerate::expect_of_all(0, 1000, invariant_broken_along_other_axes);
}
TEST(DegenerateTopology, KeepsTheInvariantsElsewhere) {
  degenerate::expect_of_all(0, 1000, invariant_broken_elsewhere);
}
TEST(DegenerateTopology, DoesNotDependOnTheOrder) {
  degenerate::expect_of_all(0, 1000, topology_orders_disagree);
}
TEST(DegenerateTopology, CellsAreThoseOfTheDualComplex) {
  degenerate::expect_of_all(0, 70, cells_disagree);
}
TEST(DegenerateTopology, OneStepOff) {
  degenerate::expect_one_step_off(1, 12, degenerate::Scale::as_given, topology_invariant_broken);
  degenerate::expect_one_step_off(1, 9, degenerate::Scale::half_of_lattice, topology_invariant_broken);
  degenerate::expect_one_step_off(1, 8, degenerate::Scale::as_given, cells_disagree);
}

// Genera and voids of all components together are those that the corpus knows.
TEST(DegenerateTopology, HasTheShellsThatAreKnown) {
  for (const DegenerateSet &set : degenerate::corpus()) {
    if (!set.expected) continue;
    const LibraryTopology topology(set.balls, set.step);
    int64_t euler = 0;
    for (const hsp_shell &shell : topology.shells()) euler += 2 - 2 * int64_t{shell.genus};
    EXPECT_EQ(euler, set.expected->euler) << set.name;
    EXPECT_EQ(topology.counts().components, set.expected->components) << set.name;
    EXPECT_EQ(topology.counts().regions, 1 + set.expected->voids) << set.name;
  }
}

}  // namespace
