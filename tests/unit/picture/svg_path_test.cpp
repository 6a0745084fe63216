#include "svg_path_cases.hpp"

#include "expect_cases.hpp"

TEST(SvgPath, Cases) {
  expect_cases(cases::picture_svg_path);
}
