// Counts how often each stage of each predicate answered. Compiled only with HSP_COUNT_STAGES, as in the copy of the
// library that tests link; the shipped library has no globals.
#pragma once

#include <cstdint>

namespace hsp::exact {

enum class Question : uint32_t { crossing, side, point_status, vertex_pair, near };
// lanes: the search in lanes (sphere/lane_search.hpp), which answers before the filter is asked.
enum class Stage : uint32_t { filter, exact, perturbation, lanes };

#if defined(HSP_COUNT_STAGES)
struct StageCounters {
  uint64_t answers[5][4] = {};
  uint64_t of(Question question, Stage stage) const {
    return answers[static_cast<uint32_t>(question)][static_cast<uint32_t>(stage)];
  }
};
inline thread_local StageCounters stage_counters;
inline void count_answer(Question question, Stage stage, uint64_t times = 1) {
  stage_counters.answers[static_cast<uint32_t>(question)][static_cast<uint32_t>(stage)] += times;
}
#else
constexpr void count_answer(Question, Stage, uint64_t = 1) {}
#endif

}  // namespace hsp::exact
