#include "filter_bounds_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace filter_bounds {
namespace {

using hsp::exact::LatticeBall;

constexpr int64_t radius_end = int64_t{1} << 30;

// A number of either sign and of any magnitude below 2^bits: each number of bits is equally likely.
int64_t of_any_magnitude(oracle::RandomSource &random, int bits) {
  const int64_t size = int64_t{1} << (random.next() % static_cast<unsigned>(bits));
  return random.in(-size, size);
}

LatticeBall ball_with_radius(oracle::RandomSource &random, int64_t radius, int64_t reach, uint32_t index) {
  return {{random.in(-reach, reach), random.in(-reach, reach), random.in(-reach, reach)}, radius, index};
}

// A ball that meets `origin`, in a random direction, at a random distance between |r_0 - r| and r_0 + r.
LatticeBall ball_meeting(oracle::RandomSource &random, const LatticeBall &origin, int64_t radius, uint32_t index) {
  const LatticeBall direction = ball_with_radius(random, radius, 1 << 20, index);
  const double length = std::sqrt(static_cast<double>(hsp::exact::dot(direction.centre, direction.centre))) + 1e-9;
  const double least = static_cast<double>(std::abs(origin.radius - radius));
  const double most = static_cast<double>(origin.radius + radius);
  const double share = static_cast<double>(random.next() % 1000) / 1000.0;
  const double factor = (least + (most - least) * share) / length;
  const auto scaled = [factor](int64_t x) {
    return static_cast<int64_t>(std::lround(static_cast<double>(x) * factor));
  };
  return {{origin.centre.x + scaled(direction.centre.x), origin.centre.y + scaled(direction.centre.y),
           origin.centre.z + scaled(direction.centre.z)},
          radius,
          index};
}

// Changes the radius of ball 2 to one of the two neighbours between which the circles of balls 1 and 2 begin to touch.
void let_circles_touch(oracle::RandomSource &random, FourBalls &four) {
  const auto crosses = [&four](int64_t radius) {
    four.ball[2].radius = radius;
    if (hsp::exact::pair_relation(four.ball[0], four.ball[2]) != hsp::exact::PairRelation::circle) return -1;
    const perturbation::Balls balls = as_given(four);
    const perturbation::Origin origin(balls, 0);
    return origin.D(perturbation::half_space(balls, 0, 1), perturbation::half_space(balls, 0, 2)).sign() > 0 ? 1 : 0;
  };
  const int64_t start = four.ball[2].radius;
  const int at_start = crosses(start);
  int64_t other = start;
  for (int k = 0; k < 30 && crosses(other) != 1 - at_start; ++k) other = random.in(1, radius_end - 1);
  int64_t same = start;
  if (at_start >= 0 && crosses(other) == 1 - at_start) {
    while (std::abs(other - same) > 1) {
      const int64_t middle = same + (other - same) / 2;
      (crosses(middle) == at_start ? same : other) = middle;
    }
  }
  // Some steps away from this radius the circles cross well enough for the faster stage, or are well apart.
  four.ball[2].radius = std::clamp<int64_t>(same + of_any_magnitude(random, 16), 1, radius_end - 1);
}

}  // namespace

perturbation::Balls as_given(const FourBalls &four) {
  perturbation::Ball given[4];
  for (int k = 0; k < 4; ++k) {
    given[k] = {
        {four.ball[k].centre.x, four.ball[k].centre.y, four.ball[k].centre.z}, four.ball[k].radius, four.ball[k].index};
  }
  return perturbation::Balls(given, 0);
}

FourBalls random_balls(oracle::RandomSource &random, Kind kind) {
  for (;;) {
    FourBalls four;
    int64_t radius[4];
    for (int64_t &r : radius) r = random.in(radius_end / 4, radius_end - 1);
    if (kind == Kind::unlike_radii) {
      for (int64_t &r : radius) r = std::max<int64_t>(r >> (random.next() % 30), 1);
      if (random.next() % 2 == 0) radius[0] = random.in(1, 4);
    }
    four.ball[0] = {{0, 0, 0}, radius[0], 0};
    for (uint32_t k = 1; k < 4; ++k) four.ball[k] = ball_meeting(random, four.ball[0], radius[k], k);
    if (kind == Kind::parallel_axes) {
      for (int k = 2; k < 4; ++k) {
        const int64_t sign = random.next() % 2 == 0 ? 1 : -1;
        four.ball[k].centre = {sign * four.ball[1].centre.x + of_any_magnitude(random, 20),
                               sign * four.ball[1].centre.y + of_any_magnitude(random, 20),
                               sign * four.ball[1].centre.z + of_any_magnitude(random, 20)};
        four.ball[k].radius =
            std::clamp<int64_t>(four.ball[1].radius + of_any_magnitude(random, 25), 1, radius_end - 1);
      }
    }
    if (kind == Kind::touching_circles) let_circles_touch(random, four);
    if (four.valid(1)) return four;
  }
}

FourBalls changed(oracle::RandomSource &random, const FourBalls &four) {
  FourBalls next = four;
  const uint64_t numbers = 1 + random.next() % 3;
  for (uint64_t k = 0; k < numbers; ++k) {
    LatticeBall &ball = next.ball[random.next() % 4];
    int64_t *const number[] = {&ball.radius, &ball.centre.x, &ball.centre.y, &ball.centre.z};
    *number[random.next() % 4] += of_any_magnitude(random, 29);
  }
  return next;
}

}  // namespace filter_bounds
