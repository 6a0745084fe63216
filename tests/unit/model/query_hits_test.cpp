#include "query_hits_cases.hpp"

#include "expect_cases.hpp"
#include "runnable_targets.hpp"

TEST(QueryHits, Cases) {
  expect_cases(cases::model_query_hits);
}

#if HSP_LANES
namespace {

// Several balls at once, by the cases for one at a time.
constexpr cases::Check in_lanes_of_baseline[] = {
    {"hits_are_found", cases::hits_are_found<hsp::baseline::add_hits_in_lanes>},
    {"near_ties_are_decided", cases::near_ties_are_decided<hsp::baseline::add_hits_in_lanes>},
    {"hits_are_ordered", cases::hits_are_ordered<hsp::baseline::write_ascending_in_lanes>}};
TEST(QueryHits, CasesInLanesOfBaseline) {
  expect_cases(in_lanes_of_baseline);
}

HSP_WITH_AVX2(constexpr cases::Check in_lanes_of_avx2[] =
                  {{"hits_are_found", cases::hits_are_found<hsp::avx2::add_hits_in_lanes>},
                   {"near_ties_are_decided", cases::near_ties_are_decided<hsp::avx2::add_hits_in_lanes>},
                   {"hits_are_ordered", cases::hits_are_ordered<hsp::avx2::write_ascending_in_lanes>}};
              TEST(QueryHits, CasesInLanesOfAvx2) {
                if (hsp::best_target() != hsp::Target::avx2) GTEST_SKIP() << "no such processor";
                expect_cases(in_lanes_of_avx2);
              })

}  // namespace
#endif
