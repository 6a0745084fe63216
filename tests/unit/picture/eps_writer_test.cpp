#include "eps_writer_cases.hpp"

#include "expect_cases.hpp"

TEST(EpsWriter, Cases) {
  expect_cases(cases::picture_eps_writer);
}
