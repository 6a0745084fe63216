#include "painted_paths_cases.hpp"

#include "expect_cases.hpp"

TEST(PaintedPaths, Cases) {
  expect_cases(cases::picture_painted_paths);
}
