// Meshes of the project's own molecules, van der Waals, accessible to a probe, and smooth, and of random sets.
#include "lattice_lengths.hpp"
#include "mesh_expectations.hpp"
#include "random_balls.hpp"

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

// Closed whatever the set, or refused for a reason that is known.
TEST(RandomSets, HaveClosedMeshes) {
  int meshes = 0, open = 0, refused_boundaries = 0, refused_surfaces = 0;
  for (uint64_t seed = 1; seed <= 500; ++seed) {
    oracle::RandomSource random(seed);
    const oracle::Balls set = oracle::any_balls(random, 3 + seed % 12);
    const support::BallList lengths = oracle::in_lengths(set, 1);
    double largest = 0.0;
    for (const double r : lengths.radius) largest = std::max(largest, r);
    const double probe = std::floor(0.3 * largest * static_cast<double>(seed % 5));
    const MeshedBalls balls(lengths, probe, 1.0);
    const double edge = largest > 0.0 ? 0.5 * (largest + probe) : 1.0;
    const MadeMesh of_boundary(balls.boundary(), edge);
    ++meshes;
    if (of_boundary.status() == HSP_E_CHECK) {
      ++refused_boundaries;
    } else {
      expect_sound(of_boundary, balls.boundary().counts.euler);
    }
    if (probe == 0.0) continue;
    if (!balls.has_closed_surface()) {
      ++open;
      continue;
    }
    const MadeMesh of_surface(balls.surface(), edge);
    ++meshes;
    if (of_surface.status() == HSP_E_CHECK) {
      ++refused_surfaces;
    } else {
      expect_sound(of_surface, balls.surface_euler());
    }
  }
  EXPECT_LE(refused_boundaries, 5);
  EXPECT_EQ(refused_surfaces, 0);
  EXPECT_LE(open, 10);
  std::printf("%d meshes, refused %d of boundaries and %d of surfaces; %d surfaces with open joints\n", meshes,
              refused_boundaries, refused_surfaces, open);
}

}  // namespace
