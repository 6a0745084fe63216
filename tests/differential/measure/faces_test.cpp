// Areas and volume terms of single faces and balls against the faces that slices find.
#include <gtest/gtest.h>

#include <cmath>

#include "face_comparison.hpp"
#include "gradient_sets.hpp"
#include "library_derivatives.hpp"
#include "long_reals.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using Real = long double;

TEST(MeasuresOfFaces, OfSetsOfEveryKind) {
  if (!oracle::has_long_reals) GTEST_SKIP() << "long doubles are doubles here";
  for (const oracle::NamedBalls &set : sets_of_every_kind(101))
    EXPECT_EQ(complaint_about_smallest(set.balls, faces_differ), "") << set.name;
}

TEST(MeasuresOfFaces, OfRandomSets) {
  oracle::RandomSource random(103);
  for (int k = 0; k < oracle::sets(12); ++k)
    for (const Balls &balls : {oracle::loose_balls(random, 15), oracle::dense_balls(random, 8),
                               oracle::clustered_balls(random, 14), oracle::belted_balls(random, 24)})
      ASSERT_EQ(complaint_about_smallest(in_general_position(balls, random), faces_differ), "");
}

TEST(MeasuresOfFaces, OfMolecules) {
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests())
    EXPECT_EQ(complaint_about_smallest(nearest_to_first(set.balls, 60), faces_differ), "") << set.name;
}

// Property 1 of hsp_boundary_measure_faces, on sets with ties too.
TEST(MeasuresOfFaces, SumToThoseOfTheBalls) {
  oracle::RandomSource random(104);
  for (int k = 0; k < oracle::sets(2000); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(1, 30)));
    const LibraryBoundary boundary(balls);
    const LibraryFaceMeasures faces = measure_faces(boundary);
    const LibraryBoundary::Measures measures = boundary.measure();
    const std::vector<hsp_ball> records = boundary.balls();
    for (size_t i = 0; i < balls.size(); ++i) {
      Real area = 0;
      Real volume = 0;
      Real size = 0;
      for (uint32_t f = 0; f < records[i].faces; ++f) {
        area += static_cast<Real>(faces.area[records[i].first_face + f]);
        volume += static_cast<Real>(faces.volume[records[i].first_face + f]);
        size += std::abs(static_cast<Real>(faces.volume[records[i].first_face + f]));
      }
      const Real radius = static_cast<Real>(balls[i].radius);
      ASSERT_LE(std::abs(area - static_cast<Real>(measures.area[i])), 1e-13L * radius * radius)
          << oracle::to_text(balls);
      ASSERT_LE(std::abs(volume - static_cast<Real>(measures.volume[i])), 1e-13L * (size + radius * radius * radius))
          << oracle::to_text(balls);
    }
  }
}

}  // namespace
