// Paths and widest probes as path_finder_test.cpp and widest_probe_test.cpp try few of: hundreds of pairs of points on
// each molecule, sets of all kinds, crambin's void.
#include <gtest/gtest.h>

#include <iterator>

#include "checked_paths.hpp"
#include "checked_probe.hpp"
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

TEST(SlowWidestProbe, AmongRandomBalls) {
  oracle::RandomSource random(1);
  checked_probe::Seen seen;
  ASSERT_NO_FATAL_FAILURE(checked_probe::check_among_random_balls(random, oracle::rounds(20, 300), seen));
  EXPECT_GT(seen.gates, 0U);
  EXPECT_GT(seen.touches, 0U);
}

// From the void that crambin has for a probe of 1.4, with van der Waals radii: known to ten digits, by a search among
// power diagrams in doubles.
TEST(SlowWidestProbe, OutOfCrambin) {
  using namespace checked_probe;
  Balls balls = read_molecule(support::own_molecule("crambin.pdb"));
  for (auto &ball : balls) ball = {ball.x * 100000, ball.y * 100000, ball.z * 100000, ball.radius * 100000};
  const Balls accessible = grown(balls, 140000000);
  BuiltTopology topology(accessible);
  ASSERT_EQ(topology.status(), hsp::Status::ok);
  ASSERT_EQ(topology.structure().region_count, 2U);
  const Vector from{980000000, 1220000000, 610000000};
  ASSERT_GT(room(accessible, from), 0.0);
  ASSERT_NE(cell_of(topology, from), 0U);
  const BuiltProbe built(balls, from, nullptr);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_NEAR(built.widest().radius * 1e-8, 0.838840049, 6e-10);
  EXPECT_NE(built.widest().gate[2], no_id);
  EXPECT_LE(built.builds(), 40U);
}

}  // namespace
