#include "four_balls.hpp"

#include <algorithm>
#include <utility>

using hsp::exact::LatticeBall;

namespace {

// Integer points at the distance 49 from the origin.
constexpr int64_t on_a_sphere[][3] = {{14, 21, 42}, {49, 0, 0}};

LatticeBall random_ball(oracle::RandomSource &random, int64_t size, uint32_t index) {
  LatticeBall ball;
  ball.centre = {random.in(-size, size), random.in(-size, size), random.in(-size, size)};
  ball.radius = random.in(size / 2, size);
  ball.index = index;
  return ball;
}

// Balls whose spheres all pass through the origin.
LatticeBall ball_through_origin(oracle::RandomSource &random, int64_t scale, uint32_t index) {
  LatticeBall ball;
  const auto &point = on_a_sphere[random.next() % 2];
  int64_t c[3] = {point[0], point[1], point[2]};
  for (int k = 2; k > 0; --k) std::swap(c[k], c[random.next() % static_cast<unsigned>(k + 1)]);
  for (int64_t &x : c) x = (random.next() & 1U ? -x : x) * scale;
  ball.centre = {c[0], c[1], c[2]};
  ball.radius = 49 * scale;
  ball.index = index;
  return ball;
}

}  // namespace

bool FourBalls::valid(int64_t least_radius) const {
  for (const LatticeBall &b : ball) {
    if (b.radius < least_radius || b.radius >= int64_t{1} << 30) return false;
  }
  for (int k = 1; k < 4; ++k) {
    if (hsp::exact::pair_relation(ball[0], ball[k]) != hsp::exact::PairRelation::circle) return false;
  }
  return true;
}

double FourBalls::length_squared() const {
  double bound = static_cast<double>(sphere().W);
  for (int k = 1; k < 4; ++k) {
    const hsp::exact::Vector v = plane(k).v;
    bound = std::max(bound, static_cast<double>(dot(v, v)));
  }
  return bound;
}

FourBalls random_four_balls(oracle::RandomSource &random) {
  constexpr int64_t sizes[] = {1, 2, 3, 5, 8, 100, 1 << 20, (1 << 28) - 1, (1 << 29) - 3, (int64_t{1} << 30) - 1};
  for (;;) {
    FourBalls four;
    const uint64_t mode = random.next() % 8;
    const int64_t size = sizes[random.next() % 10];
    for (uint32_t k = 0; k < 4; ++k) {
      four.ball[k] =
          mode < 3 ? ball_through_origin(random, 1 + random.in(0, 1) * (size / 64), k) : random_ball(random, size, k);
      if (mode == 4) four.ball[k].centre.z = 0;
      if (mode == 5 && k > 0) four.ball[k].radius = four.ball[0].radius;
    }
    // Next to a tie rather than on it.
    if (mode == 2) four.ball[random.next() % 4].radius += static_cast<int64_t>(random.next() % 3) - 1;
    if (four.valid(0)) return four;
  }
}
