#include "pores/balls_around.hpp"

#include <cmath>

namespace hsp {

BallsAround::BallsAround(const CubeGrid &grid) : grid_(&grid) {
  const BallSet &balls = grid.balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    const exact::Vector centre = balls.ball(i).centre;
    const auto cover = [i](int64_t x, int64_t &low, int64_t &high) {
      low = i == 0 || x < low ? x : low;
      high = i == 0 || x > high ? x : high;
    };
    cover(centre.x, centres_.low.x, centres_.high.x);
    cover(centre.y, centres_.low.y, centres_.high.y);
    cover(centre.z, centres_.low.z, centres_.high.z);
  }
}

uint32_t BallsAround::find(const LatticeQuery &query, NearImage *near, uint32_t room) const {
  if (periodic_ == nullptr) {
    uint32_t ids[most];
    QueryResult result{ids, room, 0};
    find_balls_at_ball(*grid_, query, result);
    for (uint32_t k = 0; k < result.hits && result.hits <= room; ++k) near[k] = {ids[k], {}};
    return result.hits;
  }
  uint32_t hits = 0;
  visit(query, [&](const NearImage &image) {
    if (hits < room) near[hits] = image;
    ++hits;
  });
  return hits;
}

uint32_t BallsAround::find_deep(const exact::Vector &point, double reach, NearImage *near, uint32_t room) const {
  uint32_t hits = 0;
  visit({point, 0}, [&](const NearImage &image) {
    const exact::LatticeBall deep = ball(image);
    const Vec3 y = to_double(point - deep.centre);
    if (std::sqrt(dot(y, y)) - static_cast<double>(deep.radius) > reach) return;
    if (hits < room) near[hits] = image;
    ++hits;
  });
  return hits;
}

}  // namespace hsp
