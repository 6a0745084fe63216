// Balls at which derivatives of the smooth surface jump though none of their own vertices shows it: balls whose spheres
// pass through a vertex or a whole circle of other balls, so that they have no face there or one without area; and
// balls of a vertex whose probe touches another probe. All but the latter are decided in integers.
#pragma once

#include "model/cube_grid.hpp"
#include "surface/surface.hpp"

namespace hsp {

// Whether the sphere of one more ball passes through a vertex.
bool passes_through_vertex(const BallSet &balls, const VertexRecord &vertex, uint32_t ball);
// Whether it contains the whole circle of two balls that meet.
bool contains_circle(const BallSet &balls, uint32_t first, uint32_t second, uint32_t ball);

// Calls visit(ball), several times for some. any_tied: false if no vertex is tied.
template <class Visit>
void visit_degenerate_balls(const CubeGrid &grid, const Boundary &boundary, const Surface &surface, bool any_tied,
                            Visit visit) {
  const BallSet &balls = grid.balls();
  if (balls.probe_steps == 0) return;
  const auto for_each_near = [&](uint32_t ball, auto see) {
    const CubeBlock block = grid.block_around(grid.cube_at(balls.ball(ball).centre));
    for (uint32_t k = 0; k < block.ranges; ++k) {
      for (uint32_t j = block.range[k].first; j < block.range[k].last; ++j) see(j);
    }
  };
  for (uint32_t v = 0; any_tied && v < boundary.vertex_count(); ++v) {
    const VertexRecord &vertex = boundary.vertex(v);
    if (!vertex.tied()) continue;
    for_each_near(vertex.ball[0], [&](uint32_t j) {
      if (passes_through_vertex(balls, vertex, j)) visit(j);
    });
  }
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    const uint32_t first = boundary.circle(c).ball[0];
    const uint32_t second = boundary.circle(c).ball[1];
    for_each_near(first, [&](uint32_t j) {
      if (!contains_circle(balls, first, second, j)) return;
      visit(first);
      visit(second);
      visit(j);
    });
  }
  const RankedBits &touching = surface.touching();
  for (uint32_t k = 0; k < touching.size(); ++k) {
    for (const uint32_t ball : boundary.vertex(touching.member(k)).ball) visit(ball);
  }
}

}  // namespace hsp
