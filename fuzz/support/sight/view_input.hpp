// Where to look from: along axes and diagonals, from anywhere, or turned by angles.
#pragma once

#include <hardsphere.h>

#include <algorithm>
#include <iterator>

#include "fuzz_input.hpp"

namespace fuzz {

struct Direction {
  double towards[3];
};
inline constexpr Direction nice_directions[] = {{{0, 0, 0}},  {{0, 0, 1}},   {{0, 0, -1}}, {{1, 0, 0}},  {{-3, 0, 0}},
                                                {{0, 1, 0}},  {{0, -1, 0}},  {{1, 1, 0}},  {{0, -1, 1}}, {{1, 1, 1}},
                                                {{-1, 1, 1}}, {{-2, -2, 2}}, {{3, 4, 0}},  {{1, 2, 2}},  {{-6, 2, 3}}};

inline double component(Bytes &bytes) {
  const uint32_t high = bytes.below(256), low = bytes.below(256);
  return (static_cast<double>(high) - 127.5) + static_cast<double>(low) / 256;
}

inline hsp_view_options view_options(Bytes &bytes) {
  hsp_view_options options;
  FUZZ_REQUIRE(hsp_view_options_init(&options, sizeof options) == HSP_OK, "hsp_view_options_init");
  const uint32_t kind = bytes.below(4);
  if (kind == 3) {
    const double x = component(bytes) * 3, y = component(bytes) * 3, z = component(bytes) * 3;
    FUZZ_REQUIRE(hsp_view_options_turn(&options, x, y, z) == HSP_OK, "hsp_view_options_turn");
  } else if (kind == 2) {
    for (double &x : options.towards) x = component(bytes);
    for (double &x : options.up) x = bytes.below(5) - 2.0;
  } else {
    const Direction &nice = nice_directions[bytes.below(static_cast<uint32_t>(std::size(nice_directions)))];
    std::copy(nice.towards, nice.towards + 3, options.towards);
  }
  options.pieces = bytes.below(2);
  options.flags = bytes.below(2);
  return options;
}

}  // namespace fuzz
