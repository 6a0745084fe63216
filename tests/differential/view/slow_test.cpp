// The comparisons of this folder on a million pixels, on larger molecules and on many more sets.
#include <gtest/gtest.h>

#include <vector>

#include "molecule_balls.hpp"
#include "picture_comparison.hpp"
#include "set_arrangements.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"
#include "view_complaints.hpp"
#include "view_sets.hpp"

namespace {

using oracle::Balls;

std::vector<Direction> directions_of_pictures() {
  if (!oracle::long_tests()) return {{0, 1, 1}, uneven_directions()[0]};
  return {{0, 0, 1}, {0, 1, 1}, uneven_directions()[0], uneven_directions()[3]};
}

void expect_right_pictures(const Balls &atoms) {
  for (const int64_t probe : {0, 1400}) {
    const LibraryScene scene(grown(atoms, probe));
    for (const Direction &towards : directions_of_pictures())
      EXPECT_EQ(pictures_disagree(scene, 1000, towards), "") << "probe " << probe;
  }
}

class SlowView : public testing::TestWithParam<const char *> {};

TEST_P(SlowView, OfMolecule) {
  expect_right_pictures(read_molecule(support::own_molecule(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Bench, SlowView, testing::ValuesIn(support::bench_molecules()));

class SlowFurtherView : public testing::TestWithParam<const char *> {};

TEST_P(SlowFurtherView, OfMolecule) {
  const auto path = support::further_molecule(GetParam());
  if (!path) GTEST_SKIP() << "skipped: no " << GetParam() << " in the folder of further molecules";
  expect_right_pictures(read_molecule(*path, support::Records::protein));
}

INSTANTIATE_TEST_SUITE_P(Further, SlowFurtherView, testing::Values("3p3w.pdb.gz", "3j6r.pdb.gz"));

TEST(SlowViews, OfManyBalls) {
  oracle::RandomSource random(101);
  for (const auto make : {oracle::loose_balls, sparse_balls, mixed_balls, flat_balls}) {
    const LibraryScene scene(make(random, 3000));
    for (const Direction &towards : {Direction{0, 0, 1}, uneven_directions()[1]})
      EXPECT_EQ(pictures_disagree(scene, 1000, towards), "");
  }
}

TEST(SlowViews, OfAnySets) {
  oracle::RandomSource random(102);
  const std::vector<Direction> even = even_directions();
  for (int k = 0; k < oracle::rounds(100, 5000); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 30)));
    const Direction towards = k % 3 == 0 ? uneven_directions()[0] : even[static_cast<size_t>(random.in(0, 4))];
    const auto expect = [&](const Complaint &complaint) { ASSERT_EQ(complaint_about_smallest(balls, complaint), ""); };
    expect([&](const Balls &set) { return pictures_disagree(LibraryScene(set), 60, towards); });
    expect([&](const Balls &set) { return view_invariant_broken(set, towards); });
    expect([&](const Balls &set) { return view_orders_disagree(set, towards); });
    expect([&](const Balls &set) { return view_regions_disagree(set, 80, towards); });
    expect([&](const Balls &set) { return opposite_areas_disagree(set, towards); });
    if (HasFatalFailure()) return;
  }
}

}  // namespace
