#include "escaped_text_cases.hpp"

#include "expect_cases.hpp"

TEST(EscapedText, Cases) {
  expect_cases(cases::picture_escaped_text);
}
