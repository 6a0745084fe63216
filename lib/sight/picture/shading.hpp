// The light on a ball as stops of a radial gradient over its disc, whose radius is 1.
//
// A stop turns a channel c in [0, 1] into c times a factor plus white. Headlight and soft differ in their tables alone.
#pragma once

#include "lanes/floating_point.hpp"
#include "picture/colour.hpp"

namespace hsp {

// Lambert's law for light from the viewer is ambient + diffuse sqrt(1 - rho^2) at the distance rho from the centre: a
// function of rho alone, which a radial gradient follows up to its linear pieces. Their largest error is least where
// the offsets equidistribute |f''|^(1/2) = (1 - rho^2)^(-3/4), f = sqrt(1 - rho^2): with rho = 1 - y^4, offset k of N
// is where G(y) = (1 - k/N) G(1), G(y) = integral of 4 (2 - s^4)^(-3/4) ds from 0 to y, G(1) = 2.6220576. For N = 16
// the error in f is at most .0034.
constexpr uint32_t headlight_intervals = 16;
constexpr double headlight_offset[headlight_intervals + 1] = {
    0.0,     0.162785, 0.319163, 0.463471, 0.591377, 0.700217, 0.789049, 0.858451, 0.910180,
    0.94675, 0.971043, 0.985972, 0.99424,  0.998175, 0.999639, 0.999977, 1.0};
constexpr double headlight_ambient = 0.36;
constexpr double headlight_diffuse = 0.64;

// Light from the direction L = (-.42, .52, .74) / |..|: left, above and before the balls. The gradient's circles have
// centre (1 - s) F and radius s, F = (-.34, .4). With n the normal and m the mean of .46 + .5 h^(3/2) + .2 n_z,
// h = (1 + n.L) / 2, over such a circle, the factor is m and where m > 1 a share 1.6 (m - 1) of white is mixed in;
// where m < 1 green loses .02 (1 - m) and blue gains .06 (1 - m), which keeps the shade cool. On top of that comes a
// highlight, a share .3 exp(-s^2 / .03) of white. Offsets s = 1 - .35 v^4 - .65 v with v = 1 - k/12; the first is 0.
struct SoftStop {
  double offset, red, green, blue, white;
};
constexpr uint32_t soft_intervals = 12;
constexpr double soft_focus[2] = {-0.34, 0.4};
constexpr SoftStop soft_stops[soft_intervals + 1] = {
    {0.000, 0.561, 0.561, 0.561, 0.439}, {0.157, 0.705, 0.705, 0.705, 0.295}, {0.290, 0.826, 0.826, 0.826, 0.174},
    {0.402, 0.880, 0.880, 0.880, 0.120}, {0.498, 0.926, 0.926, 0.926, 0.074}, {0.580, 0.973, 0.973, 0.973, 0.027},
    {0.653, 0.986, 0.986, 0.987, 0.000}, {0.719, 0.954, 0.953, 0.957, 0.000}, {0.779, 0.920, 0.918, 0.925, 0.000},
    {0.836, 0.882, 0.880, 0.889, 0.000}, {0.891, 0.838, 0.835, 0.848, 0.000}, {0.946, 0.782, 0.777, 0.795, 0.000},
    {1.000, 0.652, 0.645, 0.673, 0.000}};

class Shading {
 public:
  explicit Shading(bool soft) : soft_(soft) {}

  uint32_t intervals() const { return soft_ ? soft_intervals : headlight_intervals; }
  // Stops are numbered from 0 to intervals().
  double offset(uint32_t stop) const { return soft_ ? soft_stops[stop].offset : headlight_offset[stop]; }
  Rgb lit(const Rgb &colour, uint32_t stop) const {
    if (soft_) {
      const SoftStop &at = soft_stops[stop];
      const double white = 255.0 * at.white;
      return {{colour.channel[0] * at.red + white, colour.channel[1] * at.green + white,
               colour.channel[2] * at.blue + white}};
    }
    const double rho = headlight_offset[stop];
    const double light = headlight_ambient + headlight_diffuse * std::sqrt(1.0 - rho * rho);
    return {{colour.channel[0] * light, colour.channel[1] * light, colour.channel[2] * light}};
  }
  // The light of a stop as a colour K that is laid over any colour c with the opacity a = 1 - m, m the mean factor: c
  // becomes c m + a K. K holds the white and, for a c of .72 in each channel, the differences of the channels' factors.
  // So it is exact for the headlight.
  struct Glaze {
    Rgb colour;
    double opacity;
  };
  Glaze glaze(uint32_t stop) const {
    constexpr double usual = 0.72 * 255.0;
    const Rgb black = lit({{0.0, 0.0, 0.0}}, stop), white = lit({{255.0, 255.0, 255.0}}, stop);
    double mean = 0.0;
    for (int k = 0; k < 3; ++k) mean += (white.channel[k] - black.channel[k]) / (3 * 255.0);
    Glaze glaze{{{0.0, 0.0, 0.0}}, 1.0 - mean};
    for (int k = 0; k < 3 && glaze.opacity > 0.0; ++k) {
      const double factor = (white.channel[k] - black.channel[k]) / 255.0;
      const double channel = (usual * (factor - mean) + black.channel[k]) / glaze.opacity;
      glaze.colour.channel[k] = channel < 0.0 ? 0.0 : channel > 255.0 ? 255.0 : channel;
    }
    return glaze;
  }
  // The point to which the gradient's circles shrink, y up.
  double focus_x() const { return soft_ ? soft_focus[0] : 0.0; }
  double focus_y() const { return soft_ ? soft_focus[1] : 0.0; }

 private:
  bool soft_;
};

}  // namespace hsp
