// Equal digests of equal sets, whatever memory holds them and however they were made; other digests of sets that differ
// in as little as one step of one number, in the caller's order or in the grid.
#include "model/set_digest.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

struct Set {
  std::vector<double> xyz, radius;
  hsp::BallInput options;
};

void build(const Set &set, uint32_t spare, CarvedMemory &memory, hsp::CubeGrid &grid) {
  hsp::BallInput input = set.options;
  input.n = static_cast<uint32_t>(set.radius.size());
  input.xyz = set.xyz.data();
  input.radius = set.radius.data();
  memory.carve(grid, input.n + spare);
  uint32_t first_bad = 0;
  ASSERT_EQ(grid.build(input, first_bad), hsp::Status::ok);
}

uint64_t digest_of(const Set &set, uint32_t spare = 0) {
  CarvedMemory memory;
  hsp::CubeGrid grid;
  build(set, spare, memory, grid);
  return hsp::digest_of(grid);
}

// Balls of whole coordinates and radii, some in one place.
Set random_set(oracle::RandomSource &random, uint32_t n) {
  Set set;
  set.options.step = 1.0;
  for (uint32_t i = 0; i < n; ++i) {
    for (int axis = 0; axis < 3; ++axis) set.xyz.push_back(static_cast<double>(random.in(-400, 400) * 100));
    set.radius.push_back(static_cast<double>(random.in(90, 110) * 100));
  }
  set.radius[0] = 20000;
  return set;
}

void exchange_balls(Set &set, size_t i, size_t j) {
  for (size_t axis = 0; axis < 3; ++axis) std::swap(set.xyz[3 * i + axis], set.xyz[3 * j + axis]);
  std::swap(set.radius[i], set.radius[j]);
}

// The product by adding, one bit after the other.
uint64_t folded_by_adding(uint64_t a, uint64_t b) {
  uint64_t low = 0, high = 0;
  for (int bit = 63; bit >= 0; --bit) {
    high = high << 1 | low >> 63;
    low <<= 1;
    if ((b >> bit & 1) == 0) continue;
    low += a;
    high += low < a ? 1 : 0;
  }
  return low ^ high;
}

TEST(FoldedProduct, IsThatOfBothHalves) {
  EXPECT_EQ(hsp::folded_product(uint64_t{1} << 32, uint64_t{1} << 32), 1U);
  EXPECT_EQ(hsp::folded_product(~uint64_t{0}, ~uint64_t{0}), ~uint64_t{0});
  oracle::RandomSource random(1);
  for (int k = 0; k < 10000; ++k) {
    const auto number = [&] {
      return static_cast<uint64_t>(random.in(0, (int64_t{1} << 62) - 1)) << random.in(0, 2) >> random.in(0, 40);
    };
    const uint64_t a = number(), b = number();
    ASSERT_EQ(hsp::folded_product(a, b), folded_by_adding(a, b)) << a << " * " << b;
  }
}

TEST(SetDigest, IsTheSameForTheSameSet) {
  oracle::RandomSource random(2);
  for (const uint32_t n : {1U, 2U, 40U, 700U}) {
    const Set set = random_set(random, n);
    const uint64_t digest = digest_of(set);
    EXPECT_EQ(digest_of(set, 1000), digest);
    // From balls on their lattice, in a grid that held others.
    CarvedMemory memory, other_memory;
    hsp::CubeGrid grid, other;
    build(set, 0, memory, grid);
    build(random_set(random, n), 3, other_memory, other);
    EXPECT_NE(hsp::digest_of(other), digest);
    std::vector<uint32_t> place(n);
    for (uint32_t i = 0; i < n; ++i) place[i] = grid.grid_index(i);
    other.build(grid.balls(), {place.data(), n}, grid.side());
    EXPECT_EQ(hsp::digest_of(other), digest);
  }
}

TEST(SetDigest, ChangesWithEverything) {
  oracle::RandomSource random(3);
  std::set<uint64_t> found;
  uint32_t sets = 0;
  const auto expect_new = [&](const Set &set, const std::string &what) {
    ++sets;
    EXPECT_TRUE(found.insert(digest_of(set)).second) << what;
  };
  const Set first = random_set(random, 120);
  expect_new(first, "itself");
  for (size_t k = 0; k < first.xyz.size(); ++k) {
    for (const double by : {1.0, -1.0, 64.0}) {
      Set set = first;
      set.xyz[k] += by;
      expect_new(set, "coordinate " + std::to_string(k));
      set.xyz[(k + 3) % set.xyz.size()] -= by;
      expect_new(set, "two balls that move in opposite directions");
    }
    if (first.xyz[k] == 0.0) continue;
    Set set = first;
    set.xyz[k] = -set.xyz[k];
    expect_new(set, "mirrored coordinate " + std::to_string(k));
  }
  for (size_t i = 1; i < first.radius.size(); ++i) {
    Set set = first;
    set.radius[i] -= 1.0;
    expect_new(set, "radius " + std::to_string(i));
    for (size_t j = 0; j < i; ++j) {
      set = first;
      exchange_balls(set, i, j);
      expect_new(set, "the caller's order");
    }
    set = first;
    set.xyz.resize(3 * i);
    set.radius.resize(i);
    expect_new(set, "fewer balls");
  }
  for (const double step : {0.5, 2.0, 4.0}) {
    // The same integers.
    Set set = first;
    for (double &x : set.xyz) x *= step;
    for (double &r : set.radius) r *= step;
    set.options.step = step;
    expect_new(set, "step");
    set = first;
    set.options.probe = step + 1.0;
    expect_new(set, "probe");
    for (double &r : set.radius) r -= set.options.probe;
    expect_new(set, "the same balls with a probe");
    set = first;
    set.options.largest_radius = 20000 + step + 1;
    expect_new(set, "side of cubes");
  }
  Set none;
  expect_new(none, "no balls");
  none.options.step = 1.0;
  expect_new(none, "no balls on another lattice");
  EXPECT_EQ(found.size(), sets);
}

}  // namespace
