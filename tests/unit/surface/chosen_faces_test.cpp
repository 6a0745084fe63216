#include "chosen_faces_cases.hpp"

#include "expect_cases.hpp"

TEST(ChosenFaces, Cases) {
  expect_cases(cases::surface_chosen_faces);
}
