// Compiled with -O3 -fno-math-errno, so that the compiler makes vector instructions of the loop over a row of pixels.
#include "z_buffer/analytic_z_buffer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace bench {
namespace {

// Pixels at a time: rows are rounded up to whole vectors, so that none of their pixels is left to be done one by one.
constexpr unsigned lanes = 4;

// A row of `vectors` times `lanes` pixels from `depth` and `owner` on. dx is the first one's distance from the centre,
// square is that of the half-width of the disc in this row. Outside the disc the root is NaN, which is not above
// anything.
void draw_row(float *__restrict depth, uint32_t *__restrict owner, unsigned vectors, float dx, float square,
              float centre, uint32_t ball) {
  const unsigned count = vectors * lanes;
  for (unsigned i = 0; i < count; ++i) {
    const float offset = dx + static_cast<float>(static_cast<int>(i));
    const float z = centre + std::sqrt(square - offset * offset);
    // Both selections are made on bits: g++ 12 compiles a selection between floats to a branch, and then makes no
    // vectors.
    const uint32_t above = z > depth[i] ? 0xFFFFFFFFU : 0U;
    const uint32_t before = std::bit_cast<uint32_t>(depth[i]);
    depth[i] = std::bit_cast<float>((std::bit_cast<uint32_t>(z) & above) | (before & ~above));
    owner[i] = (ball & above) | (owner[i] & ~above);
  }
}

// The first pixel whose centre is not left of (below) this coordinate, which is positive.
int first_from(float coordinate) {
  return static_cast<int>(coordinate + 0.5F);
}

}  // namespace

AnalyticZBuffer::AnalyticZBuffer() : depth_(index(0, image_side)), owner_(depth_.size()) {}

void AnalyticZBuffer::draw(const PlacedBalls &balls) {
  std::fill(depth_.begin(), depth_.end(), -std::numeric_limits<float>::infinity());
  std::fill(owner_.begin(), owner_.end(), no_owner);
  float *const depth = depth_.data();
  uint32_t *const owner = owner_.data();
  const size_t count = balls.radius.size();
  for (size_t ball = 0; ball < count; ++ball) {
    const float x = balls.x[ball];
    const float y = balls.y[ball];
    const float z = balls.z[ball];
    const float radius = balls.radius[ball];
    const int last_row = first_from(y + radius) - 1;
    for (int row = first_from(y - radius); row <= last_row; ++row) {
      const float dy = static_cast<float>(row) + 0.5F - y;
      const float square = std::max(radius * radius - dy * dy, 0.0F);
      const float half_width = std::sqrt(square);
      const int end = first_from(x + half_width);
      const int column = first_from(x - half_width);
      if (column >= end) continue;
      const size_t at = index(column, row);
      draw_row(depth + at, owner + at, (static_cast<unsigned>(end - column) + lanes - 1) / lanes,
               static_cast<float>(column) + 0.5F - x, square, z, static_cast<uint32_t>(ball));
    }
  }
}

}  // namespace bench
