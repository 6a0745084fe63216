#include "element_radii_cases.hpp"

#include "expect_cases.hpp"

TEST(ElementRadii, Cases) {
  expect_cases(cases::model_element_radii);
}
