#include "cells/cell_location.hpp"

#include <limits>

#include "cells/power_predicates.hpp"
#include "exact/power.hpp"
#include "model/grid_order.hpp"

namespace hsp {
namespace {

using I128 = exact::WideInteger<exact::FastLimb, 128>;

I128 exact_power(const exact::LatticeBall &ball, const exact::Vector &point) {
  const exact::Vector d = point - ball.centre;
  return exact::power(d, ball.radius);
}

// The power of a point to a ball, in doubles.
double power(const BallSet &balls, uint32_t ball, const Vec3 &point) {
  const Vec3 d = point - Vec3{balls.x[ball], balls.y[ball], balls.z[ball]};
  return dot(d, d) - balls.r[ball] * balls.r[ball];
}

// Whether a point has less power to ball a than to ball b; for equal powers the ball of lower rank has less, as it is
// inflated more.
bool has_less_power(const BallSet &balls, uint32_t a, uint32_t b, const exact::Vector &point) {
  const int sign = (exact_power(balls.ball(a), point) - exact_power(balls.ball(b), point)).sign();
  return sign != 0 ? sign < 0 : balls.ranks_before(a, b);
}

// The free part of the power cell of a ball that holds a point.
uint32_t part_at(const BallSet &balls, const FreeSpace &space, IdRange parts, const CubeFrame &frame,
                 const exact::Vector &point) {
  const uint32_t ball = space.cell(parts.first).ball;
  const PowerPredicates exact(balls, ball, frame);
  for (const uint32_t cell : parts) {
    for (const uint32_t k : space.landmarks_of(cell)) {
      const uint32_t *const code = space.landmarks[k].code;
      if (exact.reaches(plane_of_code(code[0], ball), plane_of_code(code[1], ball), plane_of_code(code[2], ball),
                        point)) {
        return cell;
      }
    }
  }
  return parts.first;  // not reached
}

}  // namespace

uint32_t cell_at(const BallSet &balls, const FreeSpace &space, const exact::Vector &point) {
  const CubeAxis axis(space.side);
  const CubeCoordinates at = axis.cube_at(point);
  const uint32_t cube = space.cover.find(at);
  if (cube == no_id) return space.runs.find(space.cover, at);
  const Span<const uint32_t> members = space.cover.balls(cube);
  const Vec3 x = exact::to_double(point);
  const double side = static_cast<double>(space.side);
  const double error = 64 * unit_roundoff * side * side;
  // The least and the second least power, without a branch: in the one form that compilers recognise as a minimum and a
  // maximum, and with a mask where g++ 12 would make a jump.
  uint32_t best = 0;
  double least = power(balls, members[0], x), second = std::numeric_limits<double>::infinity();
  for (uint32_t k = 1; k < members.size(); ++k) {
    const double candidate = power(balls, members[k], x);
    const double larger = least < candidate ? candidate : least;
    second = larger < second ? larger : second;
    best ^= (best ^ k) & (0U - static_cast<uint32_t>(candidate < least));
    least = candidate < least ? candidate : least;
  }
  if (second <= least + error) {
    const double limit = least + error;
    for (uint32_t k = 0; k < members.size(); ++k) {
      if (k == best || power(balls, members[k], x) > limit) continue;
      if (has_less_power(balls, members[k], members[best], point)) best = k;
    }
    least = power(balls, members[best], x);
  }
  if (!(least > error) && (least < -error || exact_power(balls.ball(members[best]), point).sign() <= 0)) return no_id;
  const IdRange parts = space.parts_of(space.cover.first_entry(cube) + best);
  if (parts.size() == 1) return parts.first;
  return part_at(balls, space, parts, CubeFrame(at, space.side), point);
}

}  // namespace hsp
