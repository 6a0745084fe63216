// Colours by element and by chain.
#pragma once

#include <cstdint>

namespace hsp {

enum class Palette : uint32_t { soft = 0, jmol = 1, chain = 2 };

// 0xRRGGBB. Elements beyond 109 and atomic number 0 are unknown; tints repeat after 12 chains.
uint32_t palette_colour(Palette palette, uint32_t atomic_number, uint32_t chain);

}  // namespace hsp
