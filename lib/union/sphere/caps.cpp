// The caps of one ball, gathered from the balls around it.
//
// As an example the ball of radius 5 at 0 and other balls. With d the distance of the centres and R the other radius
// the cap is u.x >= b on the unit sphere, b = (d^2 + 25 - R^2) / (2 * 5 d):
//   R = 5 at (6,0,0)      36 / 60 =  0.6      a cap: the part x >= 3 of the sphere
//   R = 1 at (3,0,0)      33 / 30 =  1.1      above 1: the other ball is inside this one, and has no cap
//   R = 10 at (3,0,0)    -66 / 30 = -2.2      below -1: this ball is contained in the other one
//   R = 4 at (9,0,0)      90 / 90 =  1        they touch, as integers say; the perturbation makes it a circle
//   R = 1 at (9,0,0)     105 / 90 =  1.2      too far away
#include "sphere/caps.hpp"

#include "core/first_index.hpp"
#include "core/small_code.hpp"
#include "model/meeting.hpp"

namespace hsp {

bool lies_inside(const BallSet &balls, uint32_t inner, uint32_t outer) {
  if constexpr (!small_code) {
    const Vec3 v = balls.difference(inner, outer);
    const double difference = balls.r[outer] - balls.r[inner];
    if (dot(v, v) > difference * difference * certainly_above) return false;
  }
  return inner != outer &&
         exact::pair_relation(balls.ball(inner), balls.ball(outer)) == exact::PairRelation::first_in_second;
}

void Caps::carve(Workspace &workspace, uint32_t capacity) {
  const uint64_t padded = static_cast<uint64_t>(capacity) + 1 + padding;
  ux = workspace.take<double>(padded);
  uy = workspace.take<double>(padded);
  uz = workspace.take<double>(padded);
  b = workspace.take<double>(padded);
  ball = workspace.take<uint32_t>(padded);
  lanes = has_lanes;
  target = workspace.target();
}

// Joins the neighbours of ball i to its component of the union. Most neighbours have its root as their parent already.
class Caps::Joining {
 public:
  Joining(uint32_t i, DisjointSets *components)
      : components_(components), i_(i), root_(components != nullptr ? components->find(i) : i) {}

  void join(uint32_t j) {
    if (components_ == nullptr || components_->has_parent(j, root_)) return;
    components_->join(i_, j);
    root_ = components_->find(i_);
  }
  void join_all(const uint32_t *balls, uint32_t first, uint32_t last) {
    if (components_ == nullptr) return;
    while ((first = components_->first_elsewhere(balls, first, last, root_)) < last) join(balls[first++]);
  }

 private:
  DisjointSets *components_;
  uint32_t i_, root_;
};

void Caps::start(const BallSet &balls, uint32_t i) {
  balls_ = &balls;
  origin = i;
  sphere = exact::sphere_of(balls.ball(i));
  length_squared = static_cast<double>(sphere.W);
  count = 0;
  first_later = 0;
  met = 0;
  contained = false;
}

// The distance of ball j: v, the difference of the centres, and `sum`, that of the radii, are exact; `squared` is
// rounded.
struct Caps::Distance {
  Vec3 v;
  double sum, squared;

