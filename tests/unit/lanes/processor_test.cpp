#include "lanes/processor.hpp"

#include <gtest/gtest.h>

namespace {

#if HSP_AVX2
// The compiler's run-time library asks the same of the processor and of the operating system.
TEST(Processor, KnowsWhetherItHasAvx2) {
  __builtin_cpu_init();
  const bool expected =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("popcnt");
  EXPECT_EQ(hsp::has_avx2(), expected);
}
#else
TEST(Processor, HasNoWideCodeHere) {
  EXPECT_FALSE(hsp::has_avx2());
}
#endif

}  // namespace
