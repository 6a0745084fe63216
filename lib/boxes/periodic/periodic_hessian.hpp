// All second derivatives of an energy by the centres of balls in a periodic box (curvature/hessian_rows.hpp). When a
// ball moves, all its images do: so the images of one ball share a block, and the terms of a ball with its own images
// cancel.
//
//   1 | 0   1 | 0    Two balls in a box as wide as both: the block of 0 and 1 is a sum of two terms, one for each side
//                    of 0. Seen from 1 there are the same two, transposed. Each term is computed on one of its two
//                    balls; which one depends on where the image lies. So both balls may have a part of a block.
#pragma once

#include "curvature/hessian_rows.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

// Finds where the rows of the balls of the input begin: first [n + 1], from 0 to the number of all entries. A row has
// an entry for its own ball, and one for each other ball that shares, itself or by an image, a free piece of a circle
// with it. False if the executor fails.
bool find_hessian_row_starts_in_box(const Executor &executor, const PeriodicUnion &periodic, uint32_t *first);

// Fills the rows, in the caller's unit and frame. terms: with weights_in_box(). False if the executor fails.
bool find_hessian_rows_in_box(const Executor &executor, const PeriodicUnion &periodic, const EnergyTerms &terms,
                              const HessianRows &rows);

}  // namespace hsp
