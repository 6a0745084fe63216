// The comparisons of this folder with the slow oracles on larger sets: a part of them, or all in the long form.
#include <gtest/gtest.h>

#include "computed_balls.hpp"
#include "corpus_expectations.hpp"

namespace {

using degenerate::Scale;

TEST(Slow, NerveOfLargerSets) {
  degenerate::expect_of_all(13, 40, degenerate::nerve_disagrees, 15);
}
TEST(Slow, BruteForceOfLargerSets) {
  degenerate::expect_of_all(37, 130, degenerate::brute_force_disagrees, 15);
}
TEST(Slow, SlicesOfLargerSets) {
  degenerate::expect_of_all(21, 130, degenerate::slices_disagree, 15);
}
TEST(Slow, OrderAndAxesOneStepOff) {
  for (const Scale scale : {Scale::as_given, Scale::half_of_lattice}) {
    degenerate::expect_one_step_off(11, 22, scale, degenerate::orders_disagree, 30);
    degenerate::expect_one_step_off(11, 22, scale, degenerate::axes_disagree, 30);
    degenerate::expect_one_step_off(15, 22, scale, boundary_invariant_broken, 30);
  }
}
TEST(Slow, NerveOneStepOff) {
  degenerate::expect_one_step_off(10, 14, Scale::as_given, degenerate::nerve_disagrees, 30);
}
TEST(Slow, BruteForceOneStepOff) {
  degenerate::expect_one_step_off(8, 12, Scale::as_given, degenerate::brute_force_disagrees, 30);
  degenerate::expect_one_step_off(7, 10, Scale::half_of_lattice, degenerate::brute_force_disagrees, 30);
}
TEST(Slow, SlicesOneStepOff) {
  degenerate::expect_one_step_off(5, 8, Scale::as_given, degenerate::slices_disagree, 30);
  degenerate::expect_one_step_off(4, 7, Scale::half_of_lattice, degenerate::slices_disagree, 30);
}

}  // namespace
