#include "core/extremes.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

// Takes the points of the pores before at which every new ball is farther. They are computed again from their balls: so
// they have the bits that a search finds.
Status CriticalPoints::take_known() {
  Status status = Status::ok;
  const auto keep_all = [&](const auto &records, PointKind kind) {
    for (uint32_t k = 0; k < records.size() && status == Status::ok; ++k) {
      status = keep_known(records[k].point, before_->tied(records[k].point), kind);
    }
  };
  keep_all(before_->maxima(), PointKind::maximum);
  keep_all(before_->gates(), PointKind::gate);
  needed_.near = larger_count(needed_.near, all_->needed_near());
  return status;
}

Status CriticalPoints::keep_known(const CriticalPoint &known, Span<const uint32_t> tied, PointKind kind) {
  if (!patience_.allows(3000)) return Status::stopped;
  needed_.near = larger_count(needed_.near, tied.size());
  if (tied.size() > limits_.near) return Status::capacity;
  const uint32_t count = kind == PointKind::gate ? 3 : 4;
  // A ball that is inside a new one is not in balls_, and farther than the new one: the point is gone.
  uint32_t set[4] = {no_id, no_id, no_id, no_id};
  bool there = true;
  for (uint32_t k = 0; k < count && there; ++k) there = (set[k] = all_->own_ball(known.ball[k])) != no_id;
  for (uint32_t k = 0; k < tied.size() && there; ++k) there = (at_point_[k] = all_->own_ball(tied[k])) != no_id;
  if (!there) return Status::ok;
  TangentPoint point(lines());
  if (!point.find(*balls_, {set[0], set[1], set[2]}, set[3], false) || point.level_against(floor_) <= 0)
    return Status::ok;
  bool far = true;
  if (!is_far_from_new(point, far)) return Status::capacity;
  if (far) add(point, set, kind, at_point_.part(0, tied.size()));
  return Status::ok;
}

// Sets `far`: whether all new balls are farther than the balls of a point. Returns false without room for the balls
// around it.
bool CriticalPoints::is_far_from_new(const TangentPoint &point, bool &far) {
  const auto is_farther = [&](uint32_t ball) { return !all_->is_new(ball) || point.nearness(ball) > 0; };
  const double reach = point.level_estimate() + point.level_error() + point.position_error() + 3.0;
  const Vec3 at = point.position_estimate();
  if (reach < 0x1p50 && point.position_error() < 0x1p20 && longest_part(at) < 0x1p50) {
    const exact::Vector centre{nearest(at.x), nearest(at.y), nearest(at.z)};
    return all_->visit_near({centre, static_cast<int64_t>(larger_of(reach, 3.0))},
                            [&](uint32_t ball, const BoxShift &) { far = far && is_farther(ball); });
  }
  for (uint32_t ball = 0; ball < all_->own() && far; ++ball) far = is_farther(ball);
  return true;
}

}  // namespace hsp
