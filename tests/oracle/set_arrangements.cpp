#include "set_arrangements.hpp"

#include <algorithm>
#include <cstdlib>

namespace oracle {

namespace {

constexpr int64_t farthest = int64_t{1} << 50;
constexpr int64_t largest_radius = (int64_t{1} << 30) - 1;

}  // namespace

Balls moved(const Balls &balls, const LatticePoint &shift) {
  Balls result;
  for (const LatticeBall &b : balls) result.push_back({b.x + shift[0], b.y + shift[1], b.z + shift[2], b.radius});
  return result;
}

Balls grown(const Balls &balls, int64_t probe) {
  Balls result = balls;
  for (LatticeBall &b : result) b.radius += probe;
  return result;
}

Balls along_axes(const Balls &balls, const std::array<size_t, 3> &axes, uint32_t reflected) {
  Balls result;
  for (const LatticeBall &b : balls) {
    const LatticePoint from = centre_of(b);
    LatticePoint to{};
    for (size_t k = 0; k < 3; ++k) to[k] = (reflected >> k & 1U) != 0 ? -from[axes[k]] : from[axes[k]];
    result.push_back(ball_around(to, b.radius));
  }
  return result;
}

std::vector<Balls> axis_symmetries(const Balls &balls) {
  std::vector<Balls> images;
  for (uint32_t reflected = 0; reflected < 8; ++reflected) {
    std::array<size_t, 3> axes = {0, 1, 2};
    do images.push_back(along_axes(balls, axes, reflected));
    while (std::next_permutation(axes.begin(), axes.end()));
  }
  return images;
}

std::vector<LatticePoint> shifts_within_lattice(const Balls &balls) {
  LatticePoint low = {0, 0, 0};
  LatticePoint high = {0, 0, 0};
  for (size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint centre = centre_of(balls[i]);
    for (size_t k = 0; k < 3; ++k) {
      low[k] = i == 0 ? centre[k] : std::min(low[k], centre[k]);
      high[k] = i == 0 ? centre[k] : std::max(high[k], centre[k]);
    }
  }
  const std::array<LatticePoint, 5> wanted = {{{1, -2, 3},
                                               {1000003, -999983, 1000033},
                                               {farthest - high[0], farthest - high[1], farthest - high[2]},
                                               {-farthest - low[0], -farthest - low[1], -farthest - low[2]},
                                               {farthest - high[0], -farthest - low[1], -1}}};
  std::vector<LatticePoint> shifts;
  for (const auto &shift : wanted) {
    bool fits = true;
    for (size_t k = 0; k < 3; ++k) fits = fits && low[k] + shift[k] >= -farthest && high[k] + shift[k] <= farthest;
    if (fits) shifts.push_back(shift);
  }
  return shifts;
}

std::vector<Balls> axis_images(const Balls &balls) {
  return {along_axes(balls, {1, 2, 0}), along_axes(balls, {2, 0, 1}), along_axes(balls, {1, 0, 2}),
          along_axes(balls, {0, 2, 1}), along_axes(balls, {2, 1, 0}), along_axes(balls, {0, 1, 2}, 1)};
}

int64_t largest_scale(const Balls &balls) {
  int64_t radius = 1;
  int64_t coordinate = 1;
  for (const LatticeBall &b : balls) {
    radius = std::max(radius, b.radius);
    coordinate = std::max({coordinate, std::abs(b.x), std::abs(b.y), std::abs(b.z)});
  }
  return std::max<int64_t>(1, std::min(largest_radius / radius, farthest / coordinate));
}

Balls scaled(const Balls &balls, int64_t factor) {
  Balls result;
  for (const LatticeBall &b : balls) result.push_back({b.x * factor, b.y * factor, b.z * factor, b.radius * factor});
  return result;
}

std::vector<Balls> one_step_off(const Balls &balls) {
  std::vector<Balls> sets;
  for (size_t i = 0; i < balls.size(); ++i)
    for (int64_t LatticeBall::*number : {&LatticeBall::x, &LatticeBall::y, &LatticeBall::z, &LatticeBall::radius})
      for (const int64_t step : {-1, 1}) {
        Balls set = balls;
        set[i].*number += step;
        const LatticeBall &ball = set[i];
        if (ball.radius >= 0 && ball.radius <= largest_radius &&
            std::max({std::abs(ball.x), std::abs(ball.y), std::abs(ball.z)}) <= farthest)
          sets.push_back(set);
      }
  return sets;
}

Balls with_copies(const Balls &balls) {
  Balls set = balls;
  set.insert(set.end(), balls.begin(), balls.end());
  return set;
}

Balls as_models(const Balls &balls, size_t models, int64_t most, RandomSource &random) {
  Balls set;
  for (size_t model = 0; model < models; ++model)
    for (LatticeBall ball : balls) {
      for (int64_t *const own : {&ball.x, &ball.y, &ball.z}) *own += random.in(-most, most);
      set.push_back(ball);
    }
  return set;
}

Balls with_half_sizes(const Balls &balls) {
  Balls set = balls;
  for (const LatticeBall &b : balls) set.push_back({b.x, b.y, b.z, b.radius / 2});
  return set;
}

Balls with_tangents(const Balls &balls) {
  Balls set = balls;
  for (const LatticeBall &b : balls) {
    const int64_t away = b.radius - b.radius / 2;
    set.push_back({b.x, b.y + away > farthest ? b.y - away : b.y + away, b.z, b.radius / 2});
  }
  return set;
}

}  // namespace oracle
