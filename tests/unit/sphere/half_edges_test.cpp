#include "sphere/half_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "expect_cases.hpp"
#include "half_edges_cases.hpp"

TEST(HalfEdges, Cases) {
  expect_cases(cases::sphere_half_edges);
}

namespace {

// The balls of a vertex in any order, with the sign that belongs to it.
TEST(InOrder, SignIsThatOfThePermutation) {
  const uint32_t ball[3] = {3, 5, 8};
  uint32_t order[3] = {0, 1, 2};
  do {
    // Where each of the three balls comes.
    const auto place = [&](uint32_t b) { return order[b == 3 ? 0 : b == 5 ? 1 : 2]; };
    const auto before = [&](uint32_t a, uint32_t b) { return place(a) < place(b); };
    const bool even = ((order[0] > order[1]) + (order[0] > order[2]) + (order[1] > order[2])) % 2 == 0;
    for (const uint32_t code : {0U, hsp::VertexRecord::positive_bit, hsp::VertexRecord::tied_bit}) {
      const hsp::VertexRecord vertex{{ball[0], ball[1], ball[2]}, code};
      const hsp::OrderedVertex ordered = hsp::in_order(vertex, before);
      for (uint32_t k = 0; k < 3; ++k) EXPECT_EQ(ordered.ball[order[k]], ball[k]);
      EXPECT_EQ(ordered.sign, vertex.positive() == even ? 1 : -1);
    }
  } while (std::next_permutation(order, order + 3));
}

}  // namespace
