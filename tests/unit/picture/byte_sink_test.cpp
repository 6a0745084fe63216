// Bytes arrive in blocks, in order, and stop at the first refusal.
#include "picture/byte_sink.hpp"

#include <gtest/gtest.h>

#include "kept_bytes.hpp"

namespace {

TEST(ByteSinks, HandOnAllBytesInBlocks) {
  for (const size_t count : {0U, 1U, 1023U, 1024U, 1025U, 2048U, 5000U}) {
    KeptBytes kept;
    hsp::ByteSink sink(keep_bytes, &kept);
    std::string expected;
    for (size_t k = 0; k < count; ++k) {
      expected += static_cast<char>('a' + k % 26);
      sink.put(expected.back());
      ASSERT_EQ(sink.position(), k + 1);
    }
    sink.flush();
    EXPECT_EQ(kept.text, expected);
    EXPECT_EQ(sink.taken(), count);
    EXPECT_FALSE(sink.refused());
    EXPECT_LE(kept.largest, 1024U);
    EXPECT_EQ(kept.calls, static_cast<int>((count + 1023) / 1024));
  }
}

TEST(ByteSinks, StopWhereTheFunctionRefuses) {
  for (const size_t room : {0U, 1U, 1023U, 1024U, 1025U, 3000U, 3072U}) {
    KeptBytes kept;
    kept.room = room;
    hsp::ByteSink sink(keep_bytes, &kept);
    for (int k = 0; k < 4000; ++k) sink.put('x');
    sink.flush();
    EXPECT_TRUE(sink.refused());
    EXPECT_EQ(sink.taken(), room / 1024 * 1024);
    EXPECT_EQ(sink.taken(), kept.text.size());
    EXPECT_EQ(kept.calls, static_cast<int>(room / 1024 + 1));
    EXPECT_EQ(sink.position(), 4000U);
  }
}

}  // namespace
