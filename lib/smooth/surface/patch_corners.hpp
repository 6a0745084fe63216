// Gives the corners of cut patches their numbers, and creases their twins. Nothing is measured: which corner is which
// follows from the patches that meet there, in the order around it.
#pragma once

#include "surface/cusped_circles.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {

struct PatchJoints {
  uint32_t crease_corners = 0;  // where three creases meet
  uint32_t creases = 0;         // each counted once
  uint32_t open = 0;            // ends and creases that another patch lacks: 0 if the surface is closed
  uint32_t uneven = 0;          // creases that may differ in their two patches (crease_lengths.hpp)
};

// Not all of them if that is stopped.
PatchJoints join_patches(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience,
                         CutPatches &patches);

}  // namespace hsp
