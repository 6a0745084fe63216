#include <gtest/gtest.h>

#include "avx2_lanes_checks.hpp"
#include "lanes/target.hpp"

namespace {

// nullptr, which is what checks return if nothing is wrong, as a text.
[[maybe_unused]] std::string text(const char *wrong) {
  return wrong == nullptr ? "" : wrong;
}

class Avx2Lanes : public testing::Test {
  void SetUp() override {
    if (hsp::best_target() != hsp::Target::avx2) GTEST_SKIP() << "this processor or this build has no AVX2";
  }
};

#if HSP_AVX2
TEST_F(Avx2Lanes, Floats) {
  EXPECT_EQ(text(check_float_lanes()), "");
}
TEST_F(Avx2Lanes, Doubles) {
  EXPECT_EQ(text(check_double_lanes()), "");
}
TEST_F(Avx2Lanes, Integers) {
  EXPECT_EQ(text(check_integer_lanes()), "");
}
TEST_F(Avx2Lanes, FourDoubles) {
  EXPECT_EQ(text(check_four_doubles()), "");
}
TEST_F(Avx2Lanes, Comparisons) {
  EXPECT_EQ(text(check_comparisons()), "");
}
TEST_F(Avx2Lanes, PartsAndCounts) {
  EXPECT_EQ(text(check_parts_and_counts()), "");
}
TEST_F(Avx2Lanes, LongIntegers) {
  EXPECT_EQ(text(check_long_integers()), "");
}
TEST_F(Avx2Lanes, ChosenLanesFirst) {
  EXPECT_EQ(text(check_front_orders()), "");
}
#else
TEST_F(Avx2Lanes, AreNotInThisBuild) {}
#endif

}  // namespace
