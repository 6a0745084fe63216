#include "maps/disc_grid.hpp"

#include "core/decimal.hpp"
#include "core/rows.hpp"
#include "core/sorting.hpp"

namespace hsp {

uint32_t DiscGrid::level_of(double r) const {
  uint32_t level = 0;
  for (double most = largest_ / 4; r <= most && level + 1 < most_levels; most /= 4) ++level;
  return level;
}

CubeCoordinates DiscGrid::square_at(double x, double y, uint32_t level) const {
  const double per_length = level_[level].per_length;
  return {floor_of(x * per_length), floor_of(y * per_length), level};
}

// Calls visit(range of items) for the squares that hold centres at most reach_to(the largest radius of their level)
// away in either coordinate.
template <class Reach, class Visit>
void DiscGrid::visit_squares(double x, double y, Reach reach_to, Visit visit) const {
  for (uint32_t level = 0; level < levels_; ++level) {
    if (!level_[level].any) continue;
    const double reach = reach_to(level_[level].largest);
    const CubeCoordinates low = square_at(x - reach, y - reach, level);
    const CubeCoordinates high = square_at(x + reach, y + reach, level);
    const auto visit_one = [&](uint32_t square) { visit(item_.part(first_[square], first_[square + 1])); };
    // Around a large disc there may be more squares than have centres.
    if (static_cast<double>(high.x - low.x) * static_cast<double>(high.y - low.y) > squares_.count()) {
      for (uint32_t square = 0; square < squares_.count(); ++square) {
        const CubeCoordinates &at = squares_.coordinates(square);
        if (at.z == level && low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y) visit_one(square);
      }
      continue;
    }
    for (int64_t row = low.y; row <= high.y; ++row) {
      for (int64_t column = low.x; column <= high.x; ++column) {
        const uint32_t square = squares_.find({column, row, level});
        if (square != no_id) visit_one(square);
      }
    }
  }
}

void DiscGrid::carve(Workspace &workspace, uint32_t balls) {
  squares_ = CubeTable(workspace.take<uint32_t>(CubeSlots::slots_for(balls)), workspace.take<CubeCoordinates>(balls));
  first_ = workspace.take<uint32_t>(static_cast<uint64_t>(balls) + 1);
  item_ = workspace.take<uint32_t>(balls);
}

// The balls of a square keep their order.
void DiscGrid::build(Span<const SeenBall> balls) {
  balls_ = balls;
  largest_ = 0.0;
  for (const SeenBall &ball : balls) largest_ = ball.r > largest_ ? ball.r : largest_;
  levels_ = 0;
  for (Level &level : level_) level = {};
  for (const SeenBall &ball : balls) {
    const uint32_t of = level_of(ball.r);
    Level &level = level_[of];
    level.any = true;
    level.largest = ball.r > level.largest ? ball.r : level.largest;
    levels_ = of < levels_ ? levels_ : of + 1;
  }
  for (Level &level : level_) level.per_length = level.largest > 0.0 ? 1.0 / (2 * level.largest) : 1.0;
  const auto square_of = [this](const SeenBall &ball) { return square_at(ball.x, ball.y, level_of(ball.r)); };
  squares_.clear(balls.size());
  for (const SeenBall &ball : balls) {
    const CubeCoordinates square = square_of(ball);
    if (squares_.find(square) == no_id) squares_.append(square);
  }
  sort_to_rows(
      first_, squares_.count(), balls.size(), [&](uint32_t i) { return squares_.find(square_of(balls[i])); },
      [this](uint32_t at, uint32_t i) { item_[at] = i; });
}

// A ball that contains another one reaches at least as high, up to rounding, and of two with equal tops the larger one
// comes first: so only balls before i can contain it.
void DiscGrid::mark_inside(Span<SeenBall> balls, Patience &patience) const {
  for (uint32_t i = 0; i < balls.size() && patience.allows(1000); ++i) {
    SeenBall &ball = balls[i];
    const double highest_inside = ball.top() + touching * ball.r;
    const auto reach_to = [&](double largest) { return largest > ball.r ? largest : ball.r; };
    visit_squares(ball.x, ball.y, reach_to, [&](Span<const uint32_t> items) {
      for (const uint32_t k : items) {
        if (k >= i) break;
        SeenBall &higher = balls[k];
        if (higher.r >= ball.r) {
          if (is_inside(ball, higher)) ball.inside = 1;
        } else if (higher.top() <= highest_inside && is_inside(higher, ball)) {
          higher.inside = 1;
        }
      }
    });
  }
}

void DiscGrid::gather(uint32_t i, FixedVector<uint32_t> &near) const {
  const SeenBall &own = balls_[i];
  near.clear();
  const auto reach_to = [&](double largest) { return own.r + largest; };
  visit_squares(own.x, own.y, reach_to, [&](Span<const uint32_t> items) {
    for (const uint32_t k : items) {
      const SeenBall &other = balls_[k];
      if (other.top() <= own.z) break;
      const double dx = other.x - own.x;
      const double dy = other.y - own.y;
      const double sum = other.r + own.r;
      if (dx * dx + dy * dy < sum * sum && k != i && other.inside == 0) near.push(k);
    }
  });
  sort_ascending(near.items());
}

HighestBody DiscGrid::highest_at(double x, double y, uint32_t except) const {
  constexpr double close = 0x1p-24;    // of the radius
  constexpr double farthest = 0x1p52;  // farther out than any disc, and still within integers
  if (std::fabs(x) > farthest || std::fabs(y) > farthest) return {no_id, true};
  uint32_t best = no_id;
  double highest = 0.0;
  double runner_up = 0.0;     // the second highest front, if there are two
  double highest_edge = 0.0;  // the highest of the discs whose edge is close to the point
  uint32_t fronts = 0, edges = 0;
  const auto reach_to = [](double largest) { return largest; };
  visit_squares(x, y, reach_to, [&](Span<const uint32_t> items) {
    for (const uint32_t k : items) {
      const SeenBall &ball = balls_[k];
      if (fronts > 1 && ball.top() < runner_up) break;
      if (k == except || ball.inside != 0) continue;
      const double squared = ball.squared_height(x, y);
      if (std::fabs(squared) <= close * ball.r * ball.r && (edges++ == 0 || ball.z > highest_edge)) {
        highest_edge = ball.z;
      }
      if (squared <= 0.0) continue;
      const double height = ball.z + std::sqrt(squared);
      ++fronts;
      if (best == no_id || height > highest || (height == highest && k < best)) {
        runner_up = best == no_id ? height : highest;
        best = k;
        highest = height;
      } else if (fronts == 2 || height > runner_up) {
        runner_up = height;
      }
    }
  });
  bool certain = fronts < 2 || highest - runner_up > close * balls_[best].r;
  // Near its edge a front is at most 2^-11 radii above the centre.
  if (edges > 0 && (best == no_id || highest_edge + 0x1p-11 * largest_ >= highest)) certain = false;
  return {best, certain};
}

}  // namespace hsp
