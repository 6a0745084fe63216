// Cells of molecules, held against a prototype in doubles that overlays polygons with tolerances: with the origin that
// it has for its cubes there are as many power cells and free parts of them. Its runs of empty cubes lie along another
// axis, so that there may be a few more or fewer of these. Regions are those of the topology.
#include <gtest/gtest.h>

#include "built_free_space.hpp"
#include "built_topology.hpp"
#include "molecule_balls.hpp"

namespace {

struct Expected {
  const char *file;
  int64_t probe;  // in thousandths of an Angstrom
  uint32_t power_cells, free_parts, cells, adjacencies, regions;
};

TEST(FreeSpace, OfMolecules) {
  for (const Expected &expected : {Expected{"caffeine.pdb", 0, 113, 114, 140, 532, 1},
                                   {"crambin.pdb", 0, 1805, 1969, 2102, 8542, 1},
                                   {"crambin.pdb", 1400, 1308, 722, 786, 2895, 2}}) {
    constexpr int64_t finer = 10000, origin = 123456;  // 0.0123456 Angstrom
    oracle::Balls balls = read_molecule(support::own_molecule(expected.file));
    for (auto &ball : balls) {
      ball = {ball.x * finer - origin, ball.y * finer - origin, ball.z * finer - origin,
              (ball.radius + expected.probe) * finer};
    }
    const BuiltFreeSpace built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::FreeSpace &space = built.space();
    EXPECT_EQ(space.power_cells, expected.power_cells) << expected.file;
    EXPECT_EQ(space.cell_count() - space.run_count(), expected.free_parts) << expected.file;
    EXPECT_EQ(space.region_count(), expected.regions) << expected.file;
    EXPECT_NEAR(space.cell_count(), expected.cells, 0.002 * expected.cells) << expected.file;
    EXPECT_NEAR(space.adjacency_count(), expected.adjacencies, 0.002 * expected.adjacencies) << expected.file;
    BuiltTopology topology(balls);
    ASSERT_EQ(topology.status(), hsp::Status::ok);
    EXPECT_EQ(topology.structure().region_count, expected.regions) << expected.file;
  }
}

}  // namespace
