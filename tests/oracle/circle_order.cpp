#include "circle_order.hpp"

#include <algorithm>
#include <stdexcept>

#include "big_integer.hpp"

namespace oracle {
namespace {

// The sign of det [axis, a, b]: +1 if b is less than half a turn counter-clockwise of a about the axis.
int turn(const Vector &axis, const Vector &a, const Vector &b) {
  const Vector axis_a = cross(axis, a);
  return (BigInteger(axis_a[0]) * BigInteger(b[0]) + BigInteger(axis_a[1]) * BigInteger(b[1]) +
          BigInteger(axis_a[2]) * BigInteger(b[2]))
      .sign();
}

// The sign of the cosine of the angle between a and b as seen along the axis.
int cosine(const Vector &axis, const Vector &a, const Vector &b) {
  const Vector axis_a = cross(axis, a);
  const Vector axis_b = cross(axis, b);
  return (BigInteger(axis_a[0]) * BigInteger(axis_b[0]) + BigInteger(axis_a[1]) * BigInteger(axis_b[1]) +
          BigInteger(axis_a[2]) * BigInteger(axis_b[2]))
      .sign();
}

// Counter-clockwise angle from `start`, in [0, 2 pi): is that of a less than that of b?
bool comes_first(const Vector &axis, const Vector &start, const Vector &a, const Vector &b) {
  const auto half = [&](const Vector &v) {
    const int s = turn(axis, start, v);
    return s > 0 || (s == 0 && cosine(axis, start, v) > 0) ? 0 : 1;
  };
  return half(a) != half(b) ? half(a) < half(b) : turn(axis, a, b) > 0;
}

}  // namespace

FreePieces::FreePieces(const TiedBalls &set, uint32_t a, const Cap &circle, const std::vector<Cap> &caps,
                       const FreeTest &is_free)
    : set_(&set), ball_(a), circle_(circle) {
  std::vector<Cap> crossing;
  for (const Cap &cap : caps) {
    if (set.circles_cross(a, circle, cap))
      crossing.push_back(cap);
    else if (set.circle_inside(a, circle, cap))
      return;
  }
  if (crossing.empty())
    kind_ = Kind::whole;
  else
    find_arcs(crossing, is_free);
}

FreePieces::FreePieces(const TiedBalls &set, uint32_t a, const Cap &circle, const std::vector<Cap> &caps)
    : FreePieces(set, a, circle, caps, [&](const Cap &cap, int side) {
        return std::none_of(caps.begin(), caps.end(), [&](const Cap &other) {
          return other.ball != cap.ball && set.crossing_inside(a, {circle, cap, side}, other);
        });
      }) {}

void FreePieces::find_arcs(const std::vector<Cap> &crossing, const FreeTest &is_free) {
  // Going counter-clockwise, the derivative of 2 v.y at the crossing of side s has the sign of -s: side +1 is an exit.
  std::vector<Cap> exits;
  std::vector<Cap> entries;
  for (const Cap &cap : crossing) {
    const bool exit = is_free(cap, +1);
    const bool entry = is_free(cap, -1);
    if (exit) exits.push_back(cap);
    if (entry) entries.push_back(cap);
    if (exit || entry) directions_.push_back(cap.normal);
  }
  if (directions_.empty()) return;
  kind_ = Kind::arcs;
  const Vector &axis = circle_.normal;
  const Vector start = directions_.front();
  std::sort(directions_.begin(), directions_.end(),
            [&](const Vector &a, const Vector &b) { return comes_first(axis, start, a, b); });
  for (size_t k = 1; k < directions_.size(); ++k)
    if (!comes_first(axis, start, directions_[k - 1], directions_[k]))
      throw std::logic_error("two owners in one direction: " + to_text(set_->balls()));

  std::vector<std::optional<Cap>> exit_of_sector(directions_.size());
  std::vector<std::optional<Cap>> entry_of_sector(directions_.size());
  for (const Cap &cap : exits) {
    auto &exit = exit_of_sector[sector_of_crossing(cap, +1)];
    if (exit) throw std::logic_error("two exits in one sector: " + to_text(set_->balls()));
    exit = cap;
  }
  for (const Cap &cap : entries) {
    auto &entry = entry_of_sector[sector_of_crossing(cap, -1)];
    if (entry) throw std::logic_error("two entries in one sector: " + to_text(set_->balls()));
    entry = cap;
  }
  arc_of_sector_.resize(directions_.size());
  for (size_t k = 0; k < directions_.size(); ++k) {
    if (exit_of_sector[k].has_value() != entry_of_sector[k].has_value())
      throw std::logic_error("an exit without an entry: " + to_text(set_->balls()));
    if (!exit_of_sector[k]) continue;
    arc_of_sector_[k] = arcs_.size();
    arcs_.push_back({*exit_of_sector[k], *entry_of_sector[k]});
  }
}

size_t FreePieces::sector_of_crossing(const Cap &cap, int side) const {
  const size_t n = directions_.size();
  if (n == 1) return 0;
  // left[k]: the side of the plane through the axis and direction k on which the point lies: +1 less than half a turn
  // counter-clockwise of the direction, 0 opposite to it (not in it, as the directions are covered).
  std::vector<int> left(n);
  for (size_t k = 0; k < n; ++k)
    left[k] = set_->crossing_side(ball_, {circle_, cap, side}, cross(circle_.normal, directions_[k]));
  for (size_t k = 0; k < n; ++k) {
    const size_t next = (k + 1) % n;
    const int width = turn(circle_.normal, directions_[k], directions_[next]);  // +1: below half a turn, -1: above
    const bool is_in = width > 0   ? left[k] > 0 && left[next] < 0
                       : width < 0 ? !(left[next] > 0 && left[k] < 0)
                                   : left[k] > 0;
    if (is_in) return k;
  }
  throw std::logic_error("a point in no sector: " + to_text(set_->balls()));
}

size_t FreePieces::sector_of_direction(const Vector &direction) const {
  const Vector &axis = circle_.normal;
  const Vector &start = directions_.front();
  size_t sector = directions_.size() - 1;
  for (size_t k = 1; k < directions_.size(); ++k)
    if (comes_first(axis, start, direction, directions_[k])) {
      sector = k - 1;
      break;
    }
  return sector;
}

size_t FreePieces::arc_with_crossing(const Cap &cap, int side) const {
  const auto &arc = arc_of_sector_.at(sector_of_crossing(cap, side));
  if (!arc) throw std::logic_error("a free point in a covered sector: " + to_text(set_->balls()));
  return *arc;
}

size_t FreePieces::arc_with_direction(const Vector &direction) const {
  const auto &arc = arc_of_sector_.at(sector_of_direction(direction));
  if (!arc) throw std::logic_error("a free direction in a covered sector: " + to_text(set_->balls()));
  return *arc;
}

}  // namespace oracle
