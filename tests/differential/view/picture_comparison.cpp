#include "picture_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace {

using oracle::no_ball;

constexpr size_t wrong_pixels_looked_at = 1000;  // a broken picture need not be searched for edges everywhere

std::string name_of(uint32_t ball) {
  return ball == no_ball ? "background" : "ball " + std::to_string(ball);
}

}  // namespace

PixelCount wrong_pixels(const ViewRecords &view, const std::vector<oracle::PlainBall> &seen,
                        const std::vector<oracle::SeenPixel> &image, const oracle::PixelGrid &grid) {
  const std::vector<oracle::Path> paths = view.paths();
  const oracle::PaintedImage picture = oracle::painted(paths, grid);
  double largest = 0;
  for (const oracle::PlainBall &ball : seen) largest = std::max(largest, ball.radius);

  PixelCount count;
  count.pixels = grid.pixels();
  const auto judge = [&](size_t pixel, bool same_height, const std::string &what) {
    const double x = grid.x(pixel % grid.columns);
    const double y = grid.y(pixel / grid.columns);
    const bool edge = same_height || (count.wrong < wrong_pixels_looked_at &&
                                      std::any_of(paths.begin(), paths.end(), [&](const oracle::Path &path) {
                                        return oracle::passes_near(path, x, y, 1e-6 * grid.side);
                                      }));
    if (edge) {
      ++count.excluded;
      return;
    }
    if (count.wrong++ != 0) return;
    std::ostringstream text;
    text.precision(17);
    text << "at (" << x << ", " << y << "): " << what;
    count.first_wrong = text.str();
  };

  for (size_t k = 0; k < grid.pixels(); ++k)
    for (const uint32_t piece : {picture.even_odd[k], picture.non_zero[k]}) {
      const uint32_t shown = piece == no_ball ? no_ball : view.pieces[piece].ball;
      const uint32_t expected = image[k].ball;
      if (shown == expected) continue;
      bool same_height = false;
      if (shown < seen.size() && expected != no_ball) {
        if (seen[shown].centre == seen[expected].centre && seen[shown].radius == seen[expected].radius) continue;
        const double height = oracle::front_of(seen[shown], grid.x(k % grid.columns), grid.y(k / grid.columns));
        same_height = std::abs(height - image[k].depth) < 1e-9 * largest;
      }
      judge(k, same_height, name_of(shown) + " instead of " + name_of(expected));
      break;
    }
  for (const oracle::PaintedImage::Winding &winding : picture.windings)
    judge(winding.pixel, false,
          "the piece of " + name_of(view.pieces[winding.path].ball) + " runs " + std::to_string(winding.times) +
              " times around");
  return count;
}

std::string pictures_disagree(const LibraryScene &scene, size_t pixels, const Direction &towards, const Direction &up) {
  oracle::ViewAxes axes;
  std::vector<oracle::PlainBall> seen;
  oracle::PixelGrid grid;
  std::vector<oracle::SeenPixel> image;
  for (const ViewChoice &choice : all_choices(towards, up)) {
    const ViewRecords view = view_of(scene, choice);
    const oracle::ViewAxes own = view.axes();
    if (image.empty() || own.origin != axes.origin || own.right != axes.right || own.up != axes.up ||
        own.towards != axes.towards) {
      axes = own;
      seen = oracle::seen_along(scene.balls(), axes);
      grid = oracle::grid_around(seen, pixels);
      image = oracle::z_buffer(seen, grid);
    }
    const PixelCount count = wrong_pixels(view, seen, image, grid);
    if (count.wrong > 0)
      return choice.text() + ": " + std::to_string(count.wrong) + " of " + std::to_string(count.pixels) +
             " pixels wrong, first " + count.first_wrong;
    if (static_cast<double>(count.excluded) >= largest_excluded_share * static_cast<double>(count.pixels))
      return choice.text() + ": " + std::to_string(count.excluded) + " of " + std::to_string(count.pixels) +
             " pixels are on edges";
  }
  return "";
}
