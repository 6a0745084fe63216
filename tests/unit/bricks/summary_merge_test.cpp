// Merges of blocks that are made by hand: which parts join, when they are complete, which brick is at fault, and the
// order of faults.
#include "bricks/summary_merge.hpp"

#include <gtest/gtest.h>

#include "built_block.hpp"

namespace {

using hsp::ComponentSeam;
using hsp::MergeResult;
using hsp::ShellSeam;
using hsp::Status;

struct Merged {
  MergeResult result;
  std::vector<uint8_t> bytes;
  hsp::SummaryBlock block;
};

Merged merge(const BlockParts &a, const BlockParts &b) {
  const std::vector<uint8_t> first = a.bytes(), second = b.bytes();
  hsp::SummaryBlock one, other;
  EXPECT_EQ(one.read(first.data(), first.size()), hsp::SummaryFault::none);
  EXPECT_EQ(other.read(second.data(), second.size()), hsp::SummaryFault::none);
  Merged merged;
  merged.result = hsp::merge_summaries(one, other, hsp::Patience(), nullptr, 0);
  if (merged.result.status != Status::capacity) return merged;
  // Bytes behind those that suffice are not written, wherever words begin.
  merged.bytes.assign(merged.result.bytes + 8, 0xA5);
  merged.result = hsp::merge_summaries(one, other, hsp::Patience(), merged.bytes.data() + 1, merged.result.bytes);
  for (size_t k = merged.bytes.size() - 7; k < merged.bytes.size(); ++k) EXPECT_EQ(merged.bytes[k], 0xA5);
  if (merged.result.status == Status::ok) {
    EXPECT_EQ(merged.block.read(merged.bytes.data() + 1, merged.result.bytes), hsp::SummaryFault::none);
  }
  return merged;
}

// A chain of balls through bricks 0 to 2, with one piece in each.
BlockParts link(uint32_t brick, bool keeps = false) {
  BlockParts parts;
  parts.header.lattice = {std::bit_cast<uint64_t>(1.0), 0, 5};
  parts.header.all_bricks = 3;
  parts.header.flags = keeps ? hsp::SummaryHeader::keeps_shells : 0;
  parts.header.totals.balls = 10 + brick;
  parts.bricks = {brick};
  parts.pieces.resize(1);
  parts.pieces[0].component = 0;
  parts.pieces[0].faces = 1 + brick;
  parts.pieces[0].low[0] = parts.pieces[0].low[1] = parts.pieces[0].low[2] = 10 * brick;
  parts.pieces[0].high[0] = parts.pieces[0].high[1] = parts.pieces[0].high[2] = 10 * brick + 9;
  parts.pieces[0].area = hsp::AreaSum::from(7);
  parts.components.resize(1);
  parts.components[0].balls = 10 + brick;
  parts.components[0].lowest_id = 100 - brick;
  if (brick == 1) {
    parts.components[0].top_piece = 0;
    parts.components[0].height = 50;
  }
  for (uint32_t k = 0; k < 2; ++k) {
    if (brick != k && brick != k + 1) continue;
    parts.shell_seams.push_back(seam_between<ShellSeam>(k, k + 1, 90 + k, 0));
    parts.component_seams.push_back(seam_between<ComponentSeam>(k, k + 1, 90 + k, 0));
  }
  return parts;
}

BlockParts parts_of(const Merged &merged) {
  BlockParts parts;
  const hsp::SummaryBlock &block = merged.block;
  parts.header = block.header();
  for (uint32_t k = 0; k < block.header().bricks; ++k) parts.bricks.push_back(block.brick(k));
  for (uint32_t k = 0; k < block.header().pieces; ++k) parts.pieces.push_back(block.piece(k));
  for (uint32_t k = 0; k < block.header().components; ++k) parts.components.push_back(block.component(k));
  for (uint32_t k = 0; k < block.header().shell_seams; ++k) parts.shell_seams.push_back(block.get<hsp::ShellSeam>(k));
  for (uint32_t k = 0; k < block.header().component_seams; ++k)
    parts.component_seams.push_back(block.get<hsp::ComponentSeam>(k));
  return parts;
}

TEST(SummaryMerge, AChainIsOneShellInTheEnd) {
  const uint32_t orders[][3] = {{0, 1, 2}, {2, 1, 0}, {0, 2, 1}, {1, 2, 0}};
  for (const auto &order : orders) {
    const Merged half = merge(link(order[0]), link(order[1]));
    ASSERT_EQ(half.result.status, Status::ok);
    const bool apart = order[0] + order[1] == 2;
    EXPECT_EQ(half.block.header().pieces, apart ? 2U : 1U);
    EXPECT_EQ(half.block.header().shell_seams, apart ? 2U : 1U);
    EXPECT_EQ(half.block.header().totals.shells, 0U);
    const Merged whole = merge(parts_of(half), link(order[2]));
    ASSERT_EQ(whole.result.status, Status::ok);
    const hsp::SummaryHeader &header = whole.block.header();
    EXPECT_TRUE(header.pieces == 0 && header.components == 0 && header.shell_seams == 0 && header.component_seams == 0);
    EXPECT_TRUE(header.totals.shells == 1 && header.totals.components == 1 && header.totals.voids == 0);
    EXPECT_EQ(header.totals.six_euler, 72U);
    EXPECT_EQ(header.totals.balls, 33U);
  }
}

TEST(SummaryMerge, KeptShellsStay) {
  const Merged half = merge(link(2, true), link(0, true));
  const Merged whole = merge(link(1, true), parts_of(half));
  ASSERT_EQ(whole.result.status, Status::ok);
  ASSERT_EQ(whole.block.header().pieces, 1U);
  ASSERT_EQ(whole.block.header().components, 1U);
  const hsp::ShellPiece piece = whole.block.piece(0);
  EXPECT_EQ(piece.faces, 6U);
  EXPECT_TRUE(piece.low[0] == 0 && piece.high[2] == 29);
  EXPECT_EQ((piece.area - hsp::AreaSum::from(21)).sign(), 0);
  const hsp::ComponentPart part = whole.block.component(0);
  EXPECT_TRUE(part.balls == 33 && part.lowest_id == 98 && part.top_piece == 0 && part.height == 50);
  EXPECT_EQ(whole.block.header().totals.shells, 0U);
}

// A piece without seams that is not the top of its component is the shell of a void before the component is complete.
TEST(SummaryMerge, VoidsAreCompleteAtOnce) {
  BlockParts first = link(0);
  first.pieces.push_back(first.pieces[0]);
  first.pieces[1].faces = 4;
  const Merged half = merge(first, link(1));
  ASSERT_EQ(half.result.status, Status::ok);
  EXPECT_TRUE(half.block.header().totals.voids == 1 && half.block.header().totals.shells == 1);
  EXPECT_TRUE(half.block.header().pieces == 1 && half.block.component(0).voids == 1);
}

// Brick 0 has all of the outer shell, 1 and 2 have floor and ceiling of a void: the highest ball that 1 knows is on its
// floor. The outer shell is complete before its component is, and waits all the same, as its highest point is needed.
TEST(SummaryMerge, AnOuterShellWaitsForItsComponent) {
  BlockParts outer = link(0), floor = link(1), ceiling = link(2);
  outer.shell_seams.clear();
  floor.shell_seams.erase(floor.shell_seams.begin());
  outer.components[0].top_piece = 0;
  outer.components[0].height = 90;
  const Merged half = merge(outer, floor);
  ASSERT_EQ(half.result.status, Status::ok);
  EXPECT_EQ(half.block.header().totals.shells, 0U);
  EXPECT_EQ(half.block.component(0).height, 90);
  const Merged whole = merge(parts_of(half), ceiling);
  ASSERT_EQ(whole.result.status, Status::ok);
  const hsp::SummaryTotals &totals = whole.block.header().totals;
  EXPECT_TRUE(totals.shells == 2 && totals.components == 1 && totals.voids == 1);
}

// The higher top counts, of one height that of lower rank, and none if the highest ball is elsewhere.
TEST(SummaryMerge, TheHigherTopCounts) {
  for (const int64_t height : {INT64_C(49), INT64_C(50), INT64_C(51)}) {
    for (const uint64_t id : {UINT64_C(0), UINT64_C(2)}) {
      BlockParts first = link(0, true), second = link(1, true);
      first.components[0].top_piece = 0;
      first.components[0].height = height;
      first.components[0].top.id = id;
      second.components[0].top.id = 1;
      const bool first_is_higher = height > 50 || (height == 50 && id < 1);
      for (const bool turned : {false, true}) {
        const Merged merged = turned ? merge(second, first) : merge(first, second);
        ASSERT_EQ(merged.result.status, Status::ok);
        EXPECT_EQ(merged.block.component(0).height, first_is_higher ? height : 50);
        EXPECT_EQ(merged.block.component(0).top.id, first_is_higher ? id : 1);
      }
    }
  }
}

TEST(SummaryMerge, FaultsNameTheBrick) {
  const auto expect_fault = [](const BlockParts &a, const BlockParts &b, Status status, uint32_t brick) {
    const Merged merged = merge(a, b);
    EXPECT_EQ(merged.result.status, status);
    EXPECT_EQ(merged.result.brick, brick);
  };
  BlockParts other = link(1);
  other.header.lattice.probe_steps = 1;
  expect_fault(link(0), other, Status::argument, 1);
  other = link(1);
  other.header.lattice.step = std::bit_cast<uint64_t>(0.5);
  expect_fault(link(0), other, Status::argument, 1);
  other = link(2);
  other.header.lattice.largest_radius = 6;
  expect_fault(link(0), other, Status::argument, 2);
  other = link(2);
  other.header.all_bricks = 4;
  expect_fault(link(0), other, Status::argument, 2);
  expect_fault(link(0), link(2, true), Status::argument, 2);
  expect_fault(link(2), link(2), Status::id, 2);
  // 1 lacks a seam that 0 has, or has another one.
  other = link(1);
  other.shell_seams.erase(other.shell_seams.begin());
  expect_fault(link(0), other, Status::conflict, 1);
  expect_fault(other, link(0), Status::conflict, 1);
  other = link(1);
  other.component_seams.erase(other.component_seams.begin());
  expect_fault(link(0), other, Status::conflict, 1);
  other = link(0);
  other.component_seams.clear();
  expect_fault(link(1), other, Status::conflict, 0);
  // A lattice comes before a brick twice, and that before seams.
  other = link(0);
  other.component_seams.clear();
  expect_fault(link(0), other, Status::id, 0);
  other.header.all_bricks = 4;
  expect_fault(link(0), other, Status::argument, 0);
}

// A piece with a seam in a component without one is of no set.
TEST(SummaryMerge, ContradictionsAreSeen) {
  BlockParts second = link(1);
  second.component_seams.pop_back();
  const Merged merged = merge(link(0), second);
  EXPECT_EQ(merged.result.status, Status::conflict);
}

}  // namespace
