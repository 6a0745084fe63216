#include "maps/disc_grid.hpp"

#include "core/rows.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

int64_t floor_of(double x) {
  const int64_t truncated = static_cast<int64_t>(x);
  return static_cast<double>(truncated) > x ? truncated - 1 : truncated;
}

}  // namespace

CubeCoordinates DiscGrid::square_at(double x, double y) const {
  return {floor_of(x * per_length_), floor_of(y * per_length_), 0};
}

// Calls visit(range of items) for the squares that hold centres at most `reach` away in either coordinate.
template <class Visit>
void DiscGrid::visit_squares(double x, double y, double reach, Visit visit) const {
  const CubeCoordinates low = square_at(x - reach, y - reach);
  const CubeCoordinates high = square_at(x + reach, y + reach);
  for (int64_t row = low.y; row <= high.y; ++row) {
    for (int64_t column = low.x; column <= high.x; ++column) {
      const uint32_t square = squares_.find({column, row, 0});
      if (square != no_id) visit(item_.part(first_[square], first_[square + 1]));
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
  side_ = largest_ > 0.0 ? 2 * largest_ : 1.0;
  per_length_ = 1.0 / side_;
  squares_.clear(balls.size());
  for (const SeenBall &ball : balls) {
    const CubeCoordinates square = square_at(ball.x, ball.y);
    if (squares_.find(square) == no_id) squares_.append(square);
  }
  sort_to_rows(
      first_, squares_.count(), balls.size(),
      [&](uint32_t i) { return squares_.find(square_at(balls[i].x, balls[i].y)); },
      [this](uint32_t at, uint32_t i) { item_[at] = i; });
}

// A ball that contains another one reaches at least as high, up to rounding, and the larger one of two with equal tops
// comes first.
void DiscGrid::mark_inside(Span<SeenBall> balls, Patience &patience) const {
  for (uint32_t i = 0; i < balls.size() && patience.allows(1000); ++i) {
    SeenBall &ball = balls[i];
    const double highest_inside = ball.top() + touching * ball.r;
    visit_squares(ball.x, ball.y, largest_, [&](Span<const uint32_t> items) {
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
  visit_squares(own.x, own.y, own.r + largest_, [&](Span<const uint32_t> items) {
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

DiscGrid::Highest DiscGrid::highest_at(double x, double y, uint32_t except) const {
  constexpr double close = 0x1p-24;    // of the radius
  constexpr double farthest = 0x1p52;  // farther out than any disc, and still within integers
  if (std::fabs(x) > farthest || std::fabs(y) > farthest) return {no_id, true};
  uint32_t best = no_id;
  double highest = 0.0;
  double runner_up = 0.0;     // of two or more
  double highest_edge = 0.0;  // of discs with their edge close by
  uint32_t fronts = 0, edges = 0;
  visit_squares(x, y, largest_, [&](Span<const uint32_t> items) {
    for (const uint32_t k : items) {
      const SeenBall &ball = balls_[k];
      if (fronts > 1 && ball.top() < runner_up) break;
      if (k == except || ball.inside != 0) continue;
      const double dx = x - ball.x;
      const double dy = y - ball.y;
      const double squared = ball.r * ball.r - dx * dx - dy * dy;
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
