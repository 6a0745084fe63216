#include "sphere/vertex_finder.hpp"

#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

constexpr uint32_t size_classes = 8;

uint32_t size_class(double b) {
  // b runs from -1 (the whole sphere) to 1 (nothing); NaN goes last.
  const double scaled = (b + 1.0) * (size_classes / 2.0);
  if (!(scaled < size_classes)) return size_classes - 1;
  return scaled > 0.0 ? static_cast<uint32_t>(scaled) : 0;
}

enum class PointAnswer { covered, free, unsure };

// A point, for testing against pairs of caps.
struct LanePoint {
  Lanes x, y, z;

  // Depth in the test caps t and t + 1.
  Lanes depths(const CapTests &tests, uint32_t t) const {
    return x * load_lanes(&tests.ux[t]) + y * load_lanes(&tests.uy[t]) + z * load_lanes(&tests.uz[t]) -
           load_lanes(&tests.b[t]);
  }
  bool inside_any(const CapTests &tests, uint32_t t, const Lanes &bound) const {
    static_assert(CapTests::group == 2 * lane_count);
    return any((depths(tests, t) > bound) | (depths(tests, t + lane_count) > bound));
  }
};

// A point that is beyond the error bound inside one cap is covered. It is free if it is beyond the bound outside all
// caps but its own two, on which it lies by construction. `hint` is the group that covered the last point: points of
// one circle are near each other.
PointAnswer test_point(const CapTests &tests, double x, double y, double z, double error, uint32_t &hint) {
  const LanePoint point{all_lanes(x), all_lanes(y), all_lanes(z)};
  const Lanes bound = all_lanes(error);
  if (point.inside_any(tests, hint, bound)) return PointAnswer::covered;
  for (uint32_t t = 0; t < tests.count; t += CapTests::group) {
    if (point.inside_any(tests, t, bound)) {
      hint = t;
      return PointAnswer::covered;
    }
  }
  uint32_t near = 0;
  for (uint32_t t = 0; t < tests.count; t += lane_count) near += count(point.depths(tests, t) >= -bound);
  return near == 2 ? PointAnswer::free : PointAnswer::unsure;
}

}  // namespace

void CapTests::carve(Workspace &workspace, uint32_t capacity) {
  const uint64_t padded = static_cast<uint64_t>(capacity) + group;
  ux = workspace.take<double>(padded);
  uy = workspace.take<double>(padded);
  uz = workspace.take<double>(padded);
  b = workspace.take<double>(padded);
  cap = workspace.take<uint32_t>(capacity);
}

void CapTests::fill(const Caps &caps) {
  count = caps.count;
  uint32_t start[size_classes + 1] = {};
  for (uint32_t k = 0; k < caps.count; ++k) ++start[size_class(caps.b[k]) + 1];
  for (uint32_t c = 0; c < size_classes; ++c) start[c + 1] += start[c];
  for (uint32_t k = 0; k < caps.count; ++k) {
    const uint32_t place = start[size_class(caps.b[k])]++;
    ux[place] = caps.ux[k];
    uy[place] = caps.uy[k];
    uz[place] = caps.uz[k];
    b[place] = caps.b[k];
    cap[place] = k;
  }
  // Caps that nothing lies in, to fill the last group.
  for (uint32_t place = count; place < count + group; ++place) {
    ux[place] = uy[place] = uz[place] = 0.0;
    b[place] = 4.0;
  }
}

void VertexFinder::carve(Workspace &workspace, uint32_t capacity) {
  tests_.carve(workspace, capacity);
  state_ = workspace.take<uint8_t>(capacity);
}

// The groups of test caps that covered the last p- and p+.
struct VertexFinder::Hints {
  uint32_t group[2] = {0, 0};
};

[[gnu::always_inline]] inline void VertexFinder::decide_pair(const BallSet &balls, const Caps &caps, uint32_t j,
                                                             uint32_t k, Hints &hints,
                                                             FixedVector<VertexRecord> &vertices) {
  if ((state_[j] | state_[k]) & covered) return;
  const CapPair pair(caps, j, k);
  if (pair.surely_apart()) {
    if (pair.surely_inside()) state_[j] |= covered;
    if (pair.surely_contains()) state_[k] |= covered;
    return;
  }
  if (!pair.surely_cross()) {
    exact::count_answer(exact::Question::vertex_pair, exact::Rung::exact);
    if (find_vertices_exactly(balls, caps, tests_, j, k, vertices)) {
      state_[j] |= crossed;
      state_[k] |= crossed;
    }
    return;
  }
  state_[j] |= crossed;
  state_[k] |= crossed;
  const CrossingPoints points(caps, j, k, pair);
  PointAnswer answer[2];
  for (uint32_t point = 0; point < 2; ++point) {
    answer[point] =
        test_point(tests_, points.x[point], points.y[point], points.z[point], points.error, hints.group[point]);
  }
  if (answer[0] == PointAnswer::unsure || answer[1] == PointAnswer::unsure) {
    exact::count_answer(exact::Question::vertex_pair, exact::Rung::exact);
    find_vertices_exactly(balls, caps, tests_, j, k, vertices);
    return;
  }
  exact::count_answer(exact::Question::vertex_pair, exact::Rung::filter);
  for (uint32_t point = 0; point < 2; ++point) {
    if (answer[point] != PointAnswer::free) continue;
    vertices.push({{caps.origin, caps.ball[j], caps.ball[k]}, point == 1 ? VertexRecord::positive_bit : 0U});
  }
}

inline void VertexFinder::add_free_circle(const Caps &caps, uint32_t j, FixedVector<CircleRecord> &circles) const {
  if (state_[j] == 0 && is_free_circle(caps, tests_, j)) circles.push({{caps.origin, caps.ball[j]}, {no_id, no_id}});
}

void VertexFinder::find(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
                        FixedVector<CircleRecord> &circles) {
  tests_.fill(caps);
  for (uint32_t j = caps.first_later; j < caps.count; ++j) state_[j] = 0;
  Hints hints;
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) decide_pair(balls, caps, j, k, hints, vertices);
  }
  for (uint32_t j = caps.first_later; j < caps.count; ++j) add_free_circle(caps, j, circles);
}

void VertexFinder::find_on_last(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
                                FixedVector<CircleRecord> &circles) {
  tests_.fill(caps);
  for (uint32_t j = 0; j < caps.count; ++j) state_[j] = 0;
  Hints hints;
  const uint32_t last = caps.count - 1;
  for (uint32_t j = 0; j < last; ++j) decide_pair(balls, caps, j, last, hints, vertices);
  add_free_circle(caps, last, circles);
}

}  // namespace hsp
