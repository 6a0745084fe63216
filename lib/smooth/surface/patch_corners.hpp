// Gives the corners of cut patches their numbers, and creases their twins. Nothing is measured: which corner is which
// follows from the patches that meet there, in the order around it.
#pragma once

#include "surface/cusped_circles.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {

// How many ends and creases another patch lacks, or has otherwise: 0 if the surface is closed. Not all of them if that
// is stopped.
uint32_t join_patches(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, CutPatches &patches);

}  // namespace hsp
