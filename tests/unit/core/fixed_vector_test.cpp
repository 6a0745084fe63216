#include "fixed_vector_cases.hpp"

#include "expect_cases.hpp"

TEST(FixedVector, Cases) {
  expect_cases(cases::core_fixed_vector);
}

#if HSP_CHECK_INDEX
TEST(FixedVector, TrapsOnAnIndexOfNoRecord) {
  uint32_t storage[3] = {};
  hsp::FixedVector<uint32_t> vector(hsp::Span<uint32_t>(storage, 3));
  vector.push(7);
  EXPECT_EQ(vector[0], 7U);
  EXPECT_DEATH(vector[1] = 0, "");
  for (uint32_t k = 0; k < 7; ++k) vector.push(k);
  EXPECT_DEATH(vector[3] = 0, "");
}
#endif
