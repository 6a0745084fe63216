// Finds the first ball on a ray, and the point where the ray enters it.
//
// As an example the ray from 0 along x, and balls of radius 5:
//   centre          along   beside^2   half chord     enters at
//   (13, 3, 0)        13        9      sqrt(25 - 9)      9
//   (14, 0, 0)        14        0            5           9      a tie: the ball with the lower caller's index wins
//   (12, 5, 0)        12       25            0          12      the ray touches it
//   (11, 6, 0)        11       36            -           -      passes beside it
// A ball has an interval from `low` to `high` that certainly contains its entry. It certainly comes before the first
// ball so far if its interval ends before that ball's begins. The tie above is left to integers, which compare both
// entries as roots of quadratic equations.
#include "model/ray_query.hpp"

#include <bit>
#include <limits>

#include "core/decimal.hpp"
#include "core/extremes.hpp"
#include "model/query_hits.hpp"

namespace hsp {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Rounds a direction so that its largest component has 53 bits. False if all components are 0.
bool round_direction(const double *given, exact::Vector &direction) {
  double component[3] = {given[0], given[1], given[2]};
  double largest = larger_of(std::fabs(given[0]), larger_of(std::fabs(given[1]), std::fabs(given[2])));
  if (largest == 0.0) return false;
  if (largest < 0x1p-900) {  // so that there are no subnormal numbers
    for (double &c : component) c *= 0x1p200;
    largest *= 0x1p200;
  }
  const uint64_t exponent = std::bit_cast<uint64_t>(largest) >> 52;  // with an offset of 1023
  const double factor = std::bit_cast<double>((2 * UINT64_C(1023) + 52 - exponent) << 52);
  direction = {nearest(component[0] * factor), nearest(component[1] * factor), nearest(component[2] * factor)};
  return true;
}

// The first of the balls that have been looked at. Doubles decide if they are certain: the unit vector has a relative
// error below 5 units of 2^-53 in each component, so that the distance of a centre from the line, and its position
// along the line, have absolute errors below 13 units times its distance from the origin.
class FirstHit {
 public:
  FirstHit(const BallSet &balls, const exact::LatticeRay &ray)
      : balls_(balls), ray_(ray), origin_(exact::to_double(ray.origin)) {
    const Vec3 d = exact::to_double(ray.direction);
    unit_ = (1.0 / std::sqrt(dot(d, d))) * d;
  }

  void visit(const BallRange &range) {
    for (uint32_t j = range.first; j < range.last; ++j) look_at(j);
  }
  const Vec3 &unit() const { return unit_; }
  // No ball that is entered farther away than this is the first one.
  double farthest() const { return high_; }
  RayHit hit() const {
    if (ball_ == no_id) return {no_id, infinity, {}};
    if (inside_) return {ball_, 0.0, origin_};
    const Vec3 d = exact::to_double(ray_.direction);
    const double t = exact::RayCut(ray_, balls_.ball(ball_)).entry();
    return {ball_, t * std::sqrt(exact::squared_length(ray_.direction).to_double()), combine(1.0, origin_, t, d)};
  }

 private:
  void look_at(uint32_t j) {
    const Vec3 u{balls_.x[j] - origin_.x, balls_.y[j] - origin_.y, balls_.z[j] - origin_.z};  // exact
    const double r = balls_.r[j];
    const double doubt = 0x1p-48 * (std::fabs(u.x) + std::fabs(u.y) + std::fabs(u.z) + r);
    const double along = dot(u, unit_);
    const double reach = r + doubt;
    if (along < -reach || along - reach > high_) return;
    const Vec3 across = cross(u, unit_);
    const double beside = dot(across, across);
    if (beside > reach * reach) return;
    if (meet(u.x, u.y, u.z, r)) {
      if (!inside_ || balls_.given_before(j, ball_)) take(j, 0.0, 0.0);
      inside_ = true;
      return;
    }
    if (inside_) return;
    // The square of half the chord.
    const double squared = r * r - beside;
    const double error = 2.0 * reach * doubt;
    const double low = along - doubt - std::sqrt(larger_of(squared + error, 0.0));
    const double high = along + doubt - std::sqrt(larger_of(squared - error, 0.0));
    if (low > high_) return;
    const bool certain = squared > error && along > doubt;
    if (certain && high < low_) return take(j, low, high);
    const exact::RayCut cut(ray_, balls_.ball(j));
    if (cut.meets() && is_before_first(j, cut)) take(j, low, high);
  }

  bool is_before_first(uint32_t j, const exact::RayCut &cut) const {
    if (ball_ == no_id) return true;
    const int order = exact::compare_entries(cut, exact::RayCut(ray_, balls_.ball(ball_)));
    return order < 0 || (order == 0 && balls_.given_before(j, ball_));
  }

  void take(uint32_t j, double low, double high) {
    ball_ = j;
    low_ = low;
    high_ = high;
  }

  const BallSet &balls_;
  const exact::LatticeRay &ray_;
  Vec3 origin_;
  Vec3 unit_;
  uint32_t ball_ = no_id;
  double low_ = infinity, high_ = infinity;  // the ray enters the ball between these distances
  bool inside_ = false;                      // whether the origin lies in the ball
};

// The cubes that hold balls that a ray may meet. The ray's progress is measured along its longest axis, in steps, so
// that along the other axes it moves by no more than its progress.
class CubesAlongRay {
 public:
  CubesAlongRay(const CubeGrid &grid, const exact::LatticeRay &ray)
      : grid_(grid),
        low_{in_array(grid.cube_list().low())},
        high_{in_array(grid.cube_list().high())},
        side_(static_cast<double>(grid.side())) {
    const int64_t start[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const int64_t direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    double most = 0.0, largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      origin_[axis] = static_cast<double>(start[axis]);
      most = larger_of(most, std::fabs(origin_[axis]));
      most = larger_of(most, larger_of(std::fabs(wall(low_.at[axis])), std::fabs(wall(high_.at[axis] + 1))));
      const double size = std::fabs(static_cast<double>(direction[axis]));
      if (size <= largest) continue;
      largest = size;
      longest_ = axis;
    }
    for (int axis = 0; axis < 3; ++axis) slope_[axis] = static_cast<double>(direction[axis]) / largest;
    margin_ = 1.0 + 0x1p-48 * most;
    reach_ = static_cast<double>(grid.balls().largest_radius) + margin_;
  }

