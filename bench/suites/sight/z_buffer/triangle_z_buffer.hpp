// The paper's opponent (Section 5.1): a z-buffer in software that draws every ball as about 100 triangles, Gouraud
// shaded. All balls are copies of one mesh, so whatever does not depend on the ball is computed once in a frame: which
// triangles face away, the order of their corners from bottom to top, slopes of edges, gradients of depth and light.
// No triangle is divided by anything when it is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "z_buffer/placement.hpp"

namespace bench {

class TriangleZBuffer {
 public:
  // The mesh of a ball has its corners on the sphere: `bands` rings of `meridians` quadrilaterals, each cut into two
  // triangles, those at the poles being triangles. 10 meridians and 6 bands make 100 triangles.
  TriangleZBuffer(int meridians, int bands);

  size_t triangles() const { return mesh_.size(); }

  // A new frame: clears the image, turns the mesh by the same axes as the balls were and draws all balls. At most
  // 2^24 - 1 balls.
  void draw(const PlacedBalls &balls, const Axes &axes);

  // The ball seen in pixel (x, y), row 0 at the bottom; no_owner for none.
  uint32_t owner(int x, int y) const;

  // How light the pixel is, 0 to 255, by a lamp where the viewer is.
  uint32_t light(int x, int y) const { return colour_[index(x, y)] & 0xFF; }
  float depth(int x, int y) const { return depth_[index(x, y)]; }

 private:
  using Corner = std::array<float, 3>;

  // A triangle of the unit sphere that faces the viewer, ready to be drawn at any place and size. Rows go up from
  // corner[0] over corner[1] to corner[2].
  struct Facing {
    std::array<uint32_t, 3> corner;
    float left_slope[2];   // dx by dy of the left edge below and above corner[1]
    float right_slope[2];  // the same of the right edge
    uint32_t left_foot[2];
    uint32_t right_foot[2];  // the corners at which these edges begin
    float depth_by_x, depth_by_y;
    float light_by_x, light_by_y;
  };

  static size_t index(int x, int y) { return static_cast<size_t>(y) * row_length + static_cast<size_t>(x); }
  void turn_mesh(const Axes &axes);
  void add_facing(std::array<uint32_t, 3> corner);
  void draw_ball(const Facing *begin, const Facing *end, float x, float y, float z, float radius, uint32_t ball);

  std::vector<Corner> corner_;                 // on the unit sphere, in the molecule's axes
  std::vector<std::array<uint32_t, 3>> mesh_;  // corners counter-clockwise seen from outside
  std::vector<Corner> turned_;                 // the corners in this frame's axes
  std::vector<float> lightness_;               // of each corner, 0 to 255
  std::vector<Facing> facing_;
  std::vector<Corner> placed_;  // the corners of the ball that is drawn, in pixels
  std::vector<float> depth_;
  std::vector<uint32_t> colour_;  // 256 times the ball's number plus the light: an index in a table of colours
};

}  // namespace bench
