// Random sets full of ties, and a void of no volume, besides the cases.
#include "shell_volumes_cases.hpp"

#include "built_topology.hpp"
#include "expect_cases.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"

namespace {

TEST(ShellVolumes, Cases) {
  expect_cases(cases::topology_shell_volumes);
}

hsp::TopologyInvariant checked(const oracle::Balls &balls) {
  BuiltTopology built(balls);
  EXPECT_EQ(built.status(), hsp::Status::ok);
  return check_enclosed_volumes(built.balls(), built.boundary(), built.structure()).invariant;
}

// Balls of radius 0 and gaps of no volume: 0 is as good as either sign.
TEST(ShellVolumes, SignsAllowForRounding) {
  oracle::RandomSource random(1);
  for (int k = 0; k < 300; ++k) {
    const oracle::Balls balls = oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(1, 12)));
    ASSERT_EQ(checked(balls), hsp::TopologyInvariant::none) << oracle::to_text(balls);
  }
  // Eight spheres that meet in the middle of their box wall a void of no volume.
  EXPECT_EQ(checked(oracle::box_lattice({2, 2, 2}, {4, 6, 12}, 7)), hsp::TopologyInvariant::none);
}

}  // namespace
