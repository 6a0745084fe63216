// Decides how long to work without asking the caller whether to go on.
#pragma once

#include "core/executor.hpp"

namespace hsp {

class Patience {
 public:
  // executor: null, or the executor whose caller may stop the work. A Patience is for the work of one thread.
  explicit Patience(const Executor *executor = nullptr)
      : executor_(executor != nullptr && executor->may_stop() ? executor : nullptr) {}

  // Whether the caller is asked at all.
  bool may_end() const { return !small_code && executor_ != nullptr; }
  // Whether to go on with work of about so many instructions. Once the answer is no, it stays no.
  bool allows(uint64_t instructions) { return small_code || executor_ == nullptr || still_allows(instructions); }

 private:
  // In instructions: far less than the interface promises, as estimates may be far off.
  static constexpr uint64_t without_asking = 300000;

  // Out of line, as it is called in many places.
  bool still_allows(uint64_t instructions);

  const Executor *executor_;
  uint64_t spent_ = 0;
};

// Calls visit(range) for all of a range of records. If the caller may stop the work, calls it for parts of the range,
// one after the other, and may end between them, or not begin: what a step before left undone is not to be relied on.
// instructions: an estimate for each record. The one call of `visit` is compiled in once.
template <class Range, class Visit>
void in_parts(Patience &patience, Range range, uint32_t instructions, Visit visit) {
  constexpr uint32_t of_a_part = 3000000;
  const uint32_t at_once = patience.may_end() ? of_a_part / instructions : range.last - range.first;
  uint32_t spent = 0;
  do {
    if (!patience.allows(spent)) return;
    Range some = range;
    if (range.last - range.first > at_once) some.last = range.first + at_once;
    visit(some);
    range.first = some.last;
    spent = of_a_part;
  } while (range.first < range.last);
}

}  // namespace hsp
