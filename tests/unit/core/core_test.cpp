// The small parts everything stands on.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "core/fixed_vector.hpp"
#include "core/sorting.hpp"
#include "core/summation.hpp"
#include "core/workspace.hpp"

namespace {

TEST(Workspace, MeasuresWhatItCarvesForEveryAlignment) {
  const auto layout = [](hsp::Workspace &workspace) {
    workspace.take<char>(3);
    workspace.take<double>(17);
    return workspace.take<uint32_t>(5);
  };
  hsp::Workspace measure;
  layout(measure);
  const size_t bytes = measure.bytes();
  std::vector<unsigned char> memory(bytes + 200, 0xA5);
  for (size_t offset = 0; offset < 64; ++offset) {
    std::fill(memory.begin(), memory.end(), static_cast<unsigned char>(0xA5));
    hsp::Workspace workspace(memory.data() + offset, bytes);
    const hsp::Span<uint32_t> last = layout(workspace);
    ASSERT_NE(last.data(), nullptr) << offset;
    EXPECT_EQ(reinterpret_cast<uintptr_t>(last.data()) % hsp::Workspace::alignment, 0U);
    for (uint32_t k = 0; k < last.size(); ++k) last[k] = k;
    EXPECT_LE(reinterpret_cast<unsigned char *>(last.end()), memory.data() + offset + bytes);
  }
}

TEST(Workspace, ReportsSizesThatDoNotFit) {
  hsp::Workspace measure;
  measure.take<double>(UINT64_MAX / 4);
  measure.take<double>(UINT64_MAX / 4);
  EXPECT_EQ(measure.bytes(), 0U);
  // The padding after the first array reaches half of the address space; the others would go once around it.
  hsp::Workspace around;
  around.take<char>(SIZE_MAX / 2 - 10);
  around.take<char>(SIZE_MAX / 2);
  around.take<char>(64);
  EXPECT_EQ(around.bytes(), 0U);
}

TEST(FixedVector, CountsPastItsCapacityAndStoresNothingThere) {
  uint32_t storage[4] = {9, 9, 9, 9};
  hsp::FixedVector<uint32_t> vector(hsp::Span<uint32_t>(storage, 3));
  for (uint32_t k = 0; k < 7; ++k) vector.push(k);
  EXPECT_TRUE(vector.overflowed());
  EXPECT_EQ(vector.required(), 7U);
  EXPECT_EQ(vector.size(), 3U);
  EXPECT_EQ(storage[2], 2U);
  EXPECT_EQ(storage[3], 9U);
  vector.clear();
  EXPECT_FALSE(vector.overflowed());
}

TEST(Sorting, AgreesWithTheStandardOnAllSizes) {
  std::mt19937_64 random(1);
  for (uint32_t n = 0; n < 200; ++n) {
    std::vector<uint32_t> items(n);
    for (uint32_t &item : items) item = static_cast<uint32_t>(random() % (n / 2 + 1));
    std::vector<uint32_t> expected = items;
    std::sort(expected.begin(), expected.end());
    hsp::sort_in_place(hsp::Span<uint32_t>(items.data(), n), [](uint32_t a, uint32_t b) { return a < b; });
    EXPECT_EQ(items, expected);
  }
}

TEST(TreeSum, AddsInABinaryTree) {
  // ((1 + e) + (e + e)) + e with e half an ulp of 1: only the pair e + e survives.
  const double e = 0x1p-53;
  hsp::TreeSum sum;
  for (const double term : {1.0, e, e, e, e}) sum.add(term);
  EXPECT_EQ(sum.total(), ((1.0 + e) + (e + e)) + e);
  EXPECT_GT(sum.total(), 1.0);
}

TEST(TreeSum, KeepsTheErrorOfManyTermsSmall) {
  hsp::TreeSum sum;
  for (int k = 0; k < 1000003; ++k) sum.add(0.1);
  EXPECT_NEAR(sum.total(), 100000.3, 1e-9);
  EXPECT_EQ(hsp::TreeSum().total(), 0.0);
}

TEST(DisjointSets, KeepTheRepresentativeThatComesFirst) {
  std::vector<uint32_t> parent(100);
  hsp::DisjointSets sets(hsp::Span<uint32_t>(parent.data(), 100));
  sets.reset();
  const auto larger = [](uint32_t a, uint32_t b) { return a > b; };
  for (uint32_t k = 2; k < 100; ++k) sets.join(k, k - 2, larger);
  for (uint32_t k = 0; k < 100; ++k) {
    EXPECT_EQ(sets.find(k), k % 2 == 0 ? 98U : 99U);
    EXPECT_EQ(sets.root(k), sets.find(k));
  }
  EXPECT_FALSE(sets.join(0, 98, larger));
  EXPECT_TRUE(sets.join(0, 1, larger));
}

}  // namespace
