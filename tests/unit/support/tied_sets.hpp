// Balls that tie at a lattice point: all are at the same integer distance from it, as their centres are at integer
// distances.
#pragma once

#include <vector>

#include "carved_memory.hpp"
#include "lattice_ball.hpp"
#include "model/ball_set.hpp"
#include "random_balls.hpp"

// Balls as they are, none of which may lie inside another one.
class PlainBallSet {
 public:
  explicit PlainBallSet(const oracle::Balls &balls) {
    memory_.carve(set_, static_cast<uint32_t>(balls.size()));
    set_.n = static_cast<uint32_t>(balls.size());
    for (uint32_t i = 0; i < set_.n; ++i) {
      const oracle::LatticeBall &ball = balls[i];
      set_.store(i, {{ball.x, ball.y, ball.z}, ball.radius, i});
      set_.largest_radius = std::max(set_.largest_radius, ball.radius);
    }
  }
  const hsp::BallSet &set() const { return set_; }

 private:
  CarvedMemory memory_;
  hsp::BallSet set_;
};

struct TiedSet {
  oracle::LatticePoint point;
  int64_t level;
  oracle::Balls balls;              // none inside another one
  std::vector<oracle::Vector> way;  // from each centre to the point
};

inline bool lies_inside(const oracle::LatticeBall &a, const oracle::LatticeBall &b) {
  const oracle::Vector d = centre_difference(a, b);
  const oracle::Int128 e = b.radius - a.radius;
  return e >= 0 && oracle::dot(d, d) <= e * e;
}

// kinds: the number of kinds of directions (integer_length_vector); the fewer there are, the more balls lie opposite
// each other or in one plane. flat: all directions have z = 0.
inline TiedSet tied_set(oracle::RandomSource &random, size_t n, size_t kinds, bool flat) {
  TiedSet set{{random.in(-1000, 1000), random.in(-1000, 1000), random.in(-1000, 1000)}, random.in(-2, 40), {}, {}};
  for (int attempt = 0; set.balls.size() < n && attempt < 400; ++attempt) {
    const oracle::LatticeBall v = oracle::integer_length_vector(random, kinds);
    if (flat && v.z != 0) continue;
    const int64_t scale = random.in(1, 3) * 10;
    const oracle::LatticeBall ball{set.point[0] - scale * v.x, set.point[1] - scale * v.y, set.point[2] - scale * v.z,
                                   scale * v.radius - set.level};
    if (ball.radius < 0) continue;
    bool fits = true;
    for (const oracle::LatticeBall &other : set.balls)
      fits = fits && !lies_inside(ball, other) && !lies_inside(other, ball);
    if (!fits) continue;
    set.balls.push_back(ball);
    set.way.push_back({scale * v.x, scale * v.y, scale * v.z});
  }
  return set;
}
