#include "workspace_cases.hpp"

#include <array>
#include <vector>

#include "expect_cases.hpp"

TEST(Workspace, Cases) {
  expect_cases(cases::core_workspace);
}

// By pointers that no index check sees. Arrays whose sizes are multiples of 64 have pads too.
TEST(Workspace, PadsBetweenArraysArePoisoned) {
  if (!hsp::poisons) GTEST_SKIP() << "no address sanitizer";
  hsp::Workspace measure;
  const auto layout = [](hsp::Workspace &workspace) {
    return std::array{workspace.take<uint32_t>(16), workspace.take<uint32_t>(3), workspace.take<uint32_t>(32)};
  };
  layout(measure);
  std::vector<unsigned char> memory(measure.bytes());
  hsp::Workspace first(memory.data(), memory.size());
  first.take<unsigned char>(100);
  // Carved again with other arrays, whose pads are elsewhere.
  hsp::Workspace workspace(memory.data(), memory.size());
  const auto arrays = layout(workspace);
  for (const hsp::Span<uint32_t> array : arrays) {
    for (uint32_t &item : array) item = 1;
  }
  for (const uint32_t k : {0U, 1U}) {
    volatile uint32_t *const past = arrays[k].end();
    EXPECT_DEATH(*past = 1, "use-after-poison");
  }
}
