#include "model/vertical_ray.hpp"

#include "exact/exact_predicates.hpp"
#include "exact/vertical_order.hpp"

namespace hsp {
namespace {

// For two balls that a ray enters in one point: whether the point where it enters the second lies in the first. This
// point is p+ of two vertical planes, one of them through the second ball's centre. It is seldom asked; out of line, so
// that a search keeps its registers.
[[gnu::noinline]] bool is_entered_earlier(const BallSet &balls, int64_t ray_x, int64_t ray_y, uint32_t first,
                                          uint32_t second) {
  const exact::LatticeBall a = balls.ball(first), b = balls.ball(second);
  const exact::PairRelation relation = exact::pair_relation(a, b);
  if (relation != exact::PairRelation::circle) return relation == exact::PairRelation::second_in_first;
  const int64_t dx = ray_x - b.centre.x, dy = ray_y - b.centre.y;
  const int64_t squared = dx * dx + dy * dy;
  const exact::Vector across = squared > 0 ? exact::Vector{dx, dy, 0} : exact::Vector{1, 0, 0};
  return exact::Exact::point_status(exact::sphere_of(b), exact::virtual_plane({-across.y, across.x, 0}, 0),
                                    exact::virtual_plane(across, 2 * squared), exact::plane_of(b, a))
             .side[1] > 0;
}

class FirstEntry {
 public:
  FirstEntry(const BallSet &balls, const exact::Vector &start) : balls_(balls), start_(start) {}

  void visit(const BallRange &range) {
    for (uint32_t j = range.first; j < range.last; ++j) {
      exact::VerticalCut cut;
      const exact::LatticeBall ball = balls_.ball(j);
      // The start lies in no ball, so a ball with its centre not above it is not entered.
      if (ball.centre.z <= start_.z || !exact::cut_vertically(start_, ball, cut)) continue;
      if (ball_ != no_id) {
        const int order = exact::compare_entries(cut.below - cut_.below, cut.power, cut_.power);
        if (order > 0 || (order == 0 && !is_entered_earlier(balls_, start_.x, start_.y, j, ball_))) continue;
      }
      ball_ = j;
      cut_ = cut;
    }
  }
  uint32_t ball() const { return ball_; }
  // Whether a ball has been found, and none with its centre at this height or above can be entered earlier.
  bool is_settled(int64_t lowest_centre) const {
    return ball_ != no_id && lowest_centre - balls_.largest_radius - start_.z > cut_.below;
  }

 private:
  const BallSet &balls_;
  exact::Vector start_;
  uint32_t ball_ = no_id;
  exact::VerticalCut cut_{};
};

}  // namespace

uint32_t first_ball_above(const CubeGrid &grid, const exact::Vector &start, int64_t highest_centre) {
  const BallSet &balls = grid.balls();
  FirstEntry entry(balls, start);
  const int64_t reach = balls.largest_radius;
  const CubeCoordinates low = grid.cube_at({start.x - reach, start.y - reach, start.z});
  const CubeCoordinates high = grid.cube_at({start.x + reach, start.y + reach, highest_centre});
  if (high.z - low.z >= static_cast<int64_t>(grid.cubes())) {  // more layers than cubes
    entry.visit({0, balls.n});
    return entry.ball();
  }
  for (int64_t z = low.z; z <= high.z && !entry.is_settled(z * grid.side()); ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) entry.visit(grid.balls_in_row(low.x, high.x, y, z));
  }
  return entry.ball();
}

}  // namespace hsp
