// The summary of one brick, from the boundary of its own balls and of those of others that meet them.
//
// On owned balls the brick's boundary is that of the whole set. On other balls it is not, so that its shells are not
// used: pieces are joined again, from faces of owned balls.
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
  uint64_t bytes = 0;  // of the summary. With Status::capacity more than were given; if that many are given next, they
                       // suffice, or the next number returned does
};

SummaryResult summarise_brick(const CubeGrid &grid, const Boundary &boundary, const BrickQuestion &question,
                              Patience patience, uint8_t *memory, uint64_t bytes);

}  // namespace hsp
