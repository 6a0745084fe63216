#include "boundary/vertices.hpp"

#include "boundary/cap_pair.hpp"

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

struct PairAnswer {
  PointAnswer point[2];
};

// Tests both points of a pair against all caps. A point beyond the error bound inside one cap is covered. It is free if
// it is beyond the bound outside all caps but its own two, on which it lies by construction.
PairAnswer test_points(const CapTests &tests, const CrossingPoints &points) {
  const double error = points.error;
  double deepest[2] = {-2.0, -2.0};
  uint32_t near[2] = {0, 0};
  for (uint32_t t = 0; t < tests.count; ++t) {
    for (int point = 0; point < 2; ++point) {
      const double depth =
          points.x[point] * tests.ux[t] + points.y[point] * tests.uy[t] + points.z[point] * tests.uz[t] - tests.b[t];
      deepest[point] = depth > deepest[point] ? depth : deepest[point];
      near[point] += depth >= -error ? 1U : 0U;
    }
    if (deepest[0] > error && deepest[1] > error) break;
  }
  PairAnswer answer;
  for (int point = 0; point < 2; ++point) {
    answer.point[point] = deepest[point] > error ? PointAnswer::covered
                          : near[point] == 2     ? PointAnswer::free
                                                 : PointAnswer::unsure;
  }
  return answer;
}

}  // namespace

void CapTests::carve(Workspace &workspace, uint32_t capacity) {
  ux = workspace.take<double>(capacity);
  uy = workspace.take<double>(capacity);
  uz = workspace.take<double>(capacity);
  b = workspace.take<double>(capacity);
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
}

void VertexFinder::carve(Workspace &workspace, uint32_t capacity) {
  tests_.carve(workspace, capacity);
  state_ = workspace.take<uint8_t>(capacity);
}

void VertexFinder::find(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
                        FixedVector<CircleRecord> &circles) {
  tests_.fill(caps);
  for (uint32_t j = caps.first_later; j < caps.count; ++j) state_[j] = 0;

  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      if ((state_[j] | state_[k]) & covered) continue;
      const CapPair pair(caps, j, k);
      if (pair.surely_apart()) {
        if (pair.surely_inside()) state_[j] |= covered;
        if (pair.surely_contains()) state_[k] |= covered;
        continue;
      }
      if (!pair.surely_cross()) {
        exact::count_answer(exact::Question::vertex_pair, exact::Rung::exact);
        if (find_vertices_exactly(balls, caps, tests_, j, k, vertices)) {
          state_[j] |= crossed;
          state_[k] |= crossed;
        }
        continue;
      }
      state_[j] |= crossed;
      state_[k] |= crossed;
      const CrossingPoints points(caps, j, k, pair);
      const PairAnswer answer = test_points(tests_, points);
      if (answer.point[0] == PointAnswer::unsure || answer.point[1] == PointAnswer::unsure) {
        exact::count_answer(exact::Question::vertex_pair, exact::Rung::exact);
        find_vertices_exactly(balls, caps, tests_, j, k, vertices);
        continue;
      }
      exact::count_answer(exact::Question::vertex_pair, exact::Rung::filter);
      for (uint32_t point = 0; point < 2; ++point) {
        if (answer.point[point] != PointAnswer::free) continue;
        vertices.push({{caps.origin, caps.ball[j], caps.ball[k]}, point == 1 ? VertexRecord::positive_bit : 0U});
      }
    }
  }
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    if (state_[j] == 0 && is_free_circle(caps, tests_, j)) {
      circles.push({{caps.origin, caps.ball[j]}, {no_id, no_id}});
    }
  }
}

}  // namespace hsp
