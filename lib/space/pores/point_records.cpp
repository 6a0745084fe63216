#include <initializer_list>

#include "core/sorting.hpp"
#include "pores/critical_points.hpp"

namespace hsp {

// The name that all copies of a point have: balls of the box, and their shifts relative to the first of them.
PointName CriticalPoints::name_of_ids(const uint32_t *ids, uint32_t count) {
  PointName name{{no_id, no_id, no_id, no_id}, {}};
  const BoxShift first = all_->shift_of(ids[0]);
  for (uint32_t k = 0; k < count; ++k) {
    name.ball[k] = all_->ball_of(ids[k]);
    const BoxShift shift = all_->shift_of(ids[k]) - first;
    beyond_reach_ = beyond_reach_ || !SmallShift::fits(shift);
    name.shift[k] = SmallShift::of(shift);
  }
  return name;
}

void CriticalPoints::add(TangentPoint &point, const uint32_t *ids, PointKind kind, Span<uint32_t> tied) {
  const BallSet &balls = *balls_;
  const uint32_t count = kind == PointKind::gate ? 3 : 4;
  sort_in_place(tied, [&](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
  uint32_t set[4];
  name_of(balls, point, tied, kind, room_, set);
  const PointName name = name_of_ids(set, count);
  if ((kind == PointKind::gate ? gate_names_.find(name, gates_) : maximum_names_.find(name, maxima_)) != no_id) return;
  // Computed from the balls of the name in their order, whatever set has found the point: so it has the same bits.
  bool same = true;
  for (uint32_t k = 0; k < count; ++k) same = same && set[k] == ids[k];
  if (!same) static_cast<void>(point.find(balls, {set[0], set[1], set[2]}, count == 3 ? no_id : set[3], false));
  CriticalPoint record{};
  record.tied = tied.size();
  Vec3 off{};
  record.error = point.refine_from_base(off, record.level);
  const BoxShift home = all_->shift_of(set[0]);
  for (uint32_t k = 0; k < all_->translations(); ++k) add_moved(record, off, name, kind, tied, home, k);
}

// Adds the point to which a translation takes a point.
void CriticalPoints::add_moved(CriticalPoint record, const Vec3 &off, const PointName &name, PointKind kind,
                               Span<const uint32_t> tied, const BoxShift &from, uint32_t translation) {
  const BallSet &balls = *balls_;
  const uint32_t count = kind == PointKind::gate ? 3 : 4;
  const PointName own = translation == 0 ? name : moved_name(name, translation);
  if (translation != 0 &&
      (kind == PointKind::gate ? gate_names_.find(own, gates_) : maximum_names_.find(own, maxima_)) != no_id) {
    return;
  }
  record.first_tied = clamped_count(tied_.required());
  static_cast<PointName &>(record) = own;
  const uint32_t first = own.ball[0];
  record.position = Vec3{balls.x[first], balls.y[first], balls.z[first]} + off;
  if (kind == PointKind::gate) {
    gates_.push({record, {no_id, no_id}, {}, false, false, {translation}});
    gate_names_.add(own, clamped_count(gates_.required() - 1), gates_);
  } else {
    maxima_.push({record, no_id, no_id});
    maximum_names_.add(own, clamped_count(maxima_.required() - 1), maxima_);
  }
  // A point that there was no room for may be found again.
  const bool stored = kind == PointKind::gate ? !gates_.overflowed() : !maxima_.overflowed();
  if (tied.size() == count || !stored) return;
  const BoxShift home = translation == 0 ? BoxShift{} : all_->moved_image(name.ball[0], BoxShift{}, translation).shift;
  for (const uint32_t ball : tied) {
    PoreBalls::Image image{all_->ball_of(ball), all_->shift_of(ball) - from};
    if (translation != 0) image = all_->moved_image(image.ball, image.shift, translation);
    tied_.push(image.ball);
    tied_shifts_.push(SmallShift::of(image.shift - home));
  }
}

PointName CriticalPoints::moved_name(const PointName &name, uint32_t translation) {
  PointName moved{{no_id, no_id, no_id, no_id}, {}};
  BoxShift home;
  for (uint32_t k = 0; k < 4 && name.ball[k] != no_id; ++k) {
    const PoreBalls::Image image = all_->moved_image(name.ball[k], name.shift[k].shift(), translation);
    if (k == 0) home = image.shift;
    beyond_reach_ = beyond_reach_ || !SmallShift::fits(image.shift - home);
    moved.ball[k] = image.ball;
    moved.shift[k] = SmallShift::of(image.shift - home);
  }
  return moved;
}

}  // namespace hsp
