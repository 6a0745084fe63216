#include "page_cases.hpp"

#include "expect_cases.hpp"

TEST(Page, Cases) {
  expect_cases(cases::picture_page);
}
