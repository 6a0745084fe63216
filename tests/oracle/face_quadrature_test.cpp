// Faces by slices against closed forms, against the areas of whole balls by slices, and against the same balls turned.
#include "face_quadrature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_balls.hpp"
#include "slice_quadrature.hpp"

namespace {

using namespace oracle;

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

// The faces of one ball, the smallest first.
std::vector<FaceMeasures> faces_of(const std::vector<FaceMeasures> &all, size_t ball) {
  std::vector<FaceMeasures> faces;
  for (const FaceMeasures &face : all)
    if (face.ball == ball) faces.push_back(face);
  std::sort(faces.begin(), faces.end(), [](const FaceMeasures &a, const FaceMeasures &b) { return a.area < b.area; });
  return faces;
}

void expect_near(Real value, Real expected, Real tolerance) {
  EXPECT_LE(std::abs(value - expected), tolerance) << value << " for " << expected;
}

TEST(FaceQuadrature, ABallWithoutNeighbours) {
  const std::vector<FaceMeasures> faces = faces_of(measure_faces_by_slices({{1, 2, 3, 5}, {20, 0, 0, 1}}), 0);
  ASSERT_EQ(faces.size(), 1U);
  expect_near(faces[0].area, 100 * pi, 1e-15L);
  for (const Real component : faces[0].vector_area) expect_near(component, 0, 1e-15L);
}

TEST(FaceQuadrature, ABeltCutsABallIntoTwoCaps) {
  // A ring of 24 balls around a ball leaves free what is at least as far from the ring's plane as the ring's balls
  // reach: two faces, mirror images of each other, and by symmetry with vector areas along the ring's axis.
  std::vector<RealBall> balls = {{0, 0, 0, 100}};
  for (int k = 0; k < 24; ++k)
    balls.push_back({100 * std::cos(2 * pi * k / 24), 7, 100 * std::sin(2 * pi * k / 24), 25});
  const std::vector<FaceMeasures> faces = faces_of(measure_faces_by_slices(balls), 0);
  ASSERT_EQ(faces.size(), 2U);
  const SliceMeasures whole = measure_by_slices(balls);
  expect_near(faces[0].area + faces[1].area, whole.ball_area[0], 1e-14L * 10000);
  EXPECT_LT(faces[0].area, faces[1].area - 100);
  EXPECT_GT(faces[0].vector_area[1], 10000);
  EXPECT_LT(faces[1].vector_area[1], -10000);
  for (const FaceMeasures &face : faces)
    for (const size_t k : {0U, 2U}) expect_near(face.vector_area[k], 0, 1e-14L * 10000);
}

TEST(FaceQuadrature, ACapThatIsWhollyAHoleLeavesOneFace) {
  // Three caps apart from each other: one face with three loops.
  const std::vector<RealBall> balls = {{0, 0, 0, 10}, {10, 1, 2, 3}, {-3, 9, 1, 2}, {1, 2, -11, 4}};
  const std::vector<FaceMeasures> faces = measure_faces_by_slices(balls);
  EXPECT_EQ(faces.size(), 4U);
  for (const size_t i : {0U, 1U, 2U, 3U}) EXPECT_EQ(faces_of(faces, i).size(), 1U);
}

TEST(FaceQuadrature, DoesNotDependOnTheDirection) {
  RandomSource random(8);
  for (int k = 0; k < 8; ++k) {
    const Balls balls = k < 4 ? loose_balls(random, 12) : belted_balls(random, 20);
    Balls turned;
    for (const LatticeBall &ball : balls) turned.push_back({ball.z, ball.x, ball.y, ball.radius});
    const std::vector<FaceMeasures> faces = measure_faces_by_slices(real_balls(balls));
    const std::vector<FaceMeasures> faces_turned = measure_faces_by_slices(real_balls(turned));
    for (size_t i = 0; i < balls.size(); ++i) {
      const std::vector<FaceMeasures> here = faces_of(faces, i);
      const std::vector<FaceMeasures> there = faces_of(faces_turned, i);
      ASSERT_EQ(here.size(), there.size()) << "ball " << i << " of " << to_text(balls);
      for (size_t f = 0; f < here.size(); ++f) {
        const Real tolerance = 1e-13L * static_cast<Real>(balls[i].radius * balls[i].radius);
        expect_near(here[f].area, there[f].area, tolerance);
        for (size_t c = 0; c < 3; ++c)
          expect_near(here[f].vector_area[c], there[f].vector_area[(c + 1) % 3], tolerance);
      }
    }
  }
}

}  // namespace
