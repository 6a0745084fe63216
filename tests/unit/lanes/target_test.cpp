#include "lanes/target.hpp"

#include <gtest/gtest.h>

namespace {

#if HSP_AVX2
// The compiler's run-time library asks the same of the processor and of the operating system.
TEST(Target, KnowsWhetherItHasAvx2) {
  __builtin_cpu_init();
  const bool expected =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("popcnt");
  EXPECT_EQ(hsp::best_target() == hsp::Target::avx2, expected);
}
#else
TEST(Target, IsTheBaselineHere) {
  EXPECT_EQ(hsp::best_target(), hsp::Target::baseline);
}
#endif

}  // namespace
