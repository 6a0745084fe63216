#include "byte_sink_cases.hpp"

#include "expect_cases.hpp"

TEST(ByteSink, Cases) {
  expect_cases(cases::picture_byte_sink);
}
