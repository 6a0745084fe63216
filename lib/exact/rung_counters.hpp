// How often each rung of each predicate answered. Compiled in only with HSP_COUNT_RUNGS, which tests define for a copy
// of the library of their own; the library as it ships has no globals.
#pragma once

#include <cstdint>

namespace hsp::exact {

enum class Question : uint32_t { crossing, side, point_status, vertex_pair };
enum class Rung : uint32_t { filter, exact, tie_rule };

#if defined(HSP_COUNT_RUNGS)
struct RungCounters {
  uint64_t answers[4][3] = {};
  uint64_t of(Question question, Rung rung) const {
    return answers[static_cast<uint32_t>(question)][static_cast<uint32_t>(rung)];
  }
};
inline RungCounters rung_counters;
inline void count_answer(Question question, Rung rung) {
  ++rung_counters.answers[static_cast<uint32_t>(question)][static_cast<uint32_t>(rung)];
}
#else
constexpr void count_answer(Question, Rung) {}
#endif

}  // namespace hsp::exact
