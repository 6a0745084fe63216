// Sets without ties, in which areas of simple faces and directions of edges are defined: random sets whose centres are
// shifted by less than a hundredth of their radii.
#include <gtest/gtest.h>

#include "random_balls.hpp"
#include "smallest_failing.hpp"
#include "structure_laws.hpp"

namespace {

using oracle::Balls;
using oracle::RandomSource;

Balls jittered(const Balls &balls, RandomSource &random) {
  Balls result;
  for (const oracle::LatticeBall &b : balls)
    result.push_back({100000 * b.x + random.in(-50000, 50000), 100000 * b.y + random.in(-50000, 50000),
                      100000 * b.z + random.in(-50000, 50000), 100000 * b.radius + random.in(0, 50000)});
  return result;
}

std::string anything_broken(const Balls &balls) {
  const LibraryTopology topology(balls);
  std::string broken = laws_broken_by(topology, balls);
  if (broken.empty()) broken = face_areas_disagree(topology, balls);
  return broken.empty() ? start_faces_disagree(topology, balls) : broken;
}

using Maker = Balls (*)(RandomSource &, std::size_t);

void expect_laws(Maker make, int sets, std::int64_t least, std::int64_t most) {
  RandomSource random(91);
  std::uint32_t cut = 0;
  for (int k = 0; k < sets; ++k) {
    const Balls balls = jittered(make(random, static_cast<std::size_t>(random.in(least, most))), random);
    ASSERT_EQ(complaint_about_smallest(balls, anything_broken), "");
    cut += LibraryTopology(balls).counts().extra_edges;
  }
  EXPECT_GT(cut, 0U);
}

TEST(GeneralPosition, LooseBalls) {
  expect_laws(oracle::loose_balls, 500, 2, 40);
}
TEST(GeneralPosition, DenseBalls) {
  expect_laws(oracle::dense_balls, 300, 2, 20);
}
TEST(GeneralPosition, ClusteredBalls) {
  expect_laws(oracle::clustered_balls, 500, 2, 40);
}
TEST(GeneralPosition, BeltedBalls) {
  expect_laws(oracle::belted_balls, 500, 9, 45);
}
TEST(GeneralPosition, CrownedBalls) {
  expect_laws(oracle::crowned_balls, 500, 9, 45);
}
TEST(GeneralPosition, DegenerateBallsJustOffTheirTies) {
  expect_laws(oracle::degenerate_balls, 1000, 2, 14);
}

}  // namespace
