// Pictures painted from a view's pieces against the z-buffer.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "view_run.hpp"

// How many pixels show another ball than the z-buffer.
//
// THE RULE FOR EDGES. A pixel at whose centre both show the same ball, or balls with the same centre and radius, is
// right. Else it is excluded if the fronts of the two balls there have heights within 1e-9 of the largest radius,
// or if an arc of any piece passes within 1e-6 pixels of the centre. Else it is wrong. The same holds for pixels
// around which a piece runs neither 0 times nor 1 time, so that the even-odd rule and the non-zero rule agree.
struct PixelCount {
  size_t pixels = 0;
  size_t excluded = 0;
  size_t wrong = 0;
  std::string first_wrong;
};

inline constexpr double largest_excluded_share = 1e-3;

PixelCount wrong_pixels(const ViewRecords &view, const std::vector<oracle::PlainBall> &seen,
                        const std::vector<oracle::SeenPixel> &image, const oracle::PixelGrid &grid);

// Paints a scene from one direction in all ways, all_choices, with so many pixels on a side. Empty if no pixel is
// wrong and less than largest_excluded_share are excluded.
std::string pictures_disagree(const LibraryScene &scene, size_t pixels, const Direction &towards,
                              const Direction &up = {});
