// Integers as bytes: the lowest first, at any address, and back.
#include "bricks/little_endian.hpp"

#include <gtest/gtest.h>

#include "bricks/exact_sums.hpp"

namespace {

TEST(LittleEndian, LowestFirst) {
  uint8_t bytes[13] = {};
  hsp::store_little(uint32_t{0x01020304}, bytes + 1);
  EXPECT_EQ(bytes[0], 0);
  for (uint8_t k = 0; k < 4; ++k) EXPECT_EQ(bytes[1 + k], 4 - k);
  EXPECT_EQ(bytes[5], 0);
  hsp::store_little(int64_t{-2}, bytes + 3);
  EXPECT_EQ(bytes[3], 0xFE);
  for (int k = 4; k < 11; ++k) EXPECT_EQ(bytes[k], 0xFF);
  EXPECT_EQ(hsp::load_little<int64_t>(bytes + 3), -2);
  EXPECT_EQ(hsp::load_little<uint32_t>(bytes + 1), 0xFFFE0304);
}

struct Pair {
  uint32_t small = 0;
  hsp::VolumeSum sum{};
  template <class Io, class Record>
  static constexpr void visit(Io &io, Record &r) {
    io(r.small), io(r.sum);
  }
};

// With limbs of 64 bits or 32.
TEST(LittleEndian, RecordsOfFields) {
  static_assert(hsp::little_bytes<Pair> == 28);
  Pair pair{5, hsp::VolumeSum::from(-1) - hsp::VolumeSum::from(256)};
  uint8_t bytes[29] = {};
  hsp::store_record(pair, bytes + 1);
  EXPECT_EQ(bytes[1], 5);
  EXPECT_EQ(bytes[5], 0xFF);
  EXPECT_EQ(bytes[6], 0xFE);
  for (int k = 7; k < 29; ++k) EXPECT_EQ(bytes[k], 0xFF);
  const auto again = hsp::load_record<Pair>(bytes + 1);
  EXPECT_EQ(again.small, 5U);
  EXPECT_EQ((again.sum - pair.sum).sign(), 0);
}

}  // namespace
