#include "depth_buffer_cases.hpp"

#include "expect_cases.hpp"

TEST(DepthBuffer, Cases) {
  expect_cases(cases::view_depth_buffer);
}
