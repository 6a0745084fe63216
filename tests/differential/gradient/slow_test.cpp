// Gradients against difference quotients, and faces against slices, on many more and larger sets.
#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "face_comparison.hpp"
#include "gradient_comparison.hpp"
#include "gradient_sets.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;

// Every nth ball, or, in the usual form, every (15 n)th.
std::vector<size_t> every(size_t nth, const Balls &balls) {
  if (!oracle::long_tests()) nth *= 15;
  std::vector<size_t> chosen;
  for (size_t i = 0; i < balls.size(); i += nth) chosen.push_back(i);
  return chosen;
}

void expect_nearly_all_known(const GradientTally &tally) {
  std::cout << to_text(tally) << "\n";
  EXPECT_TRUE(nearly_all_known(tally)) << to_text(tally);
}

TEST(DerivativesSlow, GradientsOfAllBallsOfSetsOfEveryKind) {
  GradientTally tally;
  for (int k = 0; k < oracle::rounds(1, 5); ++k)
    for (const oracle::NamedBalls &set : sets_of_every_kind(201 + static_cast<uint64_t>(k)))
      EXPECT_EQ(gradients_differ(set.balls, every(1, set.balls), measured_by_library, tally), "") << set.name;
  expect_nearly_all_known(tally);
}

TEST(DerivativesSlow, GradientsOfManyAtoms) {
  GradientTally tally;
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests())
    EXPECT_EQ(gradients_differ(set.balls, every(set.balls.size() > 100 ? 5 : 1, set.balls), measured_by_library, tally),
              "")
        << set.name;
  expect_nearly_all_known(tally);
}

TEST(DerivativesSlow, GradientsOfSlices) {
  GradientTally tally;
  for (const oracle::NamedBalls &set : sets_of_every_kind(211))
    if (set.balls.size() <= 16) {
      EXPECT_EQ(gradients_differ(set.balls, every(2, set.balls), measured_by_slices, tally), "") << set.name;
    }
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests()) {
    if (!oracle::long_tests()) break;
    const Balls piece = nearest_to_first(set.balls, 12);
    EXPECT_EQ(gradients_differ(piece, every(3, piece), measured_by_slices, tally), "") << set.name;
  }
  expect_nearly_all_known(tally);
}

TEST(DerivativesSlow, FacesOfSetsOfEveryKind) {
  for (int k = 0; k < oracle::rounds(1, 4); ++k)
    for (const oracle::NamedBalls &set : sets_of_every_kind(221 + static_cast<uint64_t>(k)))
      EXPECT_EQ(faces_differ(set.balls), "") << set.name;
}

TEST(DerivativesSlow, FacesOfMolecules) {
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests())
    if (set.balls.size() <= 100 || oracle::long_tests()) {
      EXPECT_EQ(faces_differ(set.balls), "") << set.name;
    }
}

}  // namespace
