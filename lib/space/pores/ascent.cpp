#include "pores/ascent.hpp"

#include <initializer_list>

namespace hsp {
namespace {

constexpr uint32_t most_saddles = 64;
constexpr uint32_t most_tied = 16;
constexpr int most_turns = 64;

double length_of(const Vec3 &v) {
  return std::sqrt(dot(v, v));
}

// The point nearest to 0 that has been found in the convex hull of some points, and which of them span it.
struct Nearest {
  Vec3 point;
  double squared;
  uint32_t set;  // a bit for each point that spans it

  void take(const Vec3 &other, double other_squared, uint32_t other_set) {
    point = other;
    squared = other_squared;
    set = other_set;
  }
};

// Each of these functions finds the point of the affine hull of some points that is nearest to 0. It takes that point
// if it is nearer than the known one, unless it is outside their convex hull, or they are nearly dependent.
void try_edge(const Vec3 &a, const Vec3 &b, uint32_t set, Nearest &known) {
  const Vec3 u = b - a;
  const double length = dot(u, u), t = -dot(a, u);
  if (!(length > 1e-30) || t < 0.0 || t > length) return;
  const Vec3 foot = a + (t / length) * u;
  const double squared = dot(foot, foot);
  if (squared < known.squared) known.take(foot, squared, set);
}

void try_triangle(const Vec3 &a, const Vec3 &b, const Vec3 &c, uint32_t set, Nearest &known) {
  const Vec3 n = cross(b - a, c - a);
  const double area = dot(n, n);
  if (!(area > 1e-28)) return;
  const Vec3 foot = (dot(n, a) / area) * n;
  const double squared = dot(foot, foot);
  const auto is_beyond = [&](const Vec3 &from, const Vec3 &to) { return dot(cross(to - from, foot - from), n) < 0.0; };
  if (!(squared < known.squared) || is_beyond(a, b) || is_beyond(b, c) || is_beyond(c, a)) return;
  known.take(foot, squared, set);
}

void try_tetrahedron(const Vec3 *v, Nearest &known) {
  if (!(known.squared > 0.0)) return;
  // All four faces have 0 on the side of the fourth point.
  for (uint32_t k = 0; k < 4; ++k) {
    const Vec3 &a = v[k], &b = v[(k + 1) % 4], &c = v[(k + 2) % 4], &d = v[(k + 3) % 4];
    const Vec3 m = cross(b - a, c - a);
    const double own = dot(m, d - a), zero = -dot(m, a);
    if (!(std::fabs(own) > 1e-18) || zero * own < 0.0) return;
  }
  known.take({0.0, 0.0, 0.0}, 0.0, 15);
}

}  // namespace

// Among the sets without the new point only the set of all others can have the nearest point: each of them was needed.
Vec3 nearest_to_zero(Vec3 *points, uint32_t &count, const Vec3 &of_others) {
  const uint32_t last = count - 1, own = 1U << last;
  const Vec3 &added = points[last];
  Nearest known{of_others, dot(of_others, of_others), own - 1};
  const double squared = dot(added, added);
  if (squared < known.squared) known.take(added, squared, own);
  for (uint32_t j = 0; j < last; ++j) {
    try_edge(points[j], added, own | 1U << j, known);
    for (uint32_t i = 0; i < j; ++i) try_triangle(points[i], points[j], added, own | 1U << j | 1U << i, known);
  }
  if (last == 3) try_tetrahedron(points, known);
  uint32_t kept = 0;
  for (uint32_t k = 0; k < count; ++k) {
    if ((known.set >> k & 1U) != 0) points[kept++] = points[k];
  }
  count = kept;
  return known.point;
}

Ascent::Ascent(const BallsAround &around, const exact::Vector &start) : balls_(around), start_(start) {
  const BallSet &balls = around.set();
  // A reach within which there are some balls, and no more than there is room for, or nearly: doubled, then bisected.
  double low = 0.0, high = 0.0;
  double reach = static_cast<double>(balls.largest_radius) + 1.0;
  for (int turn = 0; balls.n > 0 && turn < 120; ++turn) {
    const uint32_t hits = around.find({start, static_cast<int64_t>(reach)}, nullptr, 0);
    if (hits > 0 && hits <= BallsAround::most) break;
    (hits > 0 ? high : low) = reach;
    if (high > 0.0 && high - low < 2.0) break;
    reach = high > 0.0 ? 0.5 * (low + high) : 2.0 * reach;
    if (!(reach < exact::query_radius_limit)) break;
  }
  level_ = balls.n > 0 ? reach : std::numeric_limits<double>::infinity();
  // If the start is in too many balls, or too many tie: the nearest one of all these, and those that are as near.
  if (!look(reach) && near_count_ == 0 && balls.n > 0 && count_crowd(0.0, reach) > 0) static_cast<void>(look(level_));
  delta_ = 0.25 * (std::fabs(level_) + static_cast<double>(balls.largest_radius)) + 16.0;
  move(0.0, at_);
}

Ascent::NearBall Ascent::seen(const NearImage &image) const {
  const exact::LatticeBall ball = balls_.ball(image);
  const Vec3 y{at_.x - static_cast<double>(ball.centre.x - start_.x),
               at_.y - static_cast<double>(ball.centre.y - start_.y),
               at_.z - static_cast<double>(ball.centre.z - start_.z)};
  const double length = length_of(y);
  return {length > 0.0 ? (1.0 / length) * y : Vec3{1.0, 0.0, 0.0}, length - static_cast<double>(ball.radius)};
}

// Finds f, and all balls within a distance `reach`. False if there are none, or too many.
bool Ascent::look(double reach) {
  NearImage found[BallsAround::most];
  const exact::Vector offset{nearest(at_.x), nearest(at_.y), nearest(at_.z)};
  const double radius = reach > 0.0 ? reach + 2.0 : 2.0;
  known_ = crowd_ = -1.0;
  if (!(radius < exact::query_radius_limit)) return false;
  const exact::Vector point{start_.x + offset.x, start_.y + offset.y, start_.z + offset.z};
  uint32_t hits = balls_.find({point, static_cast<int64_t>(radius)}, found, BallsAround::most);
  if (hits > BallsAround::most && reach < -2.0) hits = balls_.find_deep(point, reach + 2.0, found, BallsAround::most);
  if (hits == 0 || hits > BallsAround::most) return false;
  uint32_t nearest_one = 0;
  NearBall first = seen(found[0]);
  for (uint32_t k = 1; k < hits; ++k) {
    const NearBall other = seen(found[k]);
    if (!(other.gap < first.gap)) continue;
    nearest_one = k;
    first = other;
  }
  level_ = first.gap;
  nearest_ = found[nearest_one];
  near_count_ = 0;
  near_[near_count_++] = first;
  for (uint32_t k = 0; k < hits; ++k) {
    const NearBall other = seen(found[k]);
    if (k == nearest_one || other.gap > reach) continue;
    if (near_count_ == room && reach - level_ < 0x1p-8 * size()) room_ = room_of_ties;
    if (near_count_ == room_) return false;
    near_[near_count_++] = other;
  }
  known_ = reach - level_;
  return true;
}

// How many balls are within delta of the nearest one; they come first in near_, or are a crowd that near_ does not
// have. 0 if they are too many to be looked at.
uint32_t Ascent::within(double delta) {
  if (!(known_ >= delta) && !look(level_ + delta)) {
    return delta < 0x1p-8 * size() || delta <= 4.0 * tie_reach() ? count_crowd(delta, level_) : 0;
  }
  uint32_t count = 0;
  for (uint32_t k = 0; k < near_count_; ++k) {
    if (near_[k].gap > level_ + delta) continue;
    const NearBall other = near_[k];
    near_[k] = near_[count];
    near_[count++] = other;
  }
  return count;
}

// Calls sink(image, near ball) for all balls within some distance, however many.
template <class Sink>
void Ascent::visit_around(double reach, Sink sink) const {
  const exact::Vector point{start_.x + nearest(at_.x), start_.y + nearest(at_.y), start_.z + nearest(at_.z)};
  const double radius = reach > 0.0 ? reach + 2.0 : 2.0;
  if (!(radius < exact::query_radius_limit)) return;
  balls_.visit({point, static_cast<int64_t>(radius)}, [&](const NearImage &image) {
    const NearBall ball = seen(image);
    if (ball.gap <= reach) sink(image, ball);
  });
}

// Calls sink(near ball) for the balls that within() counted.
template <class Sink>
void Ascent::visit_near(uint32_t count, Sink sink) const {
  if (crowd_ >= 0.0) {
    return visit_around(level_ + crowd_, [&](const NearImage &, const NearBall &ball) { sink(ball); });
  }
  for (uint32_t k = 0; k < count; ++k) sink(near_[k]);
}

// Finds the nearest ball, and f, which is at most `highest`. Returns how many balls are within delta of the nearest
// one, however many they are.
uint32_t Ascent::count_crowd(double delta, double highest) {
  near_count_ = 0;
  // 2 more, as `highest` is rounded.
  visit_around(highest + 2.0, [&](const NearImage &image, const NearBall &ball) {
    if (near_count_ > 0 && !(ball.gap < near_[0].gap)) return;
    near_[0] = ball;
    near_count_ = 1;
    nearest_ = image;
  });
  if (near_count_ == 0) return 0;
  level_ = near_[0].gap;
  crowd_ = delta;
  uint32_t count = 0;
  visit_near(0, [&](const NearBall &) { ++count; });
  return count;
}

void Ascent::move(double length, const Vec3 &direction) {
  const double before = level_;
  at_ = at_ + length * direction;
  const auto beyond = [](double x, int64_t start, int64_t low, int64_t high) {
    return x > static_cast<double>(high - start) || x < static_cast<double>(low - start);
  };
  const auto &[low, high] = balls_.centres();
  outside_ = balls_.are_none() || (balls_.box() == nullptr &&
                                   (beyond(at_.x, start_.x, low.x, high.x) || beyond(at_.y, start_.y, low.y, high.y) ||
                                    beyond(at_.z, start_.z, low.z, high.z)));
  if (!(length > 0.0) || look(before + length + delta_) || look(before + length)) return;
  if (count_crowd(0.0, before + length) == 0) level_ = before;
}

// Nearly the point nearest to 0 of the convex hull of the directions of the first `count` balls.
Vec3 Ascent::lead_of(uint32_t count) const {
  Vec3 basis[4] = {near_[0].a};
  uint32_t spanning = 1;
  Vec3 d = basis[0];
  for (int turn = 0; turn < most_turns; ++turn) {
    Vec3 least = near_[0].a;
    double lowest = dot(least, d);
    visit_near(count, [&](const NearBall &ball) {
      const double along = dot(ball.a, d);
      if (!(along < lowest)) return;
      least = ball.a;
      lowest = along;
    });
    if (lowest >= 0.75 * dot(d, d) || spanning == 4) break;
    basis[spanning++] = least;
    d = nearest_to_zero(basis, spanning, d);
  }
  return d;
}

bool Ascent::step() {
  if (outside_ || ended_ || steps_ == most_steps) return false;
  if (++steps_ % stretch == 0 && level_is_known()) {
    ended_ = !(level_ > before_stretch_) && !(level_ > far);
    before_stretch_ = level_;
    if (ended_) return false;
  }
  const double shortest = least_delta();
  uint32_t led = 0;  // d is of so many
  Vec3 d{};
  for (; delta_ >= shortest; delta_ *= 0.5) {
    // As many balls as before are the same balls: the direction stays.
    const uint32_t count = within(delta_);
    if (count == 0) continue;
    if (count != led) d = lead_of(count);
    led = count;
    const double steepness = length_of(d);
    // The shorter the step, the flatter it may be, as it is beside a gate.
    if (steepness <= 0.1 * std::sqrt(delta_ / size())) continue;
    double lead = 1.0;
    visit_near(count, [&](const NearBall &ball) { lead = smaller_of(lead, dot(ball.a, d) / steepness); });
    if (!(lead > 0.0)) continue;
    const double length = delta_ / (1.0 + lead);
    delta_ = smaller_of(2.0 * delta_, 0.5 * size());
    move(length, (1.0 / steepness) * d);
    return true;
  }
  if (saddles_ == most_saddles) return false;
  ++saddles_;
  // A way stops beside the saddle. From there balls that it leaves at right angles may get nearer at first, by less
  // than 2^-11 of a step.
  return leave_saddle(1e-8) || leave_saddle(0.2 * std::sqrt(shortest / size()));
}

// The directions of some balls that tie. Of a crowd the next direction is always the one that is farthest from those
// before. So the chosen directions of a ring are all around it, and their plane is known well.
uint32_t Ascent::choose_tied(uint32_t count, Vec3 *a) const {
  const uint32_t tied = smaller_of(count, most_tied);
  for (uint32_t i = 0; i < tied; ++i) {
    a[i] = near_[crowd_ >= 0.0 ? 0 : i].a;
    if (crowd_ < 0.0 || i == 0) continue;
    double farthest = -1.0;
    visit_near(count, [&](const NearBall &ball) {
      double least = 4.0;
      for (uint32_t k = 0; k < i; ++k) least = smaller_of(least, dot(ball.a - a[k], ball.a - a[k]));
      if (!(least > farthest)) return;
      farthest = least;
      a[i] = ball.a;
    });
  }
  return tied;
}

// If no way up is steep, two of the nearest balls have opposite directions, or three have directions in one plane. At
// right angles to these a way leads up, from a gate to both sides, as far as other balls do not block it.
bool Ascent::leave_saddle(double slack) {
  Vec3 a[most_tied];
  const uint32_t tied = choose_tied(within(tie_reach()), a);
  const auto leave = [&](const Vec3 &n) {
    const double length = length_of(n);
    const auto leave_to = [&](const Vec3 &to) {
      bool open = true;
      for (uint32_t i = 0; i < tied && open; ++i) open = dot(a[i], to) > -slack;
      return open && leave_along(to, slack);
    };
    return length > 1e-6 && (leave_to((1.0 / length) * n) || leave_to((-1.0 / length) * n));
  };
  for (uint32_t i = 0; i < tied; ++i) {
    for (uint32_t j = i + 1; j < tied; ++j) {
      for (uint32_t k = j + 1; k < tied; ++k) {
        if (leave(cross(a[j] - a[i], a[k] - a[i]))) return true;
      }
    }
  }
  for (uint32_t i = 0; i < tied; ++i) {
    for (uint32_t j = i + 1; j < tied; ++j) {
      if (leave(cross(a[i], a[j]))) return true;
    }
    if (leave(cross(a[i], {1.0, 0.0, 0.0})) || leave(cross(a[i], {0.0, 1.0, 0.0}))) return true;
  }
  return false;
}

// Goes along n as far as no ball within reach gets nearer by more than the slack.
bool Ascent::leave_along(const Vec3 &n, double slack) {
  const auto is_open = [&](double delta) {
    const uint32_t count = within(delta);
    bool open = count > 0;
    visit_near(count, [&](const NearBall &ball) { open = open && dot(ball.a, n) > -slack; });
    return open;
  };
  if (!is_open(tie_reach())) return false;
  double delta = 4.0 * tie_reach();
  if (!is_open(delta)) return false;
  while (2.0 * delta < 0.1 * size() && is_open(2.0 * delta)) delta *= 2.0;
  delta_ = delta;
  move(delta, n);
  return true;
}

}  // namespace hsp
