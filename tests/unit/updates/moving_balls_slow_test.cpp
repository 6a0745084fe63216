// A hundred thousand moves, each compared with a new model of the same balls.
#include <gtest/gtest.h>

#include "random_moves.hpp"
#include "sweep_length.hpp"

namespace {

TEST(MovingBallsSlow, AreAsIfComputedAnew) {
  EXPECT_EQ(complaint_about_moves(3, oracle::rounds(100000, 1000000), 100), "");
}

}  // namespace
