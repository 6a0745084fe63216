#include "pores/pore_balls.hpp"

#include "core/first_index.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

bool is_inside(const exact::LatticeBall &inner, const exact::LatticeBall &outer) {
  const int64_t room = outer.radius - inner.radius;
  const int64_t x = inner.centre.x - outer.centre.x, y = inner.centre.y - outer.centre.y,
                z = inner.centre.z - outer.centre.z;
  if (x > room || y > room || z > room || -x > room || -y > room || -z > room) return false;
  const int64_t squared = x * x + y * y + z * z;
  if (squared == 0 && room == 0) return exact::ranks_before(outer, inner);
  return squared <= room * room;
}

}  // namespace

void PoreBalls::carve(Workspace &workspace, uint32_t balls, uint32_t near) {
  set_.carve(workspace, balls);
  grid_.carve(workspace, balls);
  callers_ = workspace.take<uint32_t>(balls);
  ball_of_ = workspace.take<uint32_t>(balls);
  shift_of_ = workspace.take<SmallShift>(balls);
  near_ = workspace.take<uint32_t>(near);
}

Status PoreBalls::take(const CubeGrid &grid, Patience &patience) {
  const BallSet &all = grid.balls();
  box_ = nullptr;
  translation_count_ = 1;
  needed_near_ = own_ = set_.n = 0;
  needed_balls_ = all.n;
  if (all.n > callers_.size()) return Status::capacity;
  for (uint32_t i = 0; i < all.n; ++i) set_.store(all.caller[i], all.ball(i));
  set_.largest_radius = all.largest_radius;
  set_.n = all.n;
  return keep_outer(patience);
}

Status PoreBalls::take(const PeriodicImages &images, Patience &patience) {
  box_ = &images.box();
  needed_near_ = own_ = set_.n = 0;
  needed_balls_ = images.balls();
  if (images.balls() > callers_.size()) return Status::capacity;
  for (uint32_t i = 0; i < images.balls(); ++i) set_.store(i, images.in_steps().ball(i));
  set_.largest_radius = images.largest_radius();
  set_.n = images.balls();
  const double a = to_double(box_->translation({{1, 0, 0}})).x, b = to_double(box_->translation({{0, 1, 0}})).y,
               c = to_double(box_->translation({{0, 0, 1}})).z;
  const double diagonal = std::sqrt(a * a + b * b + c * c);
  longest_reach_ = static_cast<int64_t>(0.75 * diagonal) + 64;
  if (diagonal > 200.0 * static_cast<double>(box_->shortest_side())) return Status::range;
  const Status status = keep_outer(patience);
  if (status == Status::ok) find_translations();
  return status;
}

void PoreBalls::find_box(Vec3 &low, Vec3 &high) const {
  low = high = {0.0, 0.0, 0.0};
  for (uint32_t i = 0; i < own_; ++i) {
    const auto cover = [i](double x, double &least, double &most) {
      least = i == 0 || x < least ? x : least;
      most = i == 0 || x > most ? x : most;
    };
    cover(set_.x[i], low.x, high.x);
    cover(set_.y[i], low.y, high.y);
    cover(set_.z[i], low.z, high.z);
  }
}

// Without a box the memory of images is free: ball_of_ has of each own ball its number in `others`.
bool PoreBalls::compare(const CubeGrid &grid, const PoreBalls &others, int64_t &grown) {
  const uint32_t given = grid.balls().n;
  if (box_ != nullptr || others.box_ != nullptr) return false;
  for (uint32_t k = 0; k < own_; ++k) ball_of_[k] = no_id;
  grown = 0;
  for (uint32_t k = 0; k < others.own_; ++k) {
    const uint32_t callers = others.callers_[k];
    if (callers >= given) return false;
    const exact::LatticeBall here = grid.balls().ball(grid.grid_index(callers)), there = others.set_.ball(k);
    const exact::Vector off = here.centre - there.centre;
    if (k == 0) grown = here.radius - there.radius;
    if (off.x != 0 || off.y != 0 || off.z != 0 || here.radius - there.radius != grown) return false;
    if (own_ball(callers) != no_id) ball_of_[own_ball(callers)] = k;
  }
  return true;
}

