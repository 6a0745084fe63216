#include "simple_faces_cases.hpp"

#include "expect_cases.hpp"

TEST(SimpleFaces, Cases) {
  expect_cases(cases::topology_simple_faces);
}
