// Eight balls at once, by the cases for one at a time.
#include "expect_cases.hpp"
#include "lanes/target.hpp"
#include "query_hits_cases.hpp"

namespace {

#if HSP_AVX2
constexpr cases::Check wide_cases[] = {{"hits_are_found", cases::hits_are_found<hsp::add_hits_avx2>},
                                       {"near_ties_are_decided", cases::near_ties_are_decided<hsp::add_hits_avx2>},
                                       {"hits_are_ordered", cases::hits_are_ordered<hsp::write_ascending_avx2>}};

TEST(QueryHitsAvx2, Cases) {
  if (hsp::best_target() != hsp::Target::avx2) GTEST_SKIP() << "this processor has no AVX2";
  expect_cases(wide_cases);
}
#else
TEST(QueryHitsAvx2, IsNotInThisBuild) {}
#endif

}  // namespace
