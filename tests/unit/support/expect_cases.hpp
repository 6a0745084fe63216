// Runs the checks of a <file>_cases.hpp under GoogleTest.
#pragma once

#include <gtest/gtest.h>

#include "cases.hpp"

template <size_t n>
void expect_cases(const cases::Check (&checks)[n]) {
  for (const cases::Check &check : checks) {
    EXPECT_EQ(check.run(), cases::all_hold) << "case of this number fails in " << check.name;
  }
}
