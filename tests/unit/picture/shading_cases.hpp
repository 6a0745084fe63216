// The stops of both kinds of light against the light that they approximate.
#pragma once

#include <cmath>
#include <initializer_list>

#include "cases.hpp"
#include "picture/shading.hpp"

namespace cases {

// The headlight's stops before they are rounded to colours: linear in between, within .0034 of the light's range.
inline uint32_t headlight_stops_are_where_they_serve_best() {
  const hsp::Shading shading(false);
  const auto light = [&](uint32_t stop) { return shading.lit({{255, 255, 255}}, stop).channel[1]; };
  const double rim = light(shading.intervals());
  const double rise = light(0) - rim;
  for (uint32_t k = 0; k < shading.intervals(); ++k) {
    for (int i = 0; i <= 100; ++i) {
      const double share = i / 100.0;
      const double rho = shading.offset(k) + (shading.offset(k + 1) - shading.offset(k)) * share;
      const double drawn = light(k) + (light(k + 1) - light(k)) * share;
      if (!near((drawn - rim) / rise, std::sqrt(1 - rho * rho), .0034)) return k;
    }
  }
  return all_hold;
}

// The mean of .46 + .5 h^(3/2) + .2 n_z, h = (1 + n.L) / 2, over the circle of soft light with radius s.
inline double mean_of_soft_light(double s) {
  constexpr double L[3] = {-.42, .52, .74};
  const double length = std::sqrt(L[0] * L[0] + L[1] * L[1] + L[2] * L[2]);
  constexpr int points = 720;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double t = (k + .5) * 2 * hsp::pi / points;
    const double x = (1 - s) * -.34 + s * std::cos(t), y = (1 - s) * .4 + s * std::sin(t);
    const double z = std::sqrt(std::fmax(0, 1 - x * x - y * y));
    const double h = (1 + (x * L[0] + y * L[1] + z * L[2]) / length) / 2;
    sum += .46 + .5 * h * std::sqrt(h) + .2 * z;
  }
  return sum / points;
}

// As the header describes them, to the three digits that they are given with.
inline uint32_t soft_stops_are_those_of_the_light() {
  const hsp::Shading shading(true);
  for (uint32_t k = 0; k <= shading.intervals(); ++k) {
    const double v = 1 - k / 12.0, s = 1 - .35 * v * v * v * v - .65 * v;
    const double m = mean_of_soft_light(s);
    const double factor = m < 1 ? m : 1, dark = 1 - factor;
    const double kept = (1 - (m > 1 ? 1.6 * (m - 1) : 0)) * (1 - .3 * std::exp(-s * s / .03));
    const hsp::Rgb black = shading.lit({{0, 0, 0}}, k), white = shading.lit({{255, 255, 255}}, k);
    const double channel[3] = {factor, factor - .02 * dark, factor + .06 * dark};
    if (!near(shading.offset(k), s, .0005 + 1e-6)) return k;
    for (int c = 0; c < 3; ++c) {
      if (!near(black.channel[c] / 255, 1 - kept, .0005 + 1e-6)) return k;
      if (!near((white.channel[c] - black.channel[c]) / 255, channel[c] * kept, .0005 + 1e-6)) return k;
    }
  }
  return all_hold;
}

// Light that is laid over a colour makes of it what it makes of it at once: of every colour for the headlight, of blue
// for soft light where it has the brightness that the glaze is for, and of all others nearly.
inline uint32_t glazes_light_colours() {
  constexpr double usual = .72 * 255;
  for (const bool soft : {false, true}) {
    const hsp::Shading shading(soft);
    for (uint32_t k = 0; k <= shading.intervals(); ++k) {
      const hsp::Shading::Glaze glaze = shading.glaze(k);
      if (glaze.opacity < 0 || glaze.opacity >= 1) return k;
      for (const double c : {0., 60., 130., usual, 255.}) {
        const hsp::Rgb lit = shading.lit({{c, c, c}}, k);
        for (int channel = 0; channel < 3; ++channel) {
          if (glaze.colour.channel[channel] < 0 || glaze.colour.channel[channel] > 255) return k;
          const double laid = c * (1 - glaze.opacity) + glaze.colour.channel[channel] * glaze.opacity;
          const bool exact = !soft || (c == usual && channel == 2);
          if (!near(laid, lit.channel[channel], exact ? 1e-9 : 5)) return k;
        }
      }
    }
  }
  return all_hold;
}

inline constexpr Check picture_shading[] = {
    {"headlight_stops_are_where_they_serve_best", headlight_stops_are_where_they_serve_best},
    {"soft_stops_are_those_of_the_light", soft_stops_are_those_of_the_light},
    {"glazes_light_colours", glazes_light_colours}};

}  // namespace cases
