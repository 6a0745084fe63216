#include "plane_cases.hpp"

#include "expect_cases.hpp"

TEST(Plane, Cases) {
  expect_cases(cases::exact_plane);
}