// The ball whose centre is at a position; no_id for none. A binary search, as the balls are in the order of centres.
uint32_t PoreBalls::ball_at(const exact::Vector &position) const {
  const Vec3 at = to_double(position);
  const uint32_t first = first_index(0, own_, [&](uint32_t k) {
    return set_.x[k] != at.x ? set_.x[k] > at.x : set_.y[k] != at.y ? set_.y[k] > at.y : set_.z[k] >= at.z;
  });
  const bool there = first < own_ && set_.x[first] == at.x && set_.y[first] == at.y && set_.z[first] == at.z;
  return there ? first : no_id;
}

// Notes a translation if it takes every ball to an equal one. False when `left` questions are used up: looking on is
// not worth it.
bool PoreBalls::note_translation(const exact::Vector &by, uint64_t &left) {
  for (uint32_t i = 0; i < own_; ++i) {
    if (left-- == 0) return false;
    exact::Vector at = moved(set_.ball(i).centre, by);
    BoxShift away;
    if (box_->wrap(at, away) != Status::ok) return true;
    const uint32_t other = ball_at(at);
    if (other == no_id || set_.r[other] != set_.r[i]) return true;
  }
  if (translation_count_ == most_translations) return false;
  exact::Vector position = by;
  BoxShift away;
  if (box_->wrap(position, away) == Status::ok) translation_[translation_count_++] = position;
  return true;
}

void PoreBalls::find_translations() {
  const exact::Vector sides{box_->translation({{1, 0, 0}}).x, box_->translation({{0, 1, 0}}).y,
                            box_->translation({{0, 0, 1}}).z};
  translation_[0] = {};
  translation_count_ = 1;
  brick_ = sides;
  uint64_t left = uint64_t{64} * own_ + 4096;
  bool all = own_ > 0;
  for (uint32_t k = 1; all && k < own_; ++k) {
    const exact::Vector from = set_.ball(0).centre, to = set_.ball(k).centre;
    if (set_.r[k] == set_.r[0]) all = note_translation({to.x - from.x, to.y - from.y, to.z - from.z}, left);
  }
  // The translations are a group. So the sides are: along z the least length of all; along y the least length of those
  // without a part along z; along x that of the rest.
  for (uint32_t k = 1; k < translation_count_; ++k) {
    const exact::Vector &by = translation_[k];
    const auto shorten = [](int64_t &side, int64_t length) { side = length < side ? length : side; };
    if (by.z != 0) {
      shorten(brick_.z, by.z);
    } else if (by.y != 0) {
      shorten(brick_.y, by.y);
    } else {
      shorten(brick_.x, by.x);
    }
  }
  all = all && sides.x % brick_.x == 0 && sides.y % brick_.y == 0 && sides.z % brick_.z == 0 &&
        (sides.x / brick_.x) * (sides.y / brick_.y) * (sides.z / brick_.z) == translation_count_;
  if (all) return;
  translation_count_ = 1;
  brick_ = sides;
}

PoreBalls::Image PoreBalls::moved_image(uint32_t own_ball, const BoxShift &shift, uint32_t translation) const {
  exact::Vector at = moved(set_.ball(own_ball).centre, translation_[translation]);
  BoxShift away;
  static_cast<void>(box_->wrap(at, away));
  return {ball_at(at), shift + away};
}