  Distance(const Vec3 &difference, double radii) : v(difference), sum(radii), squared(dot(v, v)) {}
  Distance(const BallSet &balls, uint32_t i, uint32_t j) : Distance(balls.difference(i, j), balls.r[j] + balls.r[i]) {}
};

// Adds the cap of ball j, which is not certainly disjoint from the origin ball. Returns false if ball j contains the
// origin ball.
[[gnu::always_inline]] inline bool Caps::take(const exact::LatticeBall &own, uint32_t j, const Distance &distance,
                                              Joining &joining) {
  const BallSet &balls = *balls_;
  const uint32_t i = origin;
  if (j == i) return true;
  const exact::LatticeBall other = balls.ball(j);
  const auto &[v, s, squared] = distance;
  // A certainly proper circle needs no integers.
  const double difference = balls.r[j] - balls.r[i];
  const bool certainly_circle =
      squared < s * s * certainly_below && squared > difference * difference * certainly_above;
  const exact::PairRelation relation =
      certainly_circle ? exact::PairRelation::circle : exact::pair_relation(own, other);
  if (relation == exact::PairRelation::disjoint) return true;
  // Of two balls that meet, one is earlier in the grid's order.
  if (j > i || relation == exact::PairRelation::first_in_second) joining.join(j);
  if (relation == exact::PairRelation::first_in_second) {
    contained = true;
    count = 0;
    return false;
  }
  ++met;
  if (relation == exact::PairRelation::second_in_first || overflowed()) return true;
  const exact::Plane cap = exact::plane_of(own, other);
  const double U = static_cast<double>(dot(cap.v, cap.v));
  const double inverse = 1.0 / std::sqrt(U);
  if (U > length_squared) length_squared = U;
  if (j < i) first_later = count + 1;
  ball[count] = j;
  ux[count] = v.x * inverse;
  uy[count] = v.y * inverse;
  uz[count] = v.z * inverse;
  b[count] = static_cast<double>(cap.h) * inverse * (0.5 / balls.r[i]);
  ++count;
  return true;
}

void Caps::gather(const BallSet &balls, const CubeBlock &block, uint32_t i, DisjointSets *components) {
  start(balls, i);
  Joining joining(i, components);
  if (!small_code && block.levels != nullptr && block.ranges > 0) {
    uint32_t found = block.levels->find_neighbours(balls, i, ball.data(), capacity());
    if (found <= capacity()) {
      // If the block begins behind the first neighbours, leaves these out.
      uint32_t others = 0;
      while (others < found && ball[others] < block.range[0].first) ++others;
      for (uint32_t k = others; k < found; ++k) ball[k - others] = ball[k];
      return take_given<true>(found - others, joining);
    }
  }
  if constexpr (has_lanes) {
    if (lanes) return gather_in_lanes(block, joining);
  }
  const exact::LatticeBall own = balls.ball(i);
  const double x = balls.x[i];
  const double y = balls.y[i];
  const double z = balls.z[i];
  const double radius = balls.r[i];
  const double *const xs = balls.x.data();
  const double *const ys = balls.y.data();
  const double *const zs = balls.z.data();
  const double *const rs = balls.r.data();
  for (uint32_t k = 0; k < block.ranges; ++k) {
    const BallRange range = block.range[k];
    for (uint32_t j = range.first; j < range.last; ++j) {
      const Vec3 v{xs[j] - x, ys[j] - y, zs[j] - z};
      const Distance distance(v, rs[j] + radius);
      // A certainly disjoint pair stops here.
      if (distance.squared > distance.sum * distance.sum * certainly_above) continue;
      if (!take(own, j, distance, joining)) return;
    }
  }
}

void Caps::gather_given(const BallSet &balls, uint32_t i, uint32_t n) {
  start(balls, i);
  Joining joining(i, nullptr);
  take_given<false>(n, joining);
}

// Takes balls one by one. Out of line, as few balls are left for it.
[[gnu::noinline]] bool Caps::take_each(const uint32_t *near, uint32_t n, Joining &joining) {
  const exact::LatticeBall own = balls_->ball(origin);
  for (uint32_t k = 0; k < n; ++k) {
    if (!take(own, near[k], {*balls_, origin, near[k]}, joining)) return false;
  }
  return true;
}

// Reads the balls from `ball` while it writes caps there: no cap is written behind the place of its ball.
template <bool ranked>
void Caps::take_given(uint32_t n, Joining &joining) {
  if constexpr (has_lanes) {
    if (lanes) {
      take_all<ranked>(ball.data(), n, joining);
      return;
    }
  }
  take_each(ball.data(), n, joining);
}

void Caps::put_selected_first(const uint32_t *selected) {
  first_later = hsp::put_selected_first(first_later, selected, ball, ux, uy, uz, b);
}

void Caps::take_circles(const BallSet &balls, uint32_t i, uint32_t n, uint32_t n_earlier, DisjointSets *components) {
  start(balls, i);
  count = met = n;
  first_later = n_earlier;
  forget(ux), forget(uy), forget(uz), forget(b);
  Joining joining(i, components);
  joining.join_all(ball.data(), first_later, count);
}

void Caps::make_doubles() {
  const uint32_t n = count, later = first_later;
  count = met = 0;
  Joining joining(origin, nullptr);
  take_given<false>(n, joining);
  first_later = later;
}

uint32_t Caps::make_doubles_of(Span<const uint32_t> numbers, const CapArrays &to) const {
  if constexpr (has_lanes) {
    uint32_t near[most_at_once + spare_ids], taken[most_at_once + spare_ids];
    const uint32_t n = numbers.size();
    for (uint32_t k = 0; k < n; ++k) near[k] = ball[numbers[k]];
    for (uint32_t k = n; k < n + 4; ++k) near[k] = origin;
    double longest = 0.0;
    return caps_of_circles(target, arrays_of(*balls_), origin, near, n, {to.ux, to.uy, to.uz, to.b, taken}, longest);
  }
  return 0;
}

// The same as gather(), some balls at a time.
void Caps::gather_in_lanes(const CubeBlock &block, Joining &joining) {
  if constexpr (has_lanes) {
    constexpr uint32_t room = 128;
    uint32_t near[room + spare_ids];
    const BallArrays arrays = arrays_of(*balls_);
    uint32_t found = 0;
    for (uint32_t k = 0; k < block.ranges; ++k) {
      for (uint32_t j = block.range[k].first; j < block.range[k].last;) {
        found += near_balls(target, arrays, origin, j, block.range[k].last, near + found, room - found);
        if (j == block.range[k].last) break;
        if (!take_near(Span<uint32_t>(near, found), joining)) return;
        found = 0;
      }
    }
    take_near(Span<uint32_t>(near, found), joining);
  }
}

bool Caps::take_near(Span<uint32_t> near, Joining &joining) {
  // Without the ball itself.
  uint32_t hits = 0;
  for (const uint32_t j : near) {
    near[hits] = j;
    hits += j != origin ? 1U : 0U;
  }
  return take_all<true>(near.data(), hits, joining);
}

// May read and write four ids past the end of `near`. `ranked`: the balls are in grid order; else first_later means
// nothing, and balls are joined to nothing.
template <bool ranked>
bool Caps::take_all(uint32_t *near, uint32_t hits, Joining &joining) {
  const BallArrays arrays = arrays_of(*balls_);
  for (uint32_t k = 0; k < 4; ++k) near[hits + k] = origin;
  for (uint32_t k = 0; k < hits;) {
    // Where there is no room any more, balls are counted and the caps are lost.
    if (overflowed()) count = 0;
    if ((overflowed() ? 0 : met) + (hits - k) <= capacity()) {
      const uint32_t c = count;
      const CapArrays to{&ux[c], &uy[c], &uz[c], &b[c], &ball[c]};
      uint32_t circles = 0;
      if constexpr (has_lanes) {
        circles = caps_of_circles(target, arrays, origin, near + k, hits - k, to, length_squared);
      }
      if (ranked && circles > 0) {
        const uint32_t later = first_index(0, circles, [&](uint32_t n) { return to.ball[n] > origin; });
        if (later > 0) first_later = c + later;
        joining.join_all(to.ball, later, circles);
      }
      k += circles;
      count += circles;
      met += circles;
    }
    const uint32_t rest = hits - k < 4 ? hits - k : 4;
    if (rest > 0 && !take_each(near + k, rest, joining)) return false;
    k += rest;
  }
  return true;
}

exact::Vector Caps::direction(uint32_t k) const {
  if (ball[k] == no_id) return half_sphere_.v;
  return balls_->ball(ball[k]).centre - balls_->ball(origin).centre;
}

exact::Plane Caps::plane(uint32_t k) const {
  if (ball[k] == no_id) return half_sphere_;
  return plane_of_ball(ball[k]);
}

exact::Plane Caps::plane_of_ball(uint32_t other) const {
  return exact::plane_of(balls_->ball(origin), balls_->ball(other));
}

void Caps::set_spare_great_circle(const exact::Vector &normal) {
  const double inverse = 1.0 / std::sqrt(static_cast<double>(dot(normal, normal)));
  ux[count] = static_cast<double>(normal.x) * inverse;
  uy[count] = static_cast<double>(normal.y) * inverse;
  uz[count] = static_cast<double>(normal.z) * inverse;
  b[count] = 0.0;
}

void Caps::add_half_sphere(const exact::Vector &normal) {
  set_spare_great_circle(normal);
  half_sphere_ = exact::virtual_plane(normal, 0);
  half_sphere_.index = no_id;
  ball[count] = no_id;
  const double U = static_cast<double>(dot(normal, normal));
  if (U > length_squared) length_squared = U;
  ++count;
}

uint32_t Caps::cap_of(uint32_t other) const {
  return first_index(1, count, [this, other](uint32_t k) { return ball[k] > other; }) - 1;
}

}  // namespace hsp
