// Whole maps against the z-buffer on a million pixels: all molecules, lattices along their axes, and large random sets.
#include <gtest/gtest.h>

#include <iterator>
#include <optional>

#include "built_map.hpp"
#include "maps/map_builder.hpp"
#include "molecule_balls.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"
#include "sweep_length.hpp"
#include "touching_balls.hpp"

namespace {

using oracle::Balls;

constexpr Direction directions[] = {{0, 0, 1}, {0, -1, 0}, {1, 1, 1}, {0.37, -0.61, 0.83}};

// In the usual form from two directions, along an axis and along none.
void expect_right_maps(const Balls &balls) {
  for (size_t k = 0; k < std::size(directions); k += oracle::long_tests() ? 1 : 3)
    EXPECT_EQ(map_disagrees(BuiltMap(balls, directions[k]), 1000), "");
}

class SlowMap : public testing::TestWithParam<const char *> {};

TEST_P(SlowMap, OfMolecule) {
  expect_right_maps(read_molecule(support::own_molecule(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Bench, SlowMap, testing::ValuesIn(support::bench_molecules()));

class SlowFurtherMap : public testing::TestWithParam<const char *> {};

TEST_P(SlowFurtherMap, OfMolecule) {
  const auto path = support::further_molecule(GetParam());
  if (!path) GTEST_SKIP() << "skipped: no " << GetParam() << " in the folder of further molecules";
  const Balls atoms = read_molecule(*path, support::Records::protein);
  for (const int64_t probe : {0, 1400}) expect_right_maps(oracle::grown(atoms, probe));
}

INSTANTIATE_TEST_SUITE_P(Further, SlowFurtherMap,
                         testing::Values("4hhb.pdb.gz", "sod_model_4392.pdb", "3p3w.pdb.gz", "1m4x.pdb.gz"));

TEST(SlowMaps, OfLattices) {
  for (const int64_t radius : {2, 3, 4}) {
    expect_right_maps(oracle::box_lattice({12, 12, 12}, {4, 4, 4}, radius));
    expect_right_maps(oracle::chosen_points(14, 2, radius, oracle::is_face_centred));
    expect_right_maps(oracle::chosen_points(16, 2, radius, oracle::is_diamond));
  }
}

TEST(SlowMaps, OfLargeRandomSets) {
  oracle::RandomSource random(201);
  for (const size_t n : {1000U, 4000U, 16000U, 64000U, 256000U})
    if (n < 20000 || oracle::long_tests()) expect_right_maps(oracle::loose_balls(random, n));
}

TEST(SlowMaps, OfBallsThatTouch) {
  oracle::RandomSource random(202);
  for (int time = 0; time < oracle::rounds(100000, 2000000); ++time) {
    const SeenSet set = touching_pair(random);
    ASSERT_EQ(pair_complaint(set), "") << to_text(set);
  }
  for (int time = 0; time < oracle::rounds(5000, 200000); ++time) {
    const SeenSet set = touching_set(random);
    ASSERT_EQ(set_complaint(set, 40), "") << to_text(set);
  }
}

}  // namespace
