// Gives the corners of cut patches their numbers, and creases their twins. Nothing is measured: which corner is which
// follows from the patches that meet there, in the order around it.
#pragma once

#include "surface/cusped_circles.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {

// A crease is measured in both of its patches, which have found its ends each on its own. They agree to this angle
// where doubles know them well enough.
inline constexpr double crease_tolerance = 1e-6;

// How many ends and creases another patch lacks, or has otherwise: 0 if the surface is closed. Not all of them if that
// is stopped.
uint32_t join_patches(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, CutPatches &patches);

}  // namespace hsp
