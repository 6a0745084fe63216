#include "span_cases.hpp"

#include "expect_cases.hpp"

TEST(Span, Cases) {
  expect_cases(cases::core_span);
}
