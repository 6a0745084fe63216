#include "occlusion_cases.hpp"

#include "expect_cases.hpp"

TEST(Occlusion, Cases) {
  expect_cases(cases::view_occlusion);
}
