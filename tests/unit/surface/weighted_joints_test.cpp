#include "weighted_joints_cases.hpp"

#include "expect_cases.hpp"

TEST(WeightedJoints, Cases) {
  expect_cases(cases::surface_weighted_joints);
}
