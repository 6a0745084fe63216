#include "workspace_cases.hpp"

#include "expect_cases.hpp"

TEST(Workspace, Cases) {
  expect_cases(cases::core_workspace);
}