  void look(FirstHit &hit) const {
    Part part{0.0, infinity};
    if (!clip(part)) return;
    const bool up = slope_[longest_] > 0.0;
    const int64_t bottom = layer_at(up ? part.from : part.to, -reach_);
    const int64_t top = layer_at(up ? part.to : part.from, reach_);
    if (top - bottom >= static_cast<int64_t>(grid_.cubes())) return hit.visit({0, grid_.balls().n});
    const double cosine = std::fabs(longest_ == 0 ? hit.unit().x : longest_ == 1 ? hit.unit().y : hit.unit().z);
    for (int64_t step = 0; step <= top - bottom; ++step) {
      const int64_t layer = up ? bottom + step : top - step;
      const double from =
          (up ? wall(layer) - origin_[longest_] : origin_[longest_] - wall(layer + 1)) - reach_;  // and no earlier
      if (hit.farthest() * cosine < from) return;
      visit_layer(layer, {larger_of(from, part.from), smaller_of(from + side_ + 2 * reach_, part.to)}, hit);
    }
  }

 private:
  struct Part {
    double from, to;  // a part of the ray, by its progress
  };
  struct Coordinates {
    int64_t at[3];
  };
  static Coordinates in_array(const CubeCoordinates &cube) { return {{cube.x, cube.y, cube.z}}; }

  double wall(int64_t cube) const { return static_cast<double>(cube) * side_; }
  double position(int axis, double progress) const { return origin_[axis] + slope_[axis] * progress; }
  int64_t layer_at(double progress, double beside) const {
    const int64_t at = nearest(position(longest_, progress) + beside);
    return smaller_of(larger_of(grid_.cube_at({at, at, at}).x, low_.at[longest_]), high_.at[longest_]);
  }

  // Clips a part to where it is within reach of the box around all cubes; false if nothing is left.
  bool clip(Part &part) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double low = wall(low_.at[axis]) - reach_ - origin_[axis];
      const double high = wall(high_.at[axis] + 1) + reach_ - origin_[axis];
      if (slope_[axis] == 0.0) {
        if (low > 0.0 || high < 0.0) return false;
        continue;
      }
      const bool up = slope_[axis] > 0.0;
      part.from = larger_of(part.from, (up ? low : high) / slope_[axis] - margin_);
      part.to = smaller_of(part.to, (up ? high : low) / slope_[axis] + margin_);
    }
    return part.from <= part.to;
  }

  // The balls of a layer that a part of the ray may meet.
  void visit_layer(int64_t layer, const Part &part, FirstHit &hit) const {
    if (part.from > part.to) return;
    int64_t low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double a = position(axis, part.from), b = position(axis, part.to);
      low[axis] = nearest(smaller_of(a, b) - reach_);
      high[axis] = nearest(larger_of(a, b) + reach_);
    }
    Coordinates first = in_array(grid_.cube_at({low[0], low[1], low[2]}));
    Coordinates last = in_array(grid_.cube_at({high[0], high[1], high[2]}));
    for (int axis = 0; axis < 3; ++axis) {
      first.at[axis] = larger_of(axis == longest_ ? layer : first.at[axis], low_.at[axis]);
      last.at[axis] = smaller_of(axis == longest_ ? layer : last.at[axis], high_.at[axis]);
      if (first.at[axis] > last.at[axis]) return;
    }
    for (int64_t z = first.at[2]; z <= last.at[2]; ++z) {
      for (int64_t y = first.at[1]; y <= last.at[1]; ++y) hit.visit(balls_in_row(first.at[0], last.at[0], y, z));
    }
  }

  BallRange balls_in_row(int64_t x_low, int64_t x_high, int64_t y, int64_t z) const {
    if (!grid_.rows().is_there()) return grid_.balls_in_row(x_low, x_high, y, z);
    BallRange row{0, 0};
    return grid_.rows().find({x_low, y, z}, {x_high, y, z}, {&row, 1}) == 0 ? BallRange{0, 0} : row;
  }

  const CubeGrid &grid_;
  Coordinates low_, high_;  // of the box around all cubes
  double side_;
  double origin_[3];
  double slope_[3];  // movement along each axis for each step of progress
  int longest_ = 0;
  double margin_;  // more than all roundings of positions
  double reach_;   // the largest radius plus the margin
};

}  // namespace

Status round_ray(const BallSet &balls, const double *origin, const double *direction, exact::LatticeRay &ray) {
  const bool rounded = balls.lattice.round(origin, ray.origin);
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_finite(origin[axis]) || !is_finite(direction[axis])) return Status::not_finite;
  }
  return rounded && round_direction(direction, ray.direction) ? Status::ok : Status::range;
}

RayHit first_ball_on_ray(const CubeGrid &grid, const exact::LatticeRay &ray) {
  FirstHit hit(grid.balls(), ray);
  if (grid.cubes() > 0) CubesAlongRay(grid, ray).look(hit);
  return hit.hit();
}

}  // namespace hsp
