// Molecules painted from four directions, van der Waals and grown by a probe of 1.4 angstrom.
#include <gtest/gtest.h>

#include "molecule_balls.hpp"
#include "picture_comparison.hpp"
#include "set_arrangements.hpp"
#include "sweep_length.hpp"
#include "view_complaints.hpp"
#include "view_sets.hpp"

namespace {

using oracle::Balls;

class ViewOfMolecule : public testing::TestWithParam<const char *> {
 protected:
  [[nodiscard]] static Balls atoms() { return read_molecule(support::own_molecule(GetParam())); }
};

TEST_P(ViewOfMolecule, ShowsWhatIsVisible) {
  for (const int64_t probe : {0, 1400}) {
    const LibraryScene scene(grown(atoms(), probe));
    for (const Direction &towards : {Direction{0, 0, 1}, {0, 1, 0}, {1, 1, 1}, uneven_directions()[0]})
      EXPECT_EQ(pictures_disagree(scene, 250, towards), "") << "probe " << probe;
  }
}

TEST_P(ViewOfMolecule, KeepsTheInvariants) {
  for (const int64_t probe : {0, 1400}) {
    const Balls balls = grown(atoms(), probe);
    EXPECT_EQ(view_invariant_broken(balls, {0, 0, 1}), "") << "probe " << probe;
    EXPECT_EQ(view_invariant_broken(balls, uneven_directions()[3]), "") << "probe " << probe;
    EXPECT_EQ(view_orders_disagree(balls, {0, 0, 1}), "") << "probe " << probe;
    EXPECT_EQ(opposite_areas_disagree(balls, {0, 0, 1}), "") << "probe " << probe;
    EXPECT_EQ(opposite_areas_disagree(balls, uneven_directions()[1]), "") << "probe " << probe;
  }
}

INSTANTIATE_TEST_SUITE_P(Bench, ViewOfMolecule, testing::ValuesIn(oracle::some_of(support::bench_molecules())));

}  // namespace
