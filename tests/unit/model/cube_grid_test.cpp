// Which cube a point lies in, at the ends of the lattice too: the quotient is estimated in double and has to be
// corrected.
#include <gtest/gtest.h>

#include "random_balls.hpp"

#include "model/cube_grid.hpp"

namespace {

int64_t floor_of(int64_t value, int64_t side) {
  const int64_t quotient = value / side;
  return value % side < 0 ? quotient - 1 : quotient;
}

void expect_floor(int64_t value, int64_t side) {
  const hsp::CubeCoordinates cube = hsp::CubeGrid::cube_at({value, -value, value / 2}, side);
  ASSERT_EQ(cube.x, floor_of(value, side)) << value << " / " << side;
  ASSERT_EQ(cube.y, floor_of(-value, side)) << -value << " / " << side;
  ASSERT_EQ(cube.z, floor_of(value / 2, side)) << value / 2 << " / " << side;
}

TEST(CubeAt, IsTheFloorEverywhere) {
  oracle::RandomSource random(31);
  constexpr int64_t farthest = (int64_t{1} << 52) - 1;
  for (int k = 0; k < 3000000; ++k) {
    const int64_t side = random.in(1, int64_t{1} << (1 + k % 31));
    const int64_t absolute = farthest >> random.in(0, 7);
    int64_t value = random.in(0, absolute - 1);
    // Next to the walls, where an estimate goes wrong first.
    if (k % 2 == 0) value = value / side * side + random.in(-1, 1);
    expect_floor(value, side);
  }
}

}  // namespace
