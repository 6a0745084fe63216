#include "vec3_cases.hpp"

#include "expect_cases.hpp"

TEST(Vec3, Cases) {
  expect_cases(cases::core_vec3);
}
