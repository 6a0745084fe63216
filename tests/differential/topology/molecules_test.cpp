// The topology of the molecules of the benchmarks, van der Waals and accessible to a probe of 1.4 angstrom.
#include <gtest/gtest.h>

#include <algorithm>

#include "molecule_balls.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"
#include "sweep_length.hpp"
#include "topology_complaints.hpp"
#include "topology_run.hpp"

namespace {

using oracle::Balls;

// As the default step of 1e-8 has them: radii of some 2^28 steps.
Balls on_default_lattice(const Balls &balls) {
  return oracle::scaled(balls, 100000);
}

class Molecule : public testing::TestWithParam<const char *> {
 protected:
  [[nodiscard]] static Balls atoms() { return read_molecule(support::own_molecule(GetParam())); }
};

TEST_P(Molecule, KeepsTheInvariants) {
  for (const int64_t probe : {int64_t{0}, 14 * steps_per_angstrom / 10}) {
    const Balls balls = on_default_lattice(grown(atoms(), probe));
    oracle::RandomSource random(static_cast<uint64_t>(probe));
    for (const Balls &order : {balls, oracle::permuted(balls, random.permutation(balls.size()))})
      EXPECT_EQ(topology_invariant_broken(order), "") << "probe " << probe;
  }
}

TEST_P(Molecule, DoesNotDependOnTheOrder) {
  for (const int64_t probe : {int64_t{0}, 14 * steps_per_angstrom / 10})
    EXPECT_EQ(topology_orders_disagree(on_default_lattice(grown(atoms(), probe))), "") << "probe " << probe;
}

// Turned, the cut arcs run elsewhere and nothing else changes.
TEST_P(Molecule, HasTheSameShellsAlongOtherAxes) {
  for (const int64_t probe : {int64_t{0}, 14 * steps_per_angstrom / 10}) {
    const Balls balls = grown(atoms(), probe);
    const Balls turned = oracle::along_axes(balls, {2, 0, 1});
    const LibraryTopology one(balls);
    const LibraryTopology other(turned);
    EXPECT_EQ(topology_invariant_broken(turned), "");
    const auto summary = [](const LibraryTopology &topology) {
      std::vector<std::array<int64_t, 4>> shells;
      for (const hsp_shell &shell : topology.shells())
        shells.push_back({static_cast<int64_t>(shell.volume), shell.euler, shell.kind, shell.faces});
      std::sort(shells.begin(), shells.end());
      return shells;
    };
    const auto a = summary(one);
    const auto b = summary(other);
    ASSERT_EQ(a.size(), b.size()) << "probe " << probe;
    for (size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(static_cast<double>(a[k][0]), static_cast<double>(b[k][0]), 2 + 1e-9 * static_cast<double>(a[k][0]));
      EXPECT_EQ(a[k][1], b[k][1]);
      EXPECT_EQ(a[k][2], b[k][2]);
      EXPECT_EQ(a[k][3], b[k][3]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bench, Molecule, testing::ValuesIn(oracle::some_of(support::bench_molecules())));

}  // namespace
