// Gives the corners of cut patches their numbers, and creases their twins. Nothing is measured: which corner is which
// follows from the patches that meet there and their order around it.
#pragma once

#include "surface/cusped_circles.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {

// Returns how many ends and creases of a patch have no match in the patches beside it, or one that differs: 0 if the
// surface is closed. Not all are counted if `patience` stops it.
uint32_t join_patches(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, CutPatches &patches);

}  // namespace hsp
