#include "draw/colour_mixed.h"

uint32_t colour_mixed(uint32_t a, uint32_t b, double share_of_b) {
  uint32_t colour = 0;
  for (int shift = 16; shift >= 0; shift -= 8) {
    const double from = (double)(a >> shift & 0xFF);
    const double to = (double)(b >> shift & 0xFF);
    colour = colour << 8 | (uint32_t)(from + (to - from) * share_of_b + 0.5);
  }
  return colour;
}
