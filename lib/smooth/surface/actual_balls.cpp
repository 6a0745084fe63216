#include "surface/actual_balls.hpp"

#include "surface/actual_decisions.hpp"

namespace hsp {

int ActualBalls::overlap(uint32_t v, uint32_t w) const {
  return decide_at(v, [&](const auto &actual) {
    auto u = vector_of(actual);
    actual.find_arm_to_vertex(v, w, u);
    return (actual.square_of_diameter() - dot(u, u)).sign();
  });
}

bool ActualBalls::may_cut_patch(uint32_t other, uint32_t v) const {
  return decide_at(v, [&](const auto &actual) {
           const int cuts = actual.cuts_patch(other, v);
           return cuts == 0 && actual.bits == widest ? 1 : cuts;
         }) > 0;
}

namespace {

// The place in `near` of the first vertex, other than w and x, whose probe may contain the point at `arm` from v.
// near.size() if none may contain it; no_id if one certainly does.
template <class Number>
uint32_t first_in_doubt(const ActualPoints<Number> &actual, uint32_t v, const NumberVector<Number> &arm,
                        Span<const uint32_t> near, uint32_t w, uint32_t x) {
  uint32_t first = near.size();
  for (uint32_t k = near.size(); k-- > 0;) {
    if (near[k] == w || near[k] == x) continue;
    const int inside = actual.in_probe(near[k], v, arm);
    if (inside > 0) return no_id;
    if (inside == 0) first = k;
  }
  return first;
}

// Whether the point at `arm` from v is in the patch of v and in none of these probes. The probes are asked first, as
// one of them decides most questions. Once the point's position is known, doubles decide most of the rest.
template <class Number>
[[gnu::noinline]] int is_left(const ActualPoints<Number> &actual, uint32_t v, const NumberVector<Number> &arm,
                              Span<const uint32_t> near, uint32_t w, uint32_t x) {
  [[maybe_unused]] const ActualPoints<BoundedDouble> in_doubles({actual.balls, actual.boundary, actual.kept},
                                                                actual.ball());
  [[maybe_unused]] const NumberVector<BoundedDouble> about = rounded(arm);
  constexpr bool doubles_first = !small_code && !std::is_same_v<Number, BoundedDouble>;
  uint32_t k = 0;
  int in_patch = 0;
  if constexpr (doubles_first) {
    k = first_in_doubt(in_doubles, v, about, near, w, x);
    in_patch = k == no_id ? -1 : in_doubles.inside_of_sides(v, about);
    if (in_patch < 0) return -1;
  }
  int sure = 1;
  for (; k < near.size(); ++k) {
    if (near[k] == w || near[k] == x) continue;
    if constexpr (doubles_first) {
      if (in_doubles.in_probe(near[k], v, about) < 0) continue;
    }
    const int inside = actual.in_probe(near[k], v, arm);
    if (inside > 0) return -1;
    if (inside == 0) sure = 0;
  }
  if (in_patch == 0) in_patch = actual.inside_of_sides(v, arm);
  return in_patch > 0 ? sure : in_patch;
}

}  // namespace

uint32_t ActualBalls::corners(uint32_t a, uint32_t b, uint32_t c, Span<const uint32_t> near) const {
  constexpr int decided = 4;
  const int answer = decide_at(a, [&](const auto &actual) {
    auto middle = vector_of(actual), half = middle;
    const int meet = actual.find_meeting(a, b, c, middle, half);
    if (meet <= 0) return meet < 0 ? decided : 0;
    middle -= half;
    const int low = hsp::is_left(actual, a, middle, near, b, c);
    half += half;
    middle += half;
    const int high = low == 0 ? 0 : hsp::is_left(actual, a, middle, near, b, c);
    return high == 0 ? 0 : decided | (low > 0 ? 1 : 0) | (high > 0 ? 2 : 0);
  });
  return static_cast<uint32_t>(answer) % decided;
}

int ActualBalls::is_left(const BorderPoint &point, Span<const uint32_t> near) const {
  const uint32_t v = point.id[0];
  return decide_at(v, [&](const auto &actual) {
    auto arm = vector_of(actual);
    actual.find_arm(v, point, arm);
    return hsp::is_left(actual, v, arm, near, point.id[1], no_id);
  });
}

// Let J be the corner of u, v and w, with the sign s, and a, b and c these three in the order of their numbers.
// Relative to a, J is s r n plus a vector in the plane of the three, with r > 0 and n = (b - a) x (c - a). So det(w -
// v, J - v, J - u) = s r n.((w - v) x (u - v)), which has the sign s if (v, w, u) is (a, b, c) or (b, c, a), and else
// the opposite sign.
bool ActualBalls::starts_at_corner(const BorderPoint &corner, uint32_t v, uint32_t w) {
  const bool third_is_between = corner.id[0] == v && corner.id[2] == w;
  return (corner.sign > 0) != third_is_between;
}

// Away from the cusp the crease runs inside of that side of v's patch which ends in the cusp.
int ActualBalls::starts_at_cusp(const BorderPoint &cusp, uint32_t v, uint32_t w) const {
  const VertexRecord &record = boundary_.vertex(v);
  uint32_t slot = 0;
  while (record.ball[slot] == cusp.id[0] || record.ball[slot] == cusp.id[1]) ++slot;
  const SideOfPatch side = side_of_patch(record, slot);
  return decide_at(v, [&](const auto &actual) {
    auto axis = vector_of(actual), arm = axis, inward = axis;
    actual.find_arm_to_vertex(v, w, axis);
    actual.find_arm(v, cusp, arm);
    actual.find_inward(v, record.ball[side.first], record.ball[side.second], inward);
    return determinant(inward, axis, arm).sign();
  });
}

int ActualBalls::turn(uint32_t v, uint32_t w, const BorderPoint &first, const BorderPoint &second) const {
  return decide_at(v, [&](const auto &actual) {
    auto axis = vector_of(actual), start = axis, end = axis;
    actual.find_arm_to_vertex(v, w, axis);
    actual.find_arm(v, first, start);
    actual.find_arm(v, second, end);
    return determinant(axis, start, end).sign();
  });
}

bool ActualBalls::has_cusps(uint32_t a, uint32_t b) const {
  const auto height_of_circle = [&](uint32_t i, uint32_t j) {
    return decide_about(i, [&](const auto &actual) { return actual.height_of_circle(i, j).sign(); });
  };
  return decide_about(a, [&](const auto &actual) { return actual.height_over_axis(a, b).sign(); }) < 0 &&
         height_of_circle(a, b) > 0 && height_of_circle(b, a) > 0;
}

namespace {

template <class Number>
int is_known(const NumberVector<Number> &a, Vec3 &way) {
  constexpr double least_error = 0x1p-36;
  const NumberVector<BoundedDouble> b = rounded(a);
  way = to_double(b);
  const double longest = std::fabs(way.x) + std::fabs(way.y) + std::fabs(way.z);
  return longest > 0.0 && b.x.error + b.y.error + b.z.error <= least_error * longest ? 1 : 0;
}

}  // namespace

bool ActualBalls::find_way(uint32_t v, const BorderPoint &point, Vec3 &way) const {
  return measure_at(v, [&](const auto &actual) {
           auto arm = vector_of(actual);
           actual.find_arm(v, point, arm);
           return is_known(arm, way);
         }) != 0;
}

bool ActualBalls::find_way_to_vertex(uint32_t v, uint32_t w, Vec3 &way) const {
  return measure_at(v, [&](const auto &actual) {
           auto arm = vector_of(actual);
           actual.find_arm_to_vertex(v, w, arm);
           return is_known(arm, way);
         }) != 0;
}

// Seen from p+ of the circles of balls 1 and 2 on ball 0, balls 0, 1 and 2 run clockwise.
SideOfPatch side_of_patch(const VertexRecord &vertex, uint32_t slot) {
  const uint32_t next = (slot + 1) % 3, last = (slot + 2) % 3;
  return vertex.positive() ? SideOfPatch{last, next} : SideOfPatch{next, last};
}

}  // namespace hsp
