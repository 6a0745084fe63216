// Queries in a periodic box: which balls, and which images of them, meet a ball in the box.
#pragma once

#include "model/queries.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

// The largest radius of a query ball, in units of the shortest of the box's three lengths along the axes.
inline constexpr int64_t widest_query = 64;

// Calls sink(j) for the balls of a range of the grid that meet a ball.
template <class Sink>
void visit_meeting(const BallSet &set, const BallRange &range, const exact::Vector &point, int64_t radius, Sink sink) {
  const Vec3 p = to_double(point);
  const double r = static_cast<double>(radius);
  for (uint32_t j = range.first; j < range.last; ++j) {
    if (meet(set.x[j] - p.x, set.y[j] - p.y, set.z[j] - p.z, set.r[j] + r)) sink(j);
  }
}

// Calls sink(k) for every ball or image that meets the query ball around a point of the box, in the grid's order. Its
// radius must not be larger than that of the largest ball: the set has no images that are farther away.
template <class Sink>
void visit_balls_at(const CubeGrid &grid, const exact::Vector &point, int64_t radius, Sink sink) {
  const BallSet &set = grid.balls();
  const CubeBlock block = grid.block_around(grid.cube_at(point));
  for (uint32_t k = 0; k < block.ranges; ++k) {
    visit_meeting(set, block.range[k], point, radius, [&](uint32_t j) { sink(set.caller[j]); });
  }
}

// Calls sink(i) for every ball in the box, but no image, that meets a query ball, which may be outside the box.
template <class Sink>
void visit_own_balls_at(const PeriodicUnion &periodic, const exact::Vector &point, int64_t radius, Sink sink) {
  const CubeGrid &grid = periodic.grid();
  const BallSet &set = grid.balls();
  const int64_t reach = radius + set.largest_radius;
  const CubeCoordinates low = grid.cube_at({point.x - reach, point.y - reach, point.z - reach});
  const CubeCoordinates high = grid.cube_at({point.x + reach, point.y + reach, point.z + reach});
  const auto visit_row = [&](const BallRange &row) {
    // Images are numbered behind all balls in the box.
    const BallRange own{row.first, row.last < grid.own_balls() ? row.last : grid.own_balls()};
    visit_meeting(set, own, point, radius, [&](uint32_t j) { sink(set.caller[j]); });
  };
  const double cubes = static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) *
                       static_cast<double>(high.z - low.z + 1);
  if (cubes > static_cast<double>(grid.own_cubes())) return visit_row({0, grid.own_balls()});
  for (int64_t z = low.z; z <= high.z; ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) visit_row(grid.balls_in_row(low.x, high.x, y, z));
  }
}

// Calls sink(i, shift) for every ball i and every image of it, `shift` from its place, that meets the query ball around
// a point of the box. If its radius is larger than that of every ball, the set lacks images: then copies of the query
// ball are compared with the balls in the box.
template <class Sink>
void visit_images_at(const PeriodicUnion &periodic, const exact::Vector &point, int64_t radius, Sink sink) {
  const PeriodicImages &images = periodic.images();
  if (radius <= images.largest_radius()) {
    return visit_balls_at(periodic.grid(), point, radius,
                          [&](uint32_t k) { sink(images.ball_of(k), images.shift_of(k)); });
  }
  const PeriodicBox &box = images.box();
  const auto visit_copy = [&](const BoxShift &shift) {
    const exact::Vector t = box.translation(shift);
    visit_own_balls_at(periodic, {point.x + t.x, point.y + t.y, point.z + t.z}, radius,
                       [&](uint32_t i) { sink(i, BoxShift{} - shift); });
  };
  visit_copy({});
  box.visit_images(point, radius + images.largest_radius(), visit_copy);
}

// Calls sink(k) for every ball or image that meets the caller's ball i, without itself; its own images may be among
// them.
template <class Sink>
void visit_neighbours_in_box(const PeriodicUnion &periodic, uint32_t i, Sink sink) {
  const exact::LatticeBall own = periodic.balls().ball(periodic.grid().grid_index(i));
  visit_balls_at(periodic.grid(), own.centre, own.radius, [&](uint32_t k) {
    if (k != i) sink(k);
  });
}

// Calls sink(i, block) for every ball i of the input with the block of cubes around it, cube by cube.
template <class Sink>
void visit_blocks_in_box(const PeriodicUnion &periodic, Sink sink) {
  const CubeGrid &grid = periodic.grid();
  for (uint32_t cube = 0; cube < grid.own_cubes(); ++cube) {
    const CubeBlock block = grid.block_around(grid.cube_list().coordinates(cube));
    const BallRange own = grid.balls_in(cube);
    for (uint32_t at = own.first; at < own.last; ++at) sink(grid.balls().caller[at], block);
  }
}

// Finds the balls and images in a block that meet a query ball around a point of the box, without ball `excluded`. Its
// radius must not be larger than that of the largest ball.
void find_in_block(const CubeGrid &grid, const CubeBlock &block, const exact::Vector &point, int64_t radius,
                   uint32_t excluded, QueryHits &hits);

// Hits of which none was dropped, ascending by their balls: of each first the ball in the box, then its images by their
// numbers.
struct OrderedHits {
  uint32_t ids[QueryHits::room + 8];
  uint32_t count;
};
void put_in_order(const PeriodicUnion &periodic, const QueryHits &hits, OrderedHits &ordered);

}  // namespace hsp
