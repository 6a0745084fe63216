// The arrays of a boundary are as long as their indices run, for every limit. Through the interface a short array shows
// only if its rounding up to cache lines does not hide it.
#include <gtest/gtest.h>

#include "boundary/boundary_builder.hpp"
#include "built_boundary.hpp"
#include "lattice_lengths.hpp"
#include "stopped_at.hpp"

namespace {

using hsp::BoundaryArrays;
using hsp::BoundaryLimits;

// Carves a builder for the limits and hands it over while its memory is there.
template <class Look>
void with_builder(const BoundaryLimits &limits, Look look) {
  hsp::BoundaryBuilder builder;
  CarvedMemory memory;
  memory.carve(builder, limits);
  look(builder);
}

// A loop has two arcs or more, or is a free circle. A vertex starts three half-edges, a free circle makes two loops.
TEST(BoundaryMemory, RoomForAllLoops) {
  EXPECT_EQ((BoundaryLimits{3, 3, 0, 0}.most_loops()), 0U);
  EXPECT_EQ((BoundaryLimits{3, 3, 2, 0}.most_loops()), 3U);
  EXPECT_EQ((BoundaryLimits{2, 2, 0, 1}.most_loops()), 2U);
  EXPECT_EQ((BoundaryLimits{9, 9, 10, 7}.most_loops()), 29U);
  // Three balls around an axis: two vertices, one loop of two arcs on each. A pair: one circle, a loop on each.
  BuiltBoundary lens({{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}});
  EXPECT_EQ(lens.boundary().vertex_count(), 2U);
  EXPECT_EQ(lens.boundary().loop_count(), 3U);
  BuiltBoundary pair({{0, 0, 0, 500}, {600, 0, 0, 500}});
  EXPECT_EQ(pair.boundary().circle_count(), 1U);
  EXPECT_EQ(pair.boundary().loop_count(), 2U);
}

TEST(BoundaryMemory, ArraysAreAsLongAsTheirIndices) {
  for (uint32_t balls = 0; balls <= 40; ++balls) {
    for (const uint32_t vertices : {0U, 1U, 2U, 7U, 40U}) {
      for (const uint32_t circles : {0U, 1U, 5U, 33U}) {
        with_builder({balls, balls, vertices, circles}, [&](hsp::BoundaryBuilder &builder) {
          const BoundaryArrays &arrays = builder.arrays();
          EXPECT_EQ(arrays.vertices.capacity(), vertices);
          EXPECT_EQ(arrays.circles.capacity(), circles);
          EXPECT_EQ(arrays.root_discriminant.size(), vertices);
          EXPECT_EQ(arrays.half_edges.size(), 3 * vertices);
          EXPECT_EQ(arrays.half_edge_at.size(), 3 * vertices);
          EXPECT_EQ(arrays.closed_half_edge.size(), 2 * circles);
          EXPECT_EQ(arrays.first.size(), balls + 1);
          const uint32_t loops = 3 * vertices / 2 + 2 * circles;
          EXPECT_EQ(arrays.loop_start.size(), loops);
          EXPECT_EQ(arrays.loop_face.size(), loops);
          // A ball without loops may have one face.
          EXPECT_GE(arrays.faces.size(), loops + balls);
          EXPECT_GE(builder.scratch().size(), loops + balls);
          EXPECT_EQ(arrays.ball_state.size(), balls);
          EXPECT_EQ(arrays.component.size(), balls);
          EXPECT_EQ(arrays.component_origin.size(), balls);
        });
      }
    }
  }
}

// Of a set that has too many balls nothing else is known, and the answer has nothing of the set before.
TEST(BoundaryBuilder, NeedsNothingOfTheSetBefore) {
  const BuiltGrid three(oracle::in_lengths({{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}}, 1));
  const BuiltGrid row(oracle::in_lengths(long_row(40), 1));
  CarvedMemory memory;
  hsp::BoundaryBuilder builder;
  ASSERT_EQ(memory.build(builder, BoundaryLimits{3, 8, 8, 8, 0}, three.grid()), hsp::Status::ok);
  EXPECT_EQ(builder.needed().vertices, 2U);
  EXPECT_EQ(builder.build(row.grid()), hsp::Status::capacity);
  EXPECT_EQ(builder.needed().balls, 40U);
  EXPECT_EQ(builder.needed().neighbours, 0U);
  EXPECT_EQ(builder.needed().vertices, 0U);
}

TEST(BoundaryBuilder, StopsAtTheLastQuestions) {
  const BuiltGrid built(oracle::in_lengths(long_row(6500), 1));
  CarvedMemory memory;
  hsp::BoundaryBuilder builder;
  const uint32_t n = built.grid().balls().n;
  ASSERT_EQ(memory.build(builder, BoundaryLimits{n, 8, 8, 8, 0}, built.grid()), hsp::Status::ok);
  expect_stops_at_questions(10, 20,
                            [&](const hsp::Executor &executor) { return builder.build(built.grid(), executor); });
  EXPECT_EQ(builder.boundary().circle_count(), n - 1);
}

}  // namespace
