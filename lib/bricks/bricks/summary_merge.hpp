// Two summaries become one: seams that both have join what they name and vanish, and what is complete then is added up.
//
// As an example three bricks in a row, 0, 1 and 2, with one chain of balls through all of them. Each has one piece and
// one component. Summary 0 has the seam 01, summary 1 has 01 and 12, summary 2 has 12. Merged, 0 and 1 leave one open
// piece with the seam 12; with 2 it is a shell, and nothing is left but sums.
#pragma once

#include "bricks/summary_draft.hpp"
#include "core/patience.hpp"

namespace hsp {

struct MergeResult {
  Status status;
  uint32_t brick = no_id;  // that is at fault
  uint64_t bytes = 0;      // of the summary, or with Status::capacity some that suffice
};

// The summaries do not overlap each other or the memory. Status::argument with other lattices, bricks or flags: b's
// first brick is named; Status::id: that brick is in both; Status::conflict: seams do not fit, and a brick that lacks
// one is named; Status::stopped.
MergeResult merge_summaries(const SummaryBlock &a, const SummaryBlock &b, Patience patience, uint8_t *memory,
                            uint64_t bytes);

}  // namespace hsp
