// Palettes: colours by which elements are known, unknown elements, and chains. Every colour is in
// api_sight_palette_colours.
#pragma once

#include <initializer_list>

#include "cases.hpp"
#include "picture/palettes.hpp"

namespace cases {

using hsp::Palette;

// From the table "Jmol colors" of Jmol's documentation, in decimal as it stands there: noble gases, and the last one.
struct Element {
  uint32_t number, red, green, blue;
};
constexpr Element elements[] = {{1, 255, 255, 255}, {2, 217, 255, 255},  {6, 144, 144, 144}, {7, 48, 80, 248},
                                {8, 255, 13, 13},   {10, 179, 227, 245}, {16, 255, 255, 48}, {18, 128, 209, 227},
                                {36, 92, 184, 209}, {54, 66, 158, 176},  {86, 66, 130, 150}, {109, 235, 0, 38}};

inline uint32_t elements_of_jmol() {
  return first_failing(elements, [](const Element &c) {
    for (uint32_t chain = 0; chain < 13; ++chain) {
      const uint32_t expected = c.red << 16 | c.green << 8 | c.blue;
      if (hsp::palette_colour(Palette::jmol, c.number, chain) != expected) return false;
    }
    return true;
  });
}

// Elements beyond 109 and the number 0.
constexpr uint32_t unknown[] = {0, 110, 118, 255, 1000000, 0xFFFFFFFF};

inline uint32_t unknown_elements_have_one_colour() {
  return first_failing(unknown, [](uint32_t number) {
    for (const Palette palette : {Palette::soft, Palette::jmol}) {
      const uint32_t colour = hsp::palette_colour(palette, number, 0);
      if (colour != hsp::palette_colour(palette, 0, 5)) return false;
      for (uint32_t known = 1; known < 110; ++known) {
        if (hsp::palette_colour(palette, known, 0) == colour) return false;
      }
    }
    return true;
  });
}

// Of two colours the largest difference of a channel.
inline uint32_t difference(uint32_t a, uint32_t b) {
  uint32_t largest = 0;
  for (uint32_t shift = 0; shift < 24; shift += 8) {
    const uint32_t p = a >> shift & 255, q = b >> shift & 255;
    largest = p > q + largest ? p - q : q > p + largest ? q - p : largest;
  }
  return largest;
}

// Twelve distinct tints, then the same again; atoms other than carbon are darker.
inline uint32_t chains_have_tints() {
  for (uint32_t chain = 0; chain < 40; ++chain) {
    const uint32_t tint = hsp::palette_colour(Palette::chain, 6, chain);
    const uint32_t other = hsp::palette_colour(Palette::chain, 8, chain);
    if (hsp::palette_colour(Palette::chain, 6, chain + 12) != tint) return chain;
    for (uint32_t k = 1; k < 12; ++k) {
      if (difference(hsp::palette_colour(Palette::chain, 6, chain + k), tint) < 10) return chain;
    }
    for (uint32_t shift = 0; shift < 24; shift += 8) {
      if ((other >> shift & 255) >= (tint >> shift & 255)) return chain;
    }
    if (hsp::palette_colour(Palette::chain, 0, chain) != other) return chain;
  }
  return all_hold;
}

inline constexpr Check picture_palettes[] = {{"elements_of_jmol", elements_of_jmol},
                                             {"unknown_elements_have_one_colour", unknown_elements_have_one_colour},
                                             {"chains_have_tints", chains_have_tints}};

}  // namespace cases
