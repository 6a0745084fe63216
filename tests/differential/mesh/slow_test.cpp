// Meshes of larger molecules, and of many more sets.
#include <gtest/gtest.h>

#include "mesh_convergence.hpp"
#include "sweep_length.hpp"

namespace {

TEST(Slow, MeshesOfTheBenchMolecules) {
  for (const char *const name : {"felix_model.pdb", "ubiquitin.pdb", "sod_stand_in.pdb"}) {
    const support::BallList atoms = molecule_balls(support::own_molecule(name));
    if (atoms.size() < 1000 || oracle::long_tests()) expect_meshes(atoms, 0.0, 0.8);
    expect_meshes(atoms, 1.4, 0.8);
  }
}

TEST(Slow, MeshesOfFurtherMolecules) {
  if (!oracle::long_tests()) GTEST_SKIP() << "half a minute for meshes like those of the bench molecules";
  int found = 0;
  for (const char *const name : {"1crn.pdb", "1ubq.pdb", "4hhb.pdb.gz"}) {
    const auto path = support::further_molecule(name);
    if (!path) continue;
    ++found;
    const support::BallList atoms = molecule_balls(*path, support::Records::protein);
    expect_meshes(atoms, 0.0, 0.8);
    for (const double probe : {1.0, 1.4, 3.0}) expect_meshes(atoms, probe, 0.8);
  }
  if (found == 0) GTEST_SKIP() << "no further molecules";
}

TEST(Slow, MeshesOfManySets) {
  const int sets = oracle::rounds(800, 7500);
  for (int k = 0; k < sets; ++k) expect_meshes_of_set(static_cast<uint64_t>(501 + k));
}

TEST(Slow, VerticesOfManySets) {
  const int sets = oracle::rounds(150, 3000);
  for (int k = 0; k < sets; ++k) {
    SCOPED_TRACE(k);
    expect_vertices_of_atoms(static_cast<uint64_t>(1001 + k));
  }
}

TEST(Slow, MeshesOfRandomSetsConverge) {
  ConvergenceTally boundaries, surfaces;
  const auto seeds = static_cast<uint64_t>(oracle::rounds(150, 1000));
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    if (seed % 4 == 0) expect_converging_boundary(seed, 0.5, boundaries);
    expect_converging_surface(seed, 0.5, surfaces);
  }
  boundaries.print("boundaries");
  surfaces.print("smooth surfaces");
  EXPECT_GT(surfaces.cut, seeds);
  EXPECT_GT(surfaces.cusped, seeds / 2);
  EXPECT_GT(surfaces.several_shells, seeds / 20);
}

}  // namespace
