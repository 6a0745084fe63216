// Balls and sticks against the z-buffer of balls and cylinders on a million pixels, as they are painted and as a map:
// all molecules, lattices along their axes, and balls that meet.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>

#include "built_sticks.hpp"
#include "molecule_balls.hpp"
#include "point_lattices.hpp"
#include "sweep_length.hpp"

namespace {

using Direction = std::array<double, 3>;

constexpr Direction directions[] = {{0, 0, 1}, {0, -1, 0}, {1, 1, 1}, {0.37, -0.61, 0.83}};

// In the usual form from two directions, along an axis and along none.
void expect_right_pictures(const StickModel &model, double radius, bool painted) {
  ASSERT_GT(model.ends.size(), 0U);
  bool whole = false;
  for (size_t k = 0; k < std::size(directions); k += oracle::long_tests() ? 1 : 3) {
    const Direction &towards = directions[k];
    whole = !whole;
    if (painted) {
      EXPECT_EQ(sticks_disagree(BuiltSticks(model.balls, model.ends, radius, towards, whole), 1000), "");
    }
    const BuiltSticks map(model.balls, model.ends, radius, towards, whole, true);
    EXPECT_TRUE(map.builder().map().exist);
    EXPECT_EQ(sticks_disagree(map, 1000), "");
  }
}

class SlowSticks : public testing::TestWithParam<const char *> {};

TEST_P(SlowSticks, OfMolecule) {
  const oracle::Balls atoms = read_molecule(support::own_molecule(GetParam()));
  expect_right_pictures(sticks_between_close(atoms, 0.25), 120, true);
  // Balls that meet have no painting order.
  for (const double part : {0.6, 1.0}) expect_right_pictures(sticks_between_close(atoms, part), 120, false);
}

INSTANTIATE_TEST_SUITE_P(Bench, SlowSticks,
                         testing::Values("caffeine.pdb", "acetyl_coa.pdb", "crambin.pdb", "felix_model.pdb",
                                         "ubiquitin.pdb"));

// Sticks seen end on and one exactly behind the other.
TEST(SlowLatticesOfSticks, AlongTheirAxes) {
  StickModel model{oracle::box_lattice({8, 8, 8}, {1000, 1000, 1000}, 300), {}};
  for (uint32_t i = 0; i < model.balls.size(); ++i)
    for (uint32_t j = 0; j < i; ++j) {
      const oracle::LatticeBall &a = model.balls[i], &b = model.balls[j];
      if (std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) == 1000) model.ends.push_back({i, j});
    }
  expect_right_pictures(model, 90, true);
  for (oracle::LatticeBall &ball : model.balls) ball.radius = 520;
  expect_right_pictures(model, 90, false);
}

}  // namespace
