// Many moves, a million in the long form, each compared with a new model of the same balls.
#include <gtest/gtest.h>

#include "random_moves.hpp"
#include "sweep_length.hpp"

namespace {

TEST(MovingBallsSlow, AreAsIfComputedAnew) {
  EXPECT_EQ(complaint_about_moves(3, oracle::rounds(50000, 1000000), 100), "");
}

}  // namespace
