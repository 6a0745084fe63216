// Poisoned bytes end the program, their neighbours do not, and unpoisoned ones are bytes again. Without the address
// sanitizer nothing happens at all.
#include "core/poison.hpp"

#include <gtest/gtest.h>

namespace {

struct Block {
  alignas(64) unsigned char bytes[64] = {};
  ~Block() { hsp::unpoison(bytes, sizeof bytes); }
  // By a pointer that the compiler does not see through.
  void write(int k, unsigned char value) {
    unsigned char *volatile at = bytes + k;
    *at = value;
  }
};

TEST(Poison, EndsTheProgram) {
  if (!hsp::poisons) GTEST_SKIP() << "no address sanitizer";
  Block block;
  hsp::poison(block.bytes + 16, 24);
  for (const int k : {16, 27, 39}) EXPECT_DEATH(block.write(k, 1), "use-after-poison") << k;
}

TEST(Poison, LeavesTheBytesAroundAlone) {
  Block block;
  hsp::poison(block.bytes + 16, 24);
  for (const int k : {0, 15, 40, 63}) {
    block.write(k, 7);
    EXPECT_EQ(block.bytes[k], 7) << k;
  }
}

TEST(Poison, IsTakenBack) {
  Block block;
  hsp::poison(block.bytes, 64);
  hsp::unpoison(block.bytes + 8, 48);
  for (int k = 8; k < 56; ++k) block.write(k, 9);
  if (hsp::poisons) {
    EXPECT_DEATH(block.write(56, 1), "use-after-poison");
  }
  hsp::unpoison(block.bytes, 64);
  for (int k = 0; k < 64; ++k) {
    EXPECT_EQ(block.bytes[k], k >= 8 && k < 56 ? 9 : 0) << k;
  }
}

// Carving poisons every pad, also those of no bytes.
TEST(Poison, OfNothing) {
  Block block;
  hsp::poison(block.bytes + 16, 0);
  hsp::unpoison(block.bytes + 16, 0);
  for (int k = 0; k < 64; ++k) block.write(k, 5);
  EXPECT_EQ(block.bytes[16], 5);
}

// On where the compiler says so and the library is the one for tests.
TEST(Poison, IsOnInTestsUnderTheSanitizer) {
#if defined(__SANITIZE_ADDRESS__)
  constexpr bool sanitized = true;
#elif defined(__has_feature)
  constexpr bool sanitized = __has_feature(address_sanitizer);
#else
  constexpr bool sanitized = false;
#endif
  EXPECT_EQ(hsp::poisons, sanitized);
}

}  // namespace
