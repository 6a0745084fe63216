#include "svg_writer_cases.hpp"

#include "expect_cases.hpp"

TEST(SvgWriter, Cases) {
  expect_cases(cases::picture_svg_writer);
}
