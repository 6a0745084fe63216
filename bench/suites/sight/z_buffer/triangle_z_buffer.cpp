// Compiled with -O3 -fno-math-errno, as the analytic one.
#include "z_buffer/triangle_z_buffer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "z_buffer/analytic_z_buffer.hpp"

namespace bench {
namespace {

constexpr uint32_t background = 0xFFFFFF00;
constexpr float ambient = 40;
constexpr float diffuse = 215;
constexpr unsigned lanes = 4;

// On the unit sphere: triangles that are seen nearly edge on, to this bound, are not drawn, and edges that rise less
// than this count as horizontal. Otherwise their gradients and slopes would magnify rounding errors.
constexpr float edge_on = 1e-3F;
constexpr float level = 1e-4F;

// `vectors` times `lanes` pixels of a row, of which the first `count` belong to the span. depth and light at the first
// one, and what they grow by from pixel to pixel.
void draw_span(float *__restrict depth, uint32_t *__restrict colour, int count, float z, float z_step, float light,
               float light_step, uint32_t base) {
  const unsigned pixels = (static_cast<unsigned>(count) + lanes - 1) / lanes * lanes;
  for (unsigned i = 0; i < pixels; ++i) {
    const int pixel = static_cast<int>(i);
    const float step = static_cast<float>(pixel);
    const float here = z + step * z_step;
    const uint32_t shade = base + static_cast<uint32_t>(static_cast<int>(light + step * light_step));
    const uint32_t within = pixel < count ? 0xFFFFFFFFU : 0U;
    const uint32_t above = (here > depth[i] ? 0xFFFFFFFFU : 0U) & within;
    const uint32_t before = std::bit_cast<uint32_t>(depth[i]);
    depth[i] = std::bit_cast<float>((std::bit_cast<uint32_t>(here) & above) | (before & ~above));
    colour[i] = (shade & above) | (colour[i] & ~above);
  }
}

// The first pixel whose centre is not left of (below) this coordinate, which is positive.
int first_from(float coordinate) {
  return static_cast<int>(coordinate + 0.5F);
}

}  // namespace

TriangleZBuffer::TriangleZBuffer(int meridians, int bands)
    : depth_(index(0, image_side)), colour_(index(0, image_side)) {
  const double pi = 3.141592653589793;
  corner_.push_back({0, 0, 1});
  for (int ring = 1; ring < bands; ++ring) {
    const double from_pole = pi * ring / bands;
    for (int meridian = 0; meridian < meridians; ++meridian) {
      const double angle = 2 * pi * (meridian + 0.5 * (ring % 2)) / meridians;
      corner_.push_back({static_cast<float>(std::sin(from_pole) * std::cos(angle)),
                         static_cast<float>(std::sin(from_pole) * std::sin(angle)),
                         static_cast<float>(std::cos(from_pole))});
    }
  }
  corner_.push_back({0, 0, -1});
  const auto at = [&](int ring, int meridian) {
    if (ring == 0) return 0U;
    if (ring == bands) return static_cast<uint32_t>(corner_.size() - 1);
    return static_cast<uint32_t>(1 + (ring - 1) * meridians + meridian % meridians);
  };
  // Odd rings are turned by half a step, so the diagonals of their quadrilaterals go alternately to one side and the
  // other.
  for (int ring = 0; ring < bands; ++ring) {
    for (int meridian = 0; meridian < meridians; ++meridian) {
      const uint32_t a = at(ring, meridian), b = at(ring, meridian + 1);
      const uint32_t c = at(ring + 1, meridian), d = at(ring + 1, meridian + 1);
      const bool odd = ring % 2 == 1;
      if (ring > 0) mesh_.push_back(odd ? std::array{a, d, b} : std::array{a, c, b});
      if (ring + 1 < bands) mesh_.push_back(odd ? std::array{a, c, d} : std::array{b, c, d});
    }
  }
  turned_ = corner_;
  placed_ = corner_;
  lightness_.resize(corner_.size());
}

void TriangleZBuffer::turn_mesh(const Axes &axes) {
  const auto product = [](const std::array<float, 3> &a, const Corner &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  for (size_t i = 0; i < corner_.size(); ++i) {
    turned_[i] = {product(axes.right, corner_[i]), product(axes.up, corner_[i]), product(axes.towards, corner_[i])};
    lightness_[i] = ambient + diffuse * std::clamp(turned_[i][2], 0.0F, 1.0F) * 0.999F;
  }
  facing_.clear();
  for (const std::array<uint32_t, 3> &corner : mesh_) add_facing(corner);
}

void TriangleZBuffer::add_facing(std::array<uint32_t, 3> corner) {
  const auto difference = [&](uint32_t from, uint32_t to, size_t axis) {
    return turned_[to][axis] - turned_[from][axis];
  };
  // Twice the area of the projection on the plane of two axes; the sign tells the side.
  const auto doubled_area = [&](size_t first, size_t second) {
    return difference(corner[0], corner[1], first) * difference(corner[0], corner[2], second) -
           difference(corner[0], corner[1], second) * difference(corner[0], corner[2], first);
  };
  const float whole_area = std::hypot(doubled_area(0, 1), doubled_area(1, 2), doubled_area(2, 0));
  if (!(doubled_area(0, 1) > edge_on * whole_area)) return;
  std::sort(corner.begin(), corner.end(), [&](uint32_t a, uint32_t b) {
    return turned_[a][1] != turned_[b][1] ? turned_[a][1] < turned_[b][1] : a < b;
  });
  const float area = doubled_area(0, 1);
  Facing facing{};
  facing.corner = corner;
  const auto slope = [&](uint32_t low, uint32_t high) {
    const float rise = difference(low, high, 1);
    return rise > level ? difference(low, high, 0) / rise : 0;
  };
  const float whole = slope(corner[0], corner[2]);
  const float halves[2] = {slope(corner[0], corner[1]), slope(corner[1], corner[2])};
  const bool middle_is_right = area > 0;
  for (size_t half = 0; half < 2; ++half) {
    facing.left_slope[half] = middle_is_right ? whole : halves[half];
    facing.right_slope[half] = middle_is_right ? halves[half] : whole;
    facing.left_foot[half] = middle_is_right ? corner[0] : corner[half];
    facing.right_foot[half] = middle_is_right ? corner[half] : corner[0];
  }
  const auto gradient = [&](float by_first, float by_second, float &by_x, float &by_y) {
    by_x = (by_first * difference(corner[0], corner[2], 1) - by_second * difference(corner[0], corner[1], 1)) / area;
    by_y = (by_second * difference(corner[0], corner[1], 0) - by_first * difference(corner[0], corner[2], 0)) / area;
  };
  gradient(difference(corner[0], corner[1], 2), difference(corner[0], corner[2], 2), facing.depth_by_x,
           facing.depth_by_y);
  gradient(lightness_[corner[1]] - lightness_[corner[0]], lightness_[corner[2]] - lightness_[corner[0]],
           facing.light_by_x, facing.light_by_y);
  facing_.push_back(facing);
}

void TriangleZBuffer::draw_ball(const Facing *begin, const Facing *end, float x, float y, float z, float radius,
                                uint32_t ball) {
  for (size_t i = 0; i < turned_.size(); ++i) {
    placed_[i] = {x + radius * turned_[i][0], y + radius * turned_[i][1], z + radius * turned_[i][2]};
  }
  const float one_by_radius = 1 / radius;
  const Corner *const placed = placed_.data();
  float *const depth = depth_.data();
  uint32_t *const colour = colour_.data();
  for (const Facing *triangle = begin; triangle != end; ++triangle) {
    const Corner &bottom = placed[triangle->corner[0]];
    const float light_by_x = triangle->light_by_x * one_by_radius;
    const float light_by_y = triangle->light_by_y * one_by_radius;
    const float light_at_bottom = lightness_[triangle->corner[0]];
    int row = first_from(bottom[1]);
    for (size_t half = 0; half < 2; ++half) {
      const Corner &left = placed[triangle->left_foot[half]];
      const Corner &right = placed[triangle->right_foot[half]];
      const int end_row = first_from(placed[triangle->corner[half + 1]][1]);
      for (; row < end_row; ++row) {
        const float height = static_cast<float>(row) + 0.5F;
        const int column = first_from(left[0] + triangle->left_slope[half] * (height - left[1]));
        const int end_column = first_from(right[0] + triangle->right_slope[half] * (height - right[1]));
        if (column >= end_column) continue;
        const float dx = static_cast<float>(column) + 0.5F - bottom[0];
        const float dy = height - bottom[1];
        const size_t at = index(column, row);
        draw_span(depth + at, colour + at, end_column - column,
                  bottom[2] + dx * triangle->depth_by_x + dy * triangle->depth_by_y, triangle->depth_by_x,
                  light_at_bottom + dx * light_by_x + dy * light_by_y, light_by_x, ball << 8);
      }
    }
  }
}

void TriangleZBuffer::draw(const PlacedBalls &balls, const Axes &axes) {
  std::fill(depth_.begin(), depth_.end(), -std::numeric_limits<float>::infinity());
  std::fill(colour_.begin(), colour_.end(), background);
  turn_mesh(axes);
  for (size_t ball = 0; ball < balls.radius.size(); ++ball) {
    draw_ball(facing_.data(), facing_.data() + facing_.size(), balls.x[ball], balls.y[ball], balls.z[ball],
              balls.radius[ball], static_cast<uint32_t>(ball));
  }
}

uint32_t TriangleZBuffer::owner(int x, int y) const {
  const uint32_t colour = colour_[index(x, y)];
  return colour == background ? no_owner : colour >> 8;
}

}  // namespace bench
