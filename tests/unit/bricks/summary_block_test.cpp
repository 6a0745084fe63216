// Blocks that have a right check sum and are wrong all the same: each number that could lead out of memory is refused.
#include "bricks/summary_block.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <vector>

#include "built_block.hpp"

namespace {

using hsp::SummaryFault;

TEST(SummaryBlock, IsReadAsItWasWritten) {
  const BlockParts parts = two_open_parts();
  const std::vector<uint8_t> bytes = parts.bytes();
  // The format: a change of it is a new version.
  EXPECT_EQ(hsp::little_bytes<hsp::SummaryHeader>, 224U);
  EXPECT_EQ(hsp::little_bytes<hsp::ShellPiece>, 188U);
  EXPECT_EQ(hsp::little_bytes<hsp::ComponentPart>, 76U);
  EXPECT_EQ(hsp::little_bytes<hsp::ShellSeam>, 40U);
  EXPECT_EQ(hsp::little_bytes<hsp::ComponentSeam>, 20U);
  hsp::SummaryBlock block;
  ASSERT_EQ(block.read(bytes.data(), bytes.size()), SummaryFault::none);
  EXPECT_EQ(block.header().bricks, 2U);
  EXPECT_TRUE(block.has(1) && block.has(4) && !block.has(0) && !block.has(2) && !block.has(5));
  EXPECT_EQ(block.piece(1).faces, 3U);
  EXPECT_EQ(block.component(1).lowest_id, 70U);
  EXPECT_EQ(block.get<hsp::ShellSeam>(1).id[2], 93U);
  EXPECT_EQ(block.get<hsp::ComponentSeam>(0).b, 2U);
}

TEST(SummaryBlock, AddressesMayBeOdd) {
  const std::vector<uint8_t> bytes = two_open_parts().bytes();
  std::vector<uint8_t> shifted(bytes.size() + 1);
  std::copy(bytes.begin(), bytes.end(), shifted.begin() + 1);
  hsp::SummaryBlock block;
  EXPECT_EQ(block.read(shifted.data() + 1, bytes.size()), SummaryFault::none);
}

TEST(SummaryBlock, NumbersOutOfRangeAreRefused) {
  const std::function<void(BlockParts &)> faults[] = {
      [](BlockParts &p) { p.header.magic ^= 1; },
      [](BlockParts &p) { p.header.version = 0; },
      [](BlockParts &p) { p.header.flags = 2; },
      [](BlockParts &p) { p.header.lattice.step = std::bit_cast<uint64_t>(-1.0); },
      [](BlockParts &p) { p.header.lattice.step = UINT64_C(0x7FF0000000000000); },
      [](BlockParts &p) { p.header.lattice.largest_radius = -1; },
      [](BlockParts &p) { p.header.lattice.largest_radius = INT64_C(1) << 31; },
      [](BlockParts &p) { p.header.all_bricks = 4; },
      [](BlockParts &p) {
        p.bricks = {4, 1};
      },
      [](BlockParts &p) {
        p.bricks = {1, 1};
      },
      [](BlockParts &p) { p.bricks = {}; },
      [](BlockParts &p) { p.pieces[1].component = 2; },
      [](BlockParts &p) { p.components[0].top_piece = 2; },
      [](BlockParts &p) { p.components[0].top_piece = 1; },
      [](BlockParts &p) { p.shell_seams[0].label = 2; },
      [](BlockParts &p) { p.component_seams[0].label = 2; },
      [](BlockParts &p) { p.shell_seams[0].a = p.shell_seams[0].b; },
      [](BlockParts &p) { p.shell_seams[1].b = 9; },
      [](BlockParts &p) { p.shell_seams[1].a = 1; },
      [](BlockParts &p) { std::swap(p.shell_seams[0], p.shell_seams[1]); },
      [](BlockParts &p) { p.shell_seams[1] = p.shell_seams[0]; },
      [](BlockParts &p) { p.component_seams[0].a = 0; },
  };
  int number = 0;
  for (const auto &make_fault : faults) {
    BlockParts parts = two_open_parts();
    make_fault(parts);
    const std::vector<uint8_t> bytes = parts.bytes();
    hsp::SummaryBlock block;
    EXPECT_EQ(block.read(bytes.data(), bytes.size()), SummaryFault::damaged) << number;
    ++number;
  }
}

TEST(SummaryBlock, NewerVersionsAreToldApart) {
  BlockParts parts = two_open_parts();
  parts.header.version = hsp::SummaryHeader::newest + 1;
  const std::vector<uint8_t> bytes = parts.bytes();
  hsp::SummaryBlock block;
  EXPECT_EQ(block.read(bytes.data(), bytes.size()), SummaryFault::newer);
}

TEST(SummaryBlock, LengthsAreThoseOfTheLists) {
  for (const int more : {-20, -4, 4, 8}) {
    BlockParts parts = two_open_parts();
    const std::vector<uint8_t> bytes = parts.bytes(more);
    hsp::SummaryBlock block;
    EXPECT_EQ(block.read(bytes.data(), bytes.size()), SummaryFault::damaged) << more;
  }
}

}  // namespace
