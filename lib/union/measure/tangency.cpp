#include "measure/tangency.hpp"

#include "sphere/caps.hpp"

namespace hsp {

BallsThatMayMeet::BallsThatMayMeet(const CubeGrid &grid, uint32_t i) {
  if (const RadiusLevels *const levels = grid.levels()) {
    const uint32_t found = levels->find_neighbours(grid.balls(), i, few_, most_few);
    if (found <= most_few) {
      are_few_ = true;
      block_.ranges = 1;
      block_.range[0] = {0, found};
      return;
    }
  }
  block_ = grid.block_around(grid.cube_at(grid.balls().ball(i).centre));
}

bool lies_inside_another(const CubeGrid &grid, uint32_t i) {
  return !BallsThatMayMeet(grid, i).all_of([&](uint32_t j) { return !lies_inside(grid.balls(), i, j); });
}

bool InnerTouch::is_free_with(uint32_t outer) {
  const exact::LatticeBall own = balls_.ball(inner_), container = balls_.ball(outer);
  const int64_t D = container.radius - own.radius;
  const exact::Vector v = own.centre - container.centre;
  if (D < 0 || !exact::within(v, D) || dot(v, v) != D * D) return false;
  if (D == 0) return true;  // equal balls: without a look at third ones, as there may be thousands in one place
  if (!point_is_known_) {
    point_is_known_ = true;
    point_is_free_ = no_third_covers(container, v, D);
  }
  return point_is_free_;
}

// The point is c + R v/D, c and R of the outer ball. Seen from the centre c_k of a third ball, D times that is
// D (c - c_k) + R v, with components below 2^62.
bool InnerTouch::no_third_covers(const exact::LatticeBall &container, const exact::Vector &v, int64_t D) const {
  return around_.all_of([&](uint32_t k) {
    const exact::LatticeBall third = balls_.ball(k);
    const exact::Vector w = container.centre - third.centre;
    if (!exact::within(w, third.radius + container.radius)) return true;
    const exact::Vector point{D * w.x + container.radius * v.x, D * w.y + container.radius * v.y,
                              D * w.z + container.radius * v.z};
    // The point lies exactly on the spheres of the two balls themselves, and so not in their interiors.
    return exact::power(point, D * third.radius).sign() >= 0;
  });
}

void flag_free_inner_contacts(const CubeGrid &grid, const Boundary &boundary, uint32_t flag, uint32_t *flags) {
  const BallSet &balls = grid.balls();
  visit_free_inner_contacts(grid, boundary, [&](uint32_t inner, uint32_t outer) {
    flags[balls.caller[inner]] |= flag;
    flags[balls.caller[outer]] |= flag;
  });
}

}  // namespace hsp
