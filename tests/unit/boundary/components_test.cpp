#include "components_cases.hpp"

#include "expect_cases.hpp"

TEST(Components, Cases) {
  expect_cases(cases::boundary_components);
}
