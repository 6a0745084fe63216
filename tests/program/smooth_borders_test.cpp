// Borders between areas of a ring's surface: islands and dents go, what has no number gets one, and borders lie where
// they were.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

extern "C" {
#include "draw/smooth_borders.h"
}

namespace {

// A torus of so many vertices around and across, each of a part of it that is as large.
struct Ring {
  static constexpr uint32_t around = 60, across = 20;

  Ring() {
    for (uint32_t i = 0; i < around; ++i) {
      for (uint32_t k = 0; k < across; ++k) {
        const double turn = 2 * M_PI * i / around, lean = 2 * M_PI * k / across, out = 30 / M_PI + std::cos(lean);
        for (const double x : {out * std::cos(turn), out * std::sin(turn), std::sin(lean)}) xyz.push_back(x);
        const uint32_t corner[4] = {vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1), vertex(i, k + 1)};
        for (const int c : {0, 1, 2, 0, 2, 3}) corners.push_back(corner[c]);
      }
    }
    areas.assign(around * across, 1.0);
    mesh.vertices = around * across;
    mesh.triangles = 2 * mesh.vertices;
    mesh.xyz = xyz.data();
    mesh.areas = areas.data();
    mesh.corners = corners.data();
  }
  static uint32_t vertex(uint32_t i, uint32_t k) { return i % around * across + k % across; }

  std::vector<double> xyz, areas;
  std::vector<uint32_t> corners;
  triangle_mesh mesh{};
};

// Two halves, the second one with the number 1.
std::vector<uint8_t> halves() {
  std::vector<uint8_t> numbers;
  for (uint32_t i = 0; i < Ring::around; ++i) {
    numbers.insert(numbers.end(), Ring::across, static_cast<uint8_t>(i < Ring::around / 2 ? 0 : 1));
  }
  return numbers;
}

std::vector<split_edge> smoothed(const Ring &ring, double reach, std::vector<uint8_t> &numbers) {
  split_edge *edges = nullptr;
  size_t count = 0;
  EXPECT_TRUE(smooth_borders_find(&ring.mesh, 3, reach, numbers.data(), &edges, &count));
  const std::vector<split_edge> found(edges, edges + count);
  std::free(edges);
  return found;
}

TEST(SmoothBorders, IslandsAndDentsGo) {
  const Ring ring;
  const std::vector<uint8_t> plain = halves();
  std::vector<uint8_t> expected = plain, numbers = plain;
  const std::vector<split_edge> straight = smoothed(ring, 2.5, expected);
  EXPECT_EQ(expected, plain);
  EXPECT_EQ(straight.size(), 4 * Ring::across);  // two borders, and a diagonal beside each edge
  for (const split_edge &edge : straight) EXPECT_NEAR(edge.share, 0.5, 0.25);
  numbers[Ring::vertex(15, 3)] = 1;  // islands of one and of two
  numbers[Ring::vertex(45, 8)] = 2;
  numbers[Ring::vertex(45, 9)] = 2;
  numbers[Ring::vertex(29, 12)] = 1;        // a dent
  numbers[Ring::vertex(40, 15)] = NO_AREA;  // nothing known
  numbers[Ring::vertex(8, 5)] = NO_AREA;
  const std::vector<split_edge> edges = smoothed(ring, 2.5, numbers);
  EXPECT_EQ(numbers, plain);
  ASSERT_EQ(edges.size(), straight.size());
  for (size_t k = 0; k < edges.size(); ++k) {
    EXPECT_TRUE(edges[k].low == straight[k].low && edges[k].high == straight[k].high);
    EXPECT_NEAR(edges[k].share, straight[k].share, 0.2);
  }
}

// A reach shorter than each edge smooths nothing; what has no number is left without one, and has no border.
TEST(SmoothBorders, NoFartherThanTheReach) {
  const Ring ring;
  std::vector<uint8_t> numbers = halves();
  numbers[Ring::vertex(15, 3)] = 1;
  numbers[Ring::vertex(40, 15)] = NO_AREA;
  const std::vector<uint8_t> before = numbers;
  const std::vector<split_edge> edges = smoothed(ring, 0.1, numbers);
  EXPECT_EQ(numbers, before);
  EXPECT_EQ(edges.size(), 4 * Ring::across + 6);
  for (const split_edge &edge : edges) EXPECT_EQ(edge.share, 0.5);
}

}  // namespace
