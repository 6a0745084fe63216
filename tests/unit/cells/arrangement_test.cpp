// Sizes of arrangements, held against all pairs and triples of spheres in integers of any size, and against spheres
// whose arrangement can be counted by hand.
#include "cells/arrangement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "built_free_space.hpp"
#include "disjoint_sets.hpp"
#include "random_balls.hpp"
#include "sphere_predicates.hpp"

namespace {

using hsp::Arrangement;
using oracle::Balls;

std::vector<Arrangement> counted(const Balls &balls) {
  const BuiltFreeSpace built(balls);
  std::vector<uint32_t> scratch(2 * balls.size());
  std::vector<Arrangement> on(balls.size());
  for (uint32_t i = 0; i < balls.size(); ++i) {
    uint64_t words = 0;
    on[i] = hsp::arrangement_on_sphere(built.grid(), built.grid().grid_index(i),
                                       {scratch.data(), static_cast<uint32_t>(scratch.size())}, words);
    if (words < 2) continue;
    uint64_t again = 0;
    const Arrangement none = hsp::arrangement_on_sphere(built.grid(), built.grid().grid_index(i),
                                                        {scratch.data(), static_cast<uint32_t>(words - 1)}, again);
    EXPECT_EQ(again, words);
    EXPECT_EQ(none.faces, 0U);
  }
  return on;
}

Arrangement sum(const std::vector<Arrangement> &on) {
  Arrangement total;
  for (const Arrangement &sphere : on) {
    total.vertices += sphere.vertices;
    total.edges += sphere.edges;
    total.faces += sphere.faces;
  }
  EXPECT_EQ(total.vertices % 3, 0U);
  EXPECT_EQ(total.edges % 2, 0U);
  return {total.vertices / 3, total.edges / 2, total.faces};
}

// Edges are counted circle by circle here, and vertices from one of their three spheres.
void check(const Balls &balls) {
  const std::vector<Arrangement> on = counted(balls);
  const oracle::TiedBalls set(balls);
  const uint32_t n = set.size();
  const auto circle = [&](uint32_t a, uint32_t b) { return set.pair(a, b) == oracle::PairRelation::circle; };
  const auto points = [&](uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t first = std::min({a, b, c}), last = std::max({a, b, c}), middle = a ^ b ^ c ^ first ^ last;
    return circle(first, middle) && circle(first, last) &&
                   set.circles_cross(first, set.cap(first, middle), set.cap(first, last))
               ? 2U
               : 0U;
  };
  for (uint32_t a = 0; a < n; ++a) {
    Arrangement sphere;
    oracle::DisjointSets joined(n);
    uint32_t circles = 0;
    for (uint32_t b = 0; b < n; ++b) {
      if (b == a || !circle(a, b)) continue;
      ++circles;
      uint64_t on_circle = 0;
      for (uint32_t c = 0; c < n; ++c) {
        if (c == a || c == b || !circle(a, c)) continue;
        const uint64_t common = points(a, b, c);
        on_circle += common;
        if (c < b) sphere.vertices += common;
        if (common > 0) joined.join(b, c);
      }
      sphere.edges += std::max<uint64_t>(1, on_circle);
    }
    const uint32_t components = joined.count() - (n - circles);
    sphere.faces = sphere.vertices + components + 1;
    ASSERT_EQ(on[a].vertices, sphere.vertices) << oracle::to_text(balls) << a;
    ASSERT_EQ(on[a].edges, sphere.edges) << oracle::to_text(balls) << a;
    ASSERT_EQ(on[a].faces, sphere.faces) << oracle::to_text(balls) << a;
  }
  static_cast<void>(sum(on));
}

TEST(Arrangement, OfSetsOfAllKinds) {
  oracle::RandomSource random(81);
  for (int k = 0; k < 60; ++k) {
    ASSERT_NO_FATAL_FAILURE(check(oracle::any_balls(random, static_cast<size_t>(random.in(1, 9))))) << k;
  }
}

TEST(Arrangement, OfVerySmallIntegers) {
  oracle::RandomSource random(82);
  for (int k = 0; k < 150; ++k) {
    Balls balls;
    const int64_t n = random.in(1, 7), most = random.in(1, 4);
    for (int64_t i = 0; i < n; ++i) {
      const int64_t x = random.in(0, most), y = random.in(0, most), z = random.in(0, most);
      balls.push_back({x, y, z, random.in(0, most)});
    }
    ASSERT_NO_FATAL_FAILURE(check(balls)) << k;
  }
}

// One sphere; two apart, and within each other, and crossing; three with two common points, and in a row; four around
// a point, of which every three have two common points.
TEST(Arrangement, CountedByHand) {
  const auto expect = [](const Balls &balls, uint64_t vertices, uint64_t edges, uint64_t faces) {
    const Arrangement total = sum(counted(balls));
    EXPECT_EQ(total.vertices, vertices);
    EXPECT_EQ(total.edges, edges);
    EXPECT_EQ(total.faces, faces);
  };
  expect({}, 0, 0, 0);
  expect({{0, 0, 0, 10}}, 0, 0, 1);
  expect({{0, 0, 0, 10}, {100, 0, 0, 10}}, 0, 0, 2);
  expect({{0, 0, 0, 10}, {1, 0, 0, 3}}, 0, 0, 2);
  expect({{0, 0, 0, 10}, {10, 0, 0, 10}}, 0, 1, 4);
  expect({{0, 0, 0, 10}, {10, 0, 0, 10}, {0, 10, 0, 10}}, 2, 6, 12);
  expect({{0, 0, 0, 10}, {15, 0, 0, 10}, {30, 0, 0, 10}}, 0, 2, 7);
  expect({{9, 9, 9, 20}, {9, 0, 0, 20}, {0, 9, 0, 20}, {0, 0, 9, 20}}, 8, 24, 32);
}

}  // namespace
