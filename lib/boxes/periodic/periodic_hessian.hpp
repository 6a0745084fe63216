// All second derivatives of an energy by the centres of balls in a periodic box (curvature/hessian_rows.hpp). When a
// ball moves all of its images do, so those of one ball share a block, and what it has with its own images cancels.
//
//   1 | 0   1 | 0    Two balls in a box as wide as both: the block of 0 and 1 is the sum of two, one on each side of 0.
//                    Seen from 1 there are two as well, transposed. Each comes from one of its two balls, and which one
//                    that is depends on where the image lies: so both balls may have a part of a block.
#pragma once

#include "curvature/hessian_rows.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

// Where the rows of the balls of the input begin: first [n + 1], from 0 to the number of all entries. A row has itself,
// and each other ball of which an image shares a free piece of a circle with it, once. False if the executor fails.
bool find_hessian_row_starts_in_box(const Executor &executor, const PeriodicUnion &periodic, uint32_t *first);

// In the caller's unit and frame. terms: with weights_in_box. False if the executor fails.
bool find_hessian_rows_in_box(const Executor &executor, const PeriodicUnion &periodic, const EnergyTerms &terms,
                              const HessianRows &rows);

}  // namespace hsp
