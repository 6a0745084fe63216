// Pictures as pixels, drawn by programs that may or may not be installed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

struct Raster {
  size_t width = 0;
  size_t height = 0;
  std::vector<uint8_t> rgb;  // row by row from the top, three bytes a pixel

  [[nodiscard]] const uint8_t *pixel(size_t x, size_t y) const { return &rgb[3 * (y * width + x)]; }
};

// Both readers throw std::runtime_error. PNG: 8 bits a channel, RGB or RGBA over white, not interlaced.
Raster read_ppm(const std::string &bytes);
Raster read_png(const std::string &bytes);

struct RasterDifference {
  double mean = 0;      // of all channels, of 255
  double far_off = 0;   // share of pixels with a channel that differs by more than 96
  double displaced = 0; /**< share of pixels that differ by more than 64 from every pixel of the other picture within
                           one pixel's distance: anti-aliasing does not count */
};
// Over what both pictures have; their sizes may differ by one.
RasterDifference difference(const Raster &a, const Raster &b);

// A picture `factor` times smaller: the mean of each square of pixels.
Raster averaged(const Raster &large, size_t factor);

bool has_program(const std::string &name);

// Runs a command in a folder of its own with `contents` in a file named `input` there; the contents of `output`.
// Throws std::runtime_error if the command fails or writes to standard error.
std::string run_on(const std::string &contents, const std::string &input, const std::string &command,
                   const std::string &output);