// Drops the balls inside another one: they are nowhere nearest. The others come in an order that does not depend on the
// caller's: in a box the order of positions, which ball_at() searches; else grid order, in which neighbours are close
// together. In the order of positions, of one centre the largest first, many balls are inside the ball before, or
// inside the ball in which that one was found. A ball that meets a dropped ball also meets the ball around that: so the
// balls that stay have the most neighbours.
Status PoreBalls::keep_outer(Patience &patience) {
  grid_.build(set_, set_.n);
  const Span<uint32_t> order = callers_.part(0, set_.n);
  for (uint32_t i = 0; i < set_.n; ++i) order[i] = i;
  sort_in_place(order, [&](uint32_t a, uint32_t b) {
    if (!patience.allows(50)) return false;
    const bool one_centre = set_.x[a] == set_.x[b] && set_.y[a] == set_.y[b] && set_.z[a] == set_.z[b];
    return one_centre && set_.r[a] != set_.r[b] ? set_.r[a] > set_.r[b] : set_.ranks_before(a, b);
  });
  const Span<uint32_t> is_hidden = ball_of_.part(0, set_.n);  // images come later
  exact::LatticeBall around{};
  for (uint32_t k = 0; k < set_.n; ++k) {
    if (!patience.allows(2000)) return Status::stopped;
    const uint32_t i = order[k];
    const exact::LatticeBall ball = set_.ball(i);
    is_hidden[i] = k > 0 && is_inside(ball, around) ? 1 : 0;
    if (is_hidden[i] != 0) continue;
    around = ball;
    const bool room = visit_near({ball.centre, ball.radius}, [&](uint32_t other, const BoxShift &shift) {
      if (other == i && shift.is_zero()) return;
      const exact::LatticeBall outer = image(other, shift);
      if (!is_inside(ball, outer)) return;
      is_hidden[i] = 1;
      around = outer.radius > around.radius ? outer : around;
    });
    if (!room) return Status::capacity;
  }
  uint32_t count = 0;
  for (uint32_t k = 0; k < set_.n; ++k) {
    const uint32_t i = grid_.balls().caller[k];
    if (is_hidden[i] == 0) callers_[count++] = i;
  }
  if (box_ != nullptr) {
    sort_in_place(callers_.part(0, count),
                  [&](uint32_t a, uint32_t b) { return patience.allows(50) && set_.ranks_before(a, b); });
  }
  given_ = set_.n;
  for (uint32_t i = 0; i < given_; ++i) own_slot(i).bits = no_id;
  // The grid has all balls, too.
  for (uint32_t k = 0; k < count; ++k) {
    own_slot(callers_[k]).bits = k;
    exact::LatticeBall ball = grid_.balls().ball(grid_.grid_index(callers_[k]));
    ball.index = k;
    set_.store(k, ball);
  }
  own_ = set_.n = count;
  grid_.build(set_, count);
  return patience.allows(0) ? Status::ok : Status::stopped;
}

Status PoreBalls::surround(int64_t reach) {
  uint64_t count = own_;
  const uint32_t hidden = given_ - own_;
  for (uint32_t i = 0; i < own_; ++i) {
    const exact::LatticeBall ball = set_.ball(i);
    box_->visit_images(ball.centre, reach, [&](const BoxShift &shift) {
      if (count + hidden < callers_.size()) {
        const auto k = static_cast<uint32_t>(count);
        ball_of_[k - own_] = i;
        shift_of_[k - own_] = SmallShift::of(shift);
        exact::LatticeBall moved = image(i, shift);
        moved.index = k;
        set_.store(k, moved);
      }
      ++count;
    });
  }
  needed_balls_ = larger_count(needed_balls_, clamped_count(count + hidden));
  set_.n = count + hidden > callers_.size() ? own_ : static_cast<uint32_t>(count);
  return set_.n == count ? Status::ok : Status::capacity;
}

void NearBalls::carve(Workspace &workspace, uint32_t room, uint32_t balls) {
  set_.carve(workspace, room);
  shift_ = workspace.take<BoxShift>(room);
  before_ = workspace.take<uint32_t>(room);
  last_ = workspace.take<uint32_t>(balls);
}

void NearBalls::reset(const PoreBalls &balls) {
  balls_ = &balls;
  needed_ = set_.n = 0;
  for (uint32_t k = 0; k < balls.own(); ++k) last_[k] = 0;
  set_.largest_radius = balls.set().largest_radius;
}

uint32_t NearBalls::add(uint32_t ball, const BoxShift &shift) {
  const uint32_t last = last_[ball];
  const bool known = last < set_.n && set_.caller[last] == ball;
  for (uint32_t k = known ? last : no_id; k != no_id; k = before_[k]) {
    if (shift_[k] == shift) return k;
  }
  const uint32_t k = set_.n;
  needed_ = larger_count(needed_, k + 1);
  if (k == shift_.size()) return no_id;
  exact::LatticeBall image = balls_->image(ball, shift);
  image.index = ball;
  ++set_.n;
  set_.store(k, image);
  shift_[k] = shift;
  before_[k] = known ? last : no_id;
  last_[ball] = k;
  return k;
}

}  // namespace hsp
