// The arrays of a boundary are as long as their indices run, for every limit. Through the interface a short array shows
// only if its rounding up to cache lines does not hide it.
#include <gtest/gtest.h>

#include <vector>

#include "boundary/boundary_builder.hpp"
#include "built_boundary.hpp"

namespace {

using hsp::BoundaryLimits;
using hsp::BoundaryStructure;

// Carves a structure for the limits and hands it over while its memory is there.
template <class Look>
void with_structure(const BoundaryLimits &limits, Look look) {
  BoundaryStructure structure;
  hsp::Workspace measured;
  structure.carve(measured, limits);
  std::vector<unsigned char> memory(measured.bytes());
  hsp::Workspace workspace(memory.data(), memory.size());
  structure.carve(workspace, limits);
  look(structure);
}

// A loop has two arcs or more, or is a free circle. A vertex starts three arcs' walks, a free circle makes two loops.
TEST(StructureMemory, RoomForAllLoops) {
  EXPECT_EQ(BoundaryStructure::most_loops({3, 3, 0, 0}), 0U);
  EXPECT_EQ(BoundaryStructure::most_loops({3, 3, 2, 0}), 3U);
  EXPECT_EQ(BoundaryStructure::most_loops({2, 2, 0, 1}), 2U);
  EXPECT_EQ(BoundaryStructure::most_loops({9, 9, 10, 7}), 29U);
  // Three balls around an axis: two vertices, one loop of two arcs on each. A pair: one circle, a loop on each.
  BuiltBoundary lens({{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}});
  EXPECT_EQ(lens.structure().vertices.size(), 2U);
  EXPECT_EQ(lens.structure().loop_count, 3U);
  BuiltBoundary pair({{0, 0, 0, 500}, {600, 0, 0, 500}});
  EXPECT_EQ(pair.structure().circles.size(), 1U);
  EXPECT_EQ(pair.structure().loop_count, 2U);
}

TEST(StructureMemory, ArraysAreAsLongAsTheirIndices) {
  for (uint32_t balls = 0; balls <= 40; ++balls) {
    for (const uint32_t vertices : {0U, 1U, 2U, 7U, 40U}) {
      for (const uint32_t circles : {0U, 1U, 5U, 33U}) {
        with_structure({balls, balls, vertices, circles}, [&](const BoundaryStructure &structure) {
          EXPECT_EQ(structure.vertices.capacity(), vertices);
          EXPECT_EQ(structure.circles.capacity(), circles);
          EXPECT_EQ(structure.root_discriminant.size(), vertices);
          EXPECT_EQ(structure.uses.size(), 3 * vertices);
          EXPECT_EQ(structure.use_at.size(), 3 * vertices);
          EXPECT_EQ(structure.circle_side.size(), 2 * circles);
          for (const auto &first :
               {structure.first_use, structure.first_circle_side, structure.first_loop, structure.first_face}) {
            EXPECT_EQ(first.size(), balls + 1);
          }
          const uint32_t loops = 3 * vertices / 2 + 2 * circles;
          EXPECT_EQ(structure.loop_cap.size(), loops);
          EXPECT_EQ(structure.loop_face.size(), loops);
          // A ball without loops may have one face.
          EXPECT_GE(structure.faces.size(), loops + balls);
          EXPECT_GE(structure.face_parent.size(), loops + balls);
          EXPECT_EQ(structure.ball_state.size(), balls);
          EXPECT_EQ(structure.cluster_count.size(), balls);
          EXPECT_EQ(structure.component_parent.size(), balls);
        });
      }
    }
  }
}

}  // namespace
