// Merges two summaries to one. A seam that is in both joins the pieces or components that it names, and vanishes. Those
// that are complete then are added up.
//
// Example: three bricks in a row, 0, 1 and 2, with one chain of balls through all of them. Each has one piece and one
// component. Summary 0 has the seam 01, summary 1 has 01 and 12, summary 2 has 12. Merged, 0 and 1 leave one open piece
// with the seam 12. Merged with 2 the piece is a whole shell, and only sums are left.
#pragma once

#include "bricks/summary_draft.hpp"
#include "core/patience.hpp"

namespace hsp {

struct MergeResult {
  Status status;
  uint32_t brick = no_id;  // the brick at fault
  uint64_t bytes = 0;      // of the summary; with Status::capacity a number that suffices
};

// The summaries must not overlap each other or the memory. Status::argument: lattices, numbers of bricks or flags
// differ; the first brick of b is named. Status::id: the named brick is in both. Status::conflict: seams do not fit; a
// brick that lacks one is named. Status::stopped: patience has ended.
MergeResult merge_summaries(const SummaryBlock &a, const SummaryBlock &b, Patience patience, uint8_t *memory,
                            uint64_t bytes);

}  // namespace hsp
