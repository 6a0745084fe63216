// Meshes of the project's own molecules, van der Waals, accessible to a probe, and smooth, and of random sets.
#include "mesh_convergence.hpp"

namespace {

class Molecule : public testing::TestWithParam<const char *> {};

TEST_P(Molecule, HasClosedMeshesThatConverge) {
  const support::BallList atoms = molecule_balls(support::own_molecule(GetParam()));
  expect_meshes(atoms, 0.0, 0.8);
  expect_meshes(atoms, 1.4, 0.8);
}

INSTANTIATE_TEST_SUITE_P(Bench, Molecule, testing::Values("caffeine.pdb", "acetyl_coa.pdb", "crambin.pdb"));

// Triangles lie the flatter on the surface the shorter their edges are: angles in degrees are bounded by multiples of
// the edge's length in angstrom. The worst are on saddles near cusps, where the surface's own radius is nothing.
TEST(Crambin, TrianglesLieFlat) {
  const MeshedBalls balls(molecule_balls(support::own_molecule("crambin.pdb")), 1.4);
  for (const double edge : {0.6, 0.3, 0.15}) {
    const MadeMesh mesh(balls.surface(), edge);
    ASSERT_EQ(mesh.status(), HSP_OK);
    const MeshDefects found = mesh_defects(mesh.get(), balls.surface().surface, 70 * edge);
    std::printf("crambin, edges of %g: %.1f between neighbours, %.1f at corners, means %.2f and %.2f\n", edge,
                found.bend, found.tilt, found.mean_bend, found.mean_tilt);
    EXPECT_LT(found.bend, 140 * edge);
    EXPECT_LT(found.tilt, 110 * edge);
    EXPECT_LT(found.mean_bend, 36 * edge);
    EXPECT_LT(found.mean_tilt, 28 * edge);
    EXPECT_LT(found.share_above, 0.01);
  }
}

// Closed whatever the set, but where more than one decision is left to chance (surface.h).
TEST(RandomSets, HaveClosedMeshes) {
  for (uint64_t seed = 1; seed <= 1000; ++seed) expect_meshes_of_set(seed);
}

// Points of a lattice, so that borders run along each other, there and back, with the patch on both sides: a triangle
// on either side has an edge between the same two points.
TEST(Points, OfALatticeHaveClosedMeshes) {
  const std::vector<std::vector<double>> sets = {
      {1, 0, 1, 1, 1, 0, 2, 2, 2, 1, 1, 2, 2, 0, 1, 1, 0, 1, 2, 0, 1, 2, 2, 0, 0, 0, 2, 2, 1, 0, 0, 2, 0, 0, 2, 2},
      {2, 1, 1, 2, 1, 1, 2, 0, 0, 2, 2, 0, 0, 0, 2, 2, 2, 2, 0, 2, 0, 0, 2, 2, 0, 2, 2, 1, 1, 2, 1, 0, 0, 0, 1, 2},
      {2, 0, 2, 2, 0, 2, 1, 1, 0, 0, 1, 1, 0, 0, 1, 2, 1, 2, 0, 1, 0, 2, 0, 0, 2, 2, 0, 0, 0, 0, 0, 0, 2, 0, 1, 1}};
  for (const std::vector<double> &xyz : sets) {
    const MeshedBalls balls({xyz, std::vector<double>(xyz.size() / 3, 0.0)}, 1.0);
    expect_sound(MadeMesh(balls.surface(), 0.3), balls.surface_euler());
  }
}

// Nothing but the square of the edge is left of errors.
TEST(RandomSets, HaveMeshesThatConverge) {
  ConvergenceTally surfaces;
  for (uint64_t seed = 1; seed <= 24; ++seed) expect_converging_surface(seed, 0.5, surfaces);
  surfaces.print("smooth surfaces");
  EXPECT_GT(surfaces.cut, 10U);
  EXPECT_GT(surfaces.cusped, 10U);
}

}  // namespace
