// Arithmetic on colours as they are written: encoded channels, as renderers interpolate them.
#pragma once

#include <cstdint>

namespace hsp {

// Channels from 0 to 255.
struct Rgb {
  double channel[3];
};

inline Rgb unpacked(uint32_t colour) {
  return {{static_cast<double>(colour >> 16 & 255), static_cast<double>(colour >> 8 & 255),
           static_cast<double>(colour & 255)}};
}

inline uint32_t packed(const Rgb &rgb) {
  uint32_t colour = 0;
  for (const double channel : rgb.channel) {
    const double level = channel < 0.0 ? 0.0 : channel > 255.0 ? 255.0 : channel;
    colour = colour << 8 | static_cast<uint32_t>(level + 0.5);
  }
  return colour;
}

inline Rgb mixed(const Rgb &a, const Rgb &b, double share_of_b) {
  Rgb result;
  for (int k = 0; k < 3; ++k) result.channel[k] = a.channel[k] + (b.channel[k] - a.channel[k]) * share_of_b;
  return result;
}

inline uint32_t mixed(uint32_t a, uint32_t b, double share_of_b) {
  return packed(mixed(unpacked(a), unpacked(b), share_of_b));
}

}  // namespace hsp
