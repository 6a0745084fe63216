// The summary of one brick, from the boundary of its own balls and of those of others that meet them.
//
// Of the brick's boundary all that lies on owned balls is as in the whole; what lies on others alone is not, and no
// shell of it is looked at. Pieces are joined anew, from faces of owned balls.
#pragma once

#include "bricks/brick_seams.hpp"
#include "bricks/summary_draft.hpp"

namespace hsp {

struct BrickQuestion {
  uint32_t brick = 0, bricks = 1;
  bool keeps_shells = false;
  const uint64_t *id = nullptr;     // [n] in the caller's order
  const uint32_t *owner = nullptr;  // [n] in the caller's order
};

struct SummaryResult {
  Status status;
  uint64_t bytes = 0;  // of the summary; with Status::capacity more than there are, and with as many as once were a
                       // result of Status::capacity some that suffice
};

SummaryResult summarise_brick(const CubeGrid &grid, const Boundary &boundary, const BrickQuestion &question,
                              Patience patience, uint8_t *memory, uint64_t bytes);

}  // namespace hsp
