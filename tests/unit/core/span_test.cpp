#include "span_cases.hpp"

#include "expect_cases.hpp"

TEST(Span, Cases) {
  expect_cases(cases::core_span);
}

#if HSP_CHECK_INDEX
TEST(Span, TrapsOnAnIndexOutOfRange) {
  uint32_t storage[4] = {5, 6, 7, 8};
  const hsp::Span<uint32_t> span(storage, 3);
  EXPECT_EQ(span[2], 7U);
  EXPECT_DEATH(span[3] = 0, "");
  EXPECT_EQ(span.part(3, 3).size(), 0U);
  EXPECT_DEATH(span.part(2, 4), "");
  EXPECT_DEATH(span.part(2, 1), "");
}
#endif
