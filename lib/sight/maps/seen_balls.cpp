#include "maps/seen_balls.hpp"

#include <initializer_list>

#include "core/sorting.hpp"

namespace hsp {
namespace {

// Sebastiano Vigna's mixing step of splitmix64.
uint64_t mixed(uint64_t h) {
  h = (h ^ (h >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  h = (h ^ (h >> 27)) * UINT64_C(0x94D049BB133111EB);
  return h ^ (h >> 31);
}

// A pseudo-random vector with components in [-1, 1): different for every centre, radius and way, equal for equal balls.
Vec3 direction_of_shift(const BallSet &balls, uint32_t i, uint32_t way) {
  uint64_t h = way;
  for (const double value : {balls.x[i], balls.y[i], balls.z[i], balls.r[i]}) {
    h = mixed(h + UINT64_C(0x9E3779B97F4A7C15) + static_cast<uint64_t>(static_cast<int64_t>(value)));
  }
  const auto next = [&h] {
    h = mixed(h + UINT64_C(0x9E3779B97F4A7C15));
    return static_cast<double>(h >> 11) * 0x1p-52 - 1.0;
  };
  const double x = next();
  const double y = next();
  return {x, y, next()};
}

}  // namespace

// Half of the size is enough: the vector is in a cube whose circumsphere has a radius of less than 2 half sides.
Vec3 moved_centre(const BallSet &balls, uint32_t i, const Vec3 &centre, const Perturbation &perturbation) {
  return combine(1.0, centre, perturbation.size / 2 * balls.r[i], direction_of_shift(balls, i, perturbation.way));
}

void SeenBalls::carve(Workspace &workspace, uint32_t balls, uint32_t neighbours) {
  hidden_.carve(workspace, balls);
  covered_.carve(workspace, neighbours);
  workspace.take_each(balls, visible_, creases_);
  balls_ = workspace.take<SeenBall>(balls);
  count_ = 0;
}

// A ball that is hidden as a whole can be left out: others hide all that it hides, and it cuts nothing that is seen.
bool SeenBalls::choose(const CubeGrid &grid, const ViewFrame &frame, Patience &patience) {
  const BallSet &balls = grid.balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    visible_[i] = balls.r[i] > 0.0 ? open : hidden;
    creases_[i] = 0;
  }
  covered_.start(grid);
  return hidden_.hide(grid, frame, visible_, patience);
}

bool SeenBalls::is_covered(uint32_t k, Patience &patience) {
  const uint32_t ball = balls_[k].ball;
  if (visible_[ball] == open) {
    visible_[ball] = patience.allows(20000) && covered_.contains(ball) ? hidden : uncovered;
    if (visible_[ball] == hidden) some_are_late_ = true;
  }
  return visible_[ball] == hidden;
}

void SeenBalls::ask_of_those_inside(Patience &patience) {
  for (uint32_t k = 0; k < count_; ++k) {
    if (balls_[k].inside != 0) static_cast<void>(is_covered(k, patience));
  }
}

bool SeenBalls::mark_creases(uint32_t k, Patience &patience) {
  if (moved_ || !patience.allows(20000)) return false;
  static_cast<void>(covered_.contains(balls_[k].ball));
  return covered_.visit_neighbours([this](uint32_t ball) { creases_[ball] = 1; });
}

void SeenBalls::unmark_creases() {
  static_cast<void>(covered_.visit_neighbours([this](uint32_t ball) { creases_[ball] = 0; }));
}

void SeenBalls::place(const BallSet &balls, const ViewFrame &frame, const Perturbation &perturbation,
                      Patience &patience) {
  moved_ = perturbation.size > 0.0;
  some_are_late_ = false;
  count_ = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (visible_[i] == hidden) continue;
    Vec3 centre = frame.centre_of(balls, i);
    if (moved_) centre = moved_centre(balls, i, centre, perturbation);
    balls_[count_++] = {centre.x, centre.y, centre.z, balls.r[i], i, 0};
  }
  const auto comes_first = [&balls](const SeenBall &a, const SeenBall &b) {
    if (a.top() != b.top()) return a.top() > b.top();
    if (a.r != b.r) return a.r > b.r;
    return balls.ranks_before(a.ball, b.ball);
  };
  const Span<SeenBall> seen = balls_.part(0, count_);
  if (!patience.may_end()) return sort_in_place(seen, comes_first);
  sort_in_place(seen, [&](const SeenBall &a, const SeenBall &b) { return patience.allows(40) && comes_first(a, b); });
}

}  // namespace hsp
