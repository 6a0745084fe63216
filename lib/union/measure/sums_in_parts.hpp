// Sums over all balls by the tasks of an executor, with the bits of a single sum in the order of the input. If a
// function returns false, the reason is the executor's failure().
#pragma once

#include "core/executor.hpp"
#include "core/summation.hpp"

namespace hsp {

// The sums over all ranges from the sums of each range. A call of its own, so that its stack is not there in the tasks.
template <class Sum>
[[gnu::noinline]] typename Sum::Term sum_of_ranges(const TermRanges &ranges, const typename Sum::Term *of_range) {
  Sum all;
  for (uint32_t k = 0; k < ranges.complete(); ++k) all.add(of_range[k]);
  return all.sums(of_range[ranges.complete()]);
}

// Calls visit(part) for the parts of a range: for all of it, or for some balls at a time if the caller may stop it.
template <class Visit>
void visit_patiently(const Executor &executor, IdRange range, Visit visit) {
  if (!executor.may_stop()) return visit(range);
  constexpr uint32_t some = 32;
  for (IdRange part{range.first, range.first}; part.last < range.last && executor.goes_on();) {
    part = {part.last, range.last - part.last < some ? range.last : part.last + some};
    visit(part);
  }
}

// Calls visit(range, sum) for ranges that are all balls together, in several tasks; visit adds a term to `sum` for each
// ball of the range. Sum::sums(rest) gives the sums of its terms and of the terms behind them, whose sums are `rest`.
// False if the executor fails.
template <class Sum, class Visit>
bool sum_in_parts(const Executor &executor, uint32_t balls, Visit visit, typename Sum::Term &sums) {
  const TermRanges ranges(balls, executor.workers());
  typename Sum::Term of_range[TermRanges::most + 1] = {};  // the last: no rest
  const auto sum_range = [&](uint32_t k) __attribute__((noinline)) {
    Sum sum;
    visit_patiently(executor, ranges[k], [&](IdRange part) { visit(part, sum); });
    of_range[k] = sum.sums({});
  };
  const bool each = executor.for_each(ranges.count(), sum_range);
  sums = sum_of_ranges<Sum>(ranges, of_range);
  return each;
}

// Calls visit(range) for ranges that are all balls together, in several tasks. False if the executor fails.
template <class Visit>
bool for_each_range(const Executor &executor, uint32_t balls, Visit visit) {
  if (!executor.is_parallel()) {
    visit_patiently(executor, IdRange{0, balls}, visit);
    return !executor.is_stopped();
  }
  const TermRanges ranges(balls, executor.workers());
  return executor.for_each(ranges.count(), [&](uint32_t k) { visit_patiently(executor, ranges[k], visit); });
}

// The same as sum_in_parts() by the caller's thread alone. A call of its own, so that its stack is not the caller's.
template <class Sum, class Visit>
[[gnu::noinline]] void sum_alone(const Executor &executor, uint32_t balls, Visit visit, typename Sum::Term &sums) {
  Sum all;
  visit_patiently(executor, IdRange{0, balls}, [&](IdRange part) { visit(part, all); });
  sums = all.sums({});
}

// sum_in_parts(), or sum_alone() if the executor has one thread.
template <class Sum, class Visit>
bool sum_by(const Executor &executor, uint32_t balls, Visit visit, typename Sum::Term &sums) {
  if (executor.is_parallel()) return sum_in_parts<Sum>(executor, balls, visit, sums);
  sum_alone<Sum>(executor, balls, visit, sums);
  return !executor.is_stopped();
}

}  // namespace hsp
