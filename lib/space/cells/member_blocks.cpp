#include "cells/member_blocks.hpp"

#include <cmath>
#include <initializer_list>

#include "core/sorting.hpp"

namespace hsp {
namespace {

// The lowest ten bits of a number, each with two others behind it.
uint32_t spread(uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FFU;
  bits = (bits | bits << 8) & 0x0300F00FU;
  bits = (bits | bits << 4) & 0x030C30C3U;
  return (bits | bits << 2) & 0x09249249U;
}

// The place of a centre on a curve that keeps near points together (Morton 1966). No ball of a cube has its centre
// farther than a side from the middle, along any axis.
uint32_t curve_place(const MemberArrays &members, uint32_t m, double side) {
  const auto along = [side](double value) { return static_cast<uint32_t>(512.0 + 500.0 * (value / side)); };
  return spread(along(members.x[m])) | spread(along(members.y[m])) << 1 | spread(along(members.z[m])) << 2;
}

// The square of how far a value lies outside an interval.
double squared_gap(double value, double low, double high) {
  const double gap = value < low ? low - value : value > high ? value - high : 0.0;
  return gap * gap;
}

}  // namespace

void MemberBlocks::carve(Workspace &workspace, uint32_t balls) {
  const uint64_t places = balls < fewest ? 0 : places_for(balls);
  workspace.take_each(places, member_, place_, x_, y_, z_, radius_, power_, not_discarded_);
  workspace.take_each(places / in_block, box_, distance_, known_block_);
}

void MemberBlocks::enter(const MemberArrays &members, double side) {
  const uint32_t count = members.count;
  blocks_ = 0;
  if (count < fewest) return;
  const uint32_t places = static_cast<uint32_t>(places_for(count));
  blocks_ = places / in_block;
  const Span<uint32_t> on_curve = place_;
  for (uint32_t m = 0; m < count; ++m) {
    member_[m] = m;
    on_curve[m] = curve_place(members, m, side);
  }
  sort_in_place(member_.part(0, count),
                [&](uint32_t a, uint32_t b) { return on_curve[a] != on_curve[b] ? on_curve[a] < on_curve[b] : a < b; });
  for (uint32_t place = 0; place < count; ++place) place_[member_[place]] = place;
  for (uint32_t place = 0; place < places; ++place) {
    // Behind the last ball there are discarded copies of it.
    const uint32_t m = place < count ? member_[place] : member_[count - 1];
    member_[place] = m;
    x_[place] = members.x[m];
    y_[place] = members.y[m];
    z_[place] = members.z[m];
    radius_[place] = members.radius[m];
    power_[place] = members.power[m];
    not_discarded_[place] = place < count ? members.not_discarded[m] : 0.0;
    Box &box = box_[place / in_block];
    const double at[3] = {x_[place], y_[place], z_[place]};
    if (place % in_block == 0) box = {{at[0], at[1], at[2]}, {at[0], at[1], at[2]}, 0.0};
    for (uint32_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = at[axis] < box.low[axis] ? at[axis] : box.low[axis];
      box.high[axis] = at[axis] > box.high[axis] ? at[axis] : box.high[axis];
    }
    box.largest = radius_[place] > box.largest ? radius_[place] : box.largest;
  }
}

// A bound of the distances that find_planes() computes. Of balls at a distance v, of which the other has p more in the
// square of its radius, the plane is at v - p / v. That grows with v, but where p < 0 and v^2 < -p, and is least for
// the largest p. At v^2 = -p it is 2 v.
double MemberBlocks::least_distance(const Box &box) const {
  const double square = squared_gap(own_.x, box.low[0], box.high[0]) + squared_gap(own_.y, box.low[1], box.high[1]) +
                        squared_gap(own_.z, box.low[2], box.high[2]);
  const double powers = (box.largest - own_.radius) * (box.largest + own_.radius);
  double least = -done_with;
  if (square < -powers) {
    least = -4.0 * powers;
  } else if (square > 0.0) {
    const double own_h = square - powers;
    least = own_h * std::fabs(own_h) / square;
  }
  return least - 0x1p-40 * (std::fabs(least) + square + std::fabs(powers));
}

void MemberBlocks::begin(const MemberBall &own, double limit) {
  own_ = own;
  limit_ = limit;
  known_blocks_ = at_once_ = 0;
  nearest_unknown_ = done_with;
  for (uint32_t b = 0; b < blocks_; ++b) {
    const double least = least_distance(box_[b]);
    distance_[b] = least <= limit ? least : done_with;
    nearest_unknown_ = distance_[b] < nearest_unknown_ ? distance_[b] : nearest_unknown_;
  }
}

MemberArrays MemberBlocks::block(uint32_t b) const {
  const uint32_t first = in_block * b;
  return {x_.data() + first,
          y_.data() + first,
          z_.data() + first,
          radius_.data() + first,
          power_.data() + first,
          not_discarded_.data() + first,
          in_block};
}

bool MemberBlocks::find_more(Target target, const PlaneArrays &planes) {
  if (!(nearest_unknown_ < done_with)) return false;
  at_once_ = at_once_ == 0 ? 8 : at_once_ < blocks_ ? 4 * at_once_ : at_once_;
  // About so many are as near as the nearest of every so many.
  double most = done_with;
  for (uint32_t b = 0; b < blocks_; b += at_once_) most = distance_[b] < most ? distance_[b] : most;
  nearest_unknown_ = done_with;
  for (uint32_t b = 0; b < blocks_; ++b) {
    if (distance_[b] <= most && distance_[b] < done_with) {
      const uint32_t first = known();
      PlaneArrays of_block = planes;
      for (double **numbers : {&of_block.x, &of_block.y, &of_block.z, &of_block.h, &of_block.distance})
        *numbers += first;
      find_planes(target, block(b), own_, limit_, of_block);
      known_block_[known_blocks_++] = b;
      distance_[b] = done_with;
    }
    nearest_unknown_ = distance_[b] < nearest_unknown_ ? distance_[b] : nearest_unknown_;
  }
  return true;
}

bool MemberBlocks::is_before_known(Target target, const Vec3 &point, double error, const double *distance) const {
  for (uint32_t k = 0; k < known_blocks_; ++k) {
    if (!is_before_all(target, block(known_block_[k]), own_, point, error, distance + in_block * k)) return false;
  }
  return true;
}

}  // namespace hsp
