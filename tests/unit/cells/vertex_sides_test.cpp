// The kernels of vertex_sides.hpp, vertex_edges.hpp, edge_crossings.hpp and cube_members.hpp for registers of every
// width, held against plain loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "cells/cube_frame.hpp"
#include "cells/cube_members.hpp"
#include "cells/edge_crossings.hpp"
#include "cells/vertex_edges.hpp"
#include "cells/vertex_sides.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

namespace {

using hsp::CrossedEdge;
using hsp::CrossingBounds;
using hsp::CutMargins;
using hsp::CutVertices;
using hsp::EdgeEnds;
using hsp::EdgeSides;
using hsp::FacetSides;
using hsp::FlatLine;
using hsp::MemberArrays;
using hsp::PlaneArrays;
using hsp::PlaneOrder;
using hsp::SquareSides;
using hsp::UnitPlane;
using hsp::Vec3;
using hsp::VertexArrays;

// Multiples of 1/8, so that sums and products are exact and some values are equal to the margin.
class Numbers {
 public:
  Numbers(oracle::RandomSource &random, uint32_t count, int64_t most) {
    for (uint32_t k = 0; k < count; ++k) values_.push_back(static_cast<double>(random.in(-most, most)) / 8);
    values_.resize(count + 7, 1e9);  // what is behind the last one must have no effect
  }
  const double *data() const { return values_.data(); }
  double *data() { return values_.data(); }
  double operator[](uint32_t k) const { return values_[k]; }

 private:
  std::vector<double> values_;
};

uint64_t bit(uint32_t k) {
  return uint64_t{1} << k;
}

// Of vertices; what is behind the last one must have no effect.
class Vertices {
 public:
  Vertices(oracle::RandomSource &random, uint32_t count)
      : count_(count),
        x_(random, count, 20),
        y_(random, count, 20),
        z_(random, count, 20),
        squared_(random, count, 200),
        value_(random, count, 0) {
    for (uint32_t v = 0; v < count + 7; ++v) squared_.data()[v] = v < count ? std::fabs(squared_[v]) : 0.0;
  }
  uint32_t count() const { return count_; }
  VertexArrays arrays() { return {x_.data(), y_.data(), z_.data(), nullptr, squared_.data(), value_.data()}; }
  double squared(uint32_t v) const { return squared_[v]; }
  double value(uint32_t v) const { return value_[v]; }
  double value_at(uint32_t v, double a, double b, double c, double h) const {
    return a * x_[v] + b * y_[v] + c * z_[v] - h;
  }
  double squared_length(uint32_t v, uint32_t w) const {
    const double x = x_[w] - x_[v], y = y_[w] - y_[v], z = z_[w] - z_[v];
    return x * x + y * y + z * z;
  }

 private:
  uint32_t count_;
  Numbers x_, y_, z_, squared_, value_;
};

struct Cut {
  uint32_t plane;
  std::vector<uint64_t> beyond, unsure;
  std::vector<double> value, distance;
};

// By the definition: planes one after another, the nearest first.
Cut cut_of(const Vertices &vertices, const PlaneArrays &planes, uint32_t plane_count, const CutMargins &margins) {
  const uint32_t count = vertices.count();
  Cut cut{hsp::none_cuts, std::vector<uint64_t>(count / 64 + 1), std::vector<uint64_t>(count / 64 + 1), {}, {}};
  cut.distance.assign(planes.distance, planes.distance + plane_count);
  double most = 0;
  for (uint32_t v = 0; v < count; ++v) most = std::max(most, vertices.squared(v));
  while (cut.plane == hsp::none_cuts) {
    const auto nearest = std::min_element(cut.distance.begin(), cut.distance.end());
    if (*nearest == hsp::done_with) return cut;
    if (most + margins.reach < margins.covered) cut.plane = hsp::is_covered;
    if (cut.plane == hsp::is_covered || *nearest > most + margins.reach) return cut;
    const auto plane = static_cast<uint32_t>(nearest - cut.distance.begin());
    *nearest = hsp::done_with;
    cut.value.clear();
    for (uint32_t v = 0; v < count; ++v) {
      cut.value.push_back(vertices.value_at(v, planes.x[plane], planes.y[plane], planes.z[plane], planes.h[plane]));
      if (cut.value[v] > -margins.side) cut.plane = plane;
    }
  }
  for (uint32_t v = 0; v < cut.value.size(); ++v) {
    if (cut.value[v] > margins.side) {
      cut.beyond[v / 64] |= bit(v % 64);
    } else if (cut.value[v] > -margins.side) {
      cut.unsure[v / 64] |= bit(v % 64);
    }
  }
  return cut;
}

TEST(WideCells, FindCutAndCompareSquares) {
  oracle::RandomSource random(1);
  uint32_t none = 0, covered = 0, beyond = 0, unsure = 0, later = 0, without_end = 0, few = 0;
  for (int round = 0; round < 3000; ++round) {
    Vertices vertices(random, 2 * static_cast<uint32_t>(random.in(2, random.one_in(2) ? 8 : 80)));
    const uint32_t count = vertices.count(), plane_count = static_cast<uint32_t>(random.in(1, 30));
    Numbers x(random, plane_count, 16), y(random, plane_count, 16), z(random, plane_count, 16);
    Numbers h(random, plane_count, 80), distance(random, plane_count, 200);
    for (uint32_t k = 0; k < plane_count + 7; ++k) {
      if (k >= plane_count || random.one_in(3)) distance.data()[k] = hsp::done_with;
    }
    PlaneOrder order{};
    uint32_t nearest[hsp::most_ordered];
    const PlaneArrays planes{x.data(), y.data(), z.data(), h.data(), distance.data(), nearest, &order};
    // Positions may be in so much doubt that no plane is too far.
    const double much = std::numeric_limits<double>::infinity();
    const CutMargins margins{static_cast<double>(random.in(0, 8)) / 8,
                             random.one_in(9)   ? much
                             : random.one_in(2) ? 1.0
                                                : 0.0,
                             random.one_in(6) ? 24.0 : -1.0};
    const Cut expected = cut_of(vertices, planes, plane_count, margins);
    const auto distances = std::vector<double>(distance.data(), distance.data() + plane_count);
    few += plane_count <= hsp::most_ordered ? 1U : 0U;
    const auto check = [&](const auto &find) {
      std::vector<uint64_t> beyond_bits(count / 64 + 1), unsure_bits(count / 64 + 1);
      std::copy(distances.begin(), distances.end(), distance.data());
      hsp::order_planes<2>(planes, plane_count);
      const uint32_t plane = find({vertices.arrays(), beyond_bits.data(), unsure_bits.data(), count});
      ASSERT_EQ(plane, expected.plane);
      for (uint32_t k = 0; k < plane_count; ++k) ASSERT_EQ(distance[k], expected.distance[k]);
      if (plane >= hsp::is_covered) return;
      ASSERT_EQ(beyond_bits, expected.beyond);
      ASSERT_EQ(unsure_bits, expected.unsure);
      for (uint32_t v = 0; v < count; ++v) ASSERT_EQ(vertices.value(v), expected.value[v]);
    };
    ASSERT_NO_FATAL_FAILURE(
        check([&](const CutVertices &cut) { return hsp::find_cut_in_lanes<1>(cut, planes, plane_count, margins); }));
    ASSERT_NO_FATAL_FAILURE(
        check([&](const CutVertices &cut) { return hsp::find_cut_in_lanes<2>(cut, planes, plane_count, margins); }));
    const uint32_t some = count < 64 ? count : 64;
    const double limit = static_cast<double>(random.in(0, 25)), margin = static_cast<double>(random.in(0, 16)) / 8;
    SquareSides sides{0, 0};
    for (uint32_t v = 0; v < some; ++v) {
      if (vertices.squared(v) - limit > margin) sides.above |= bit(v);
      if (std::fabs(vertices.squared(v) - limit) <= margin) sides.unsure |= bit(v);
    }
    const auto check_sides = [&](const SquareSides &found) {
      ASSERT_EQ(found.above, sides.above);
      ASSERT_EQ(found.unsure, sides.unsure);
    };
    ASSERT_NO_FATAL_FAILURE(
        check_sides(hsp::compare_squares_in_lanes<1>(vertices.arrays().squared, some, limit, margin)));
    ASSERT_NO_FATAL_FAILURE(
        check_sides(hsp::compare_squares_in_lanes<2>(vertices.arrays().squared, some, limit, margin)));
    for (const hsp::Target target : runnable_targets()) {
      ASSERT_NO_FATAL_FAILURE(
          check([&](const CutVertices &cut) { return hsp::find_cut(target, cut, planes, plane_count, margins); }));
      ASSERT_NO_FATAL_FAILURE(
          check_sides(hsp::compare_squares(target, vertices.arrays().squared, some, limit, margin)));
    }
    none += expected.plane == hsp::none_cuts ? 1U : 0U;
    covered += expected.plane == hsp::is_covered ? 1U : 0U;
    without_end += expected.plane == hsp::none_cuts && margins.reach == much ? 1U : 0U;
    beyond += expected.beyond[0] != 0 ? 1U : 0U;
    unsure += expected.unsure[0] != 0 ? 1U : 0U;
    later += expected.beyond[0] == 0 && expected.beyond.back() != 0 ? 1U : 0U;
  }
  EXPECT_GT(few, 1000U);
  EXPECT_LT(few, 2900U);
  EXPECT_GT(none, 50U);
  EXPECT_GT(covered, 30U);
  EXPECT_GT(without_end, 10U);
  EXPECT_GT(beyond, 500U);
  EXPECT_GT(unsure, 200U);
  EXPECT_GT(later, 5U);
}

TEST(WideCells, CompareEdges) {
  oracle::RandomSource random(4);
  uint32_t outside = 0, unsure = 0, inside = 0;
  for (int round = 0; round < 2000; ++round) {
    Vertices vertices(random, static_cast<uint32_t>(random.in(4, 40)));
    const uint32_t last = vertices.count() - 1;
    std::vector<EdgeEnds> edges;
    for (int64_t edge = random.in(1, random.one_in(2) ? 12 : 64); edge > 0; --edge) {
      const auto end = [&] { return static_cast<uint32_t>(4 * random.in(0, last) + random.in(0, 2)); };
      edges.push_back({end(), end()});
    }
    const uint32_t count = static_cast<uint32_t>(edges.size());
    edges.resize(count + hsp::edges_behind, {0, 0});
    const double limit = static_cast<double>(random.in(0, 25)), error = static_cast<double>(random.in(0, 8)) / 8;
    // The nearest point of the segment to a centre at these distances from its ends, times its length.
    EdgeSides expected{0, 0};
    for (uint32_t k = 0; k < count; ++k) {
      const uint32_t v = edges[k].from / 4, w = edges[k].to / 4;
      const double length = vertices.squared_length(v, w), from = vertices.squared(v);
      const double middle = 0.5 * (from - vertices.squared(w) + length);
      double excess = (from - limit) * length;
      if (middle > 0.0 && middle < length) excess -= middle * middle;
      if (middle > 0.0 && middle >= length) excess = (vertices.squared(w) - limit) * length;
      if (excess > error * length) expected.outside |= bit(k);
      if (std::fabs(excess) <= error * length) expected.unsure |= bit(k);
    }
    const auto check = [&](const EdgeSides &found) {
      ASSERT_EQ(found.outside, expected.outside);
      ASSERT_EQ(found.unsure, expected.unsure);
    };
    const VertexArrays arrays = vertices.arrays();
    ASSERT_NO_FATAL_FAILURE(check(hsp::compare_edges_in_lanes<1>(arrays, edges.data(), count, limit, error)));
    ASSERT_NO_FATAL_FAILURE(check(hsp::compare_edges_in_lanes<2>(arrays, edges.data(), count, limit, error)));
    for (const hsp::Target target : runnable_targets()) {
      ASSERT_NO_FATAL_FAILURE(check(hsp::compare_edges(target, arrays, edges.data(), count, limit, error)));
    }
    outside += expected.outside != 0 ? 1U : 0U;
    unsure += expected.unsure != 0 ? 1U : 0U;
    inside += (expected.outside | expected.unsure) == 0 ? 1U : 0U;
  }
  EXPECT_GT(outside, 500U);
  EXPECT_GT(unsure, 200U);
  EXPECT_GT(inside, 50U);
}

// Numbers of all vertices, with room for new ones and for what is read behind the last edge.
struct Corners {
  std::vector<double> x, y, z, error, squared, value;
  VertexArrays arrays() { return {x.data(), y.data(), z.data(), error.data(), squared.data(), value.data()}; }
  bool operator==(const Corners &) const = default;
};

// A new vertex on every edge, one after another.
void cross_one_by_one(Corners &corners, const std::vector<CrossedEdge> &edges, const std::vector<uint32_t> &to,
                      uint32_t count, const CrossingBounds &bounds) {
  const Corners before = corners;
  const auto position = [&](uint32_t v) { return Vec3{before.x[v], before.y[v], before.z[v]}; };
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t v = edges[k].near / 4, w = edges[k].gone, made = to[k];
    const double rise = before.value[w] - before.value[v], error = std::max(before.error[v], before.error[w]);
    const Vec3 edge = position(w) - position(v), at = position(v) + (-before.value[v] * (1.0 / rise)) * edge;
    const double length = std::fabs(edge.x) + std::fabs(edge.y) + std::fabs(edge.z);
    const double sum = error + bounds.rounding + (1.01 * (error + bounds.plane_error)) * (length * (1.0 / rise));
    corners.x[made] = at.x;
    corners.y[made] = at.y;
    corners.z[made] = at.z;
    corners.error[made] = rise > bounds.least_rise && sum < bounds.most_error ? sum : hsp::no_certainty;
    corners.squared[made] = dot(at - bounds.centre, at - bounds.centre);
  }
}

TEST(WideCells, CrossEdges) {
  oracle::RandomSource random(5);
  uint32_t known = 0, steep = 0, doubtful = 0;
  for (int round = 0; round < 1000; ++round) {
    const auto number = [&](int64_t most) { return static_cast<double>(random.in(-most, most)) / 8; };
    const uint32_t vertices = static_cast<uint32_t>(random.in(4, 40)), count = static_cast<uint32_t>(random.in(1, 20));
    Corners corners;
    for (std::vector<double> *numbers : {&corners.x, &corners.y, &corners.z, &corners.squared, &corners.value}) {
      for (uint32_t v = 0; v < vertices + count + 1; ++v) numbers->push_back(number(80));
    }
    for (uint32_t v = 0; v < vertices + count + 1; ++v) corners.error.push_back(std::fabs(number(4)));
    const CrossingBounds bounds{{number(9), number(9), number(9)}, 0.5, 4.0, 0.125, 0.25};
    std::vector<CrossedEdge> edges;
    std::vector<uint32_t> to;
    for (uint32_t k = 0; k < count; ++k) {
      const uint32_t near = static_cast<uint32_t>(random.in(0, vertices - 1));
      const uint32_t gone = (near + static_cast<uint32_t>(random.in(1, vertices - 1))) % vertices;
      corners.value[near] = -std::fabs(corners.value[near]) - 0.125;
      edges.push_back({gone, 4 * near + static_cast<uint32_t>(random.in(0, 2)), 0, 0});
      to.push_back(vertices + k);
    }
    for (const CrossedEdge &edge : edges) {
      if (corners.value[edge.gone] == corners.value[edge.near / 4]) corners.value[edge.gone] += 0.125;
    }
    if (random.one_in(2)) to.back() = edges.back().gone;  // whose place it takes
    edges.resize(count + hsp::crossings_behind, {0, 0, 0, 0});
    to.resize(count + hsp::crossings_behind, vertices + count);
    Corners expected = corners;
    cross_one_by_one(expected, edges, to, count, bounds);
    const auto check = [&](const auto &cross) {
      Corners found = corners;
      cross(found.arrays(), edges.data(), to.data(), count, bounds);
      for (std::vector<double> Corners::*of :
           {&Corners::x, &Corners::y, &Corners::z, &Corners::error, &Corners::squared, &Corners::value}) {
        (found.*of).back() = (expected.*of).back();  // may be written
      }
      ASSERT_EQ(found, expected);
    };
    ASSERT_NO_FATAL_FAILURE(check(hsp::cross_edges_in_lanes<1>));
    ASSERT_NO_FATAL_FAILURE(check(hsp::cross_edges_in_lanes<2>));
    for (const hsp::Target target : runnable_targets()) {
      ASSERT_NO_FATAL_FAILURE(check([target](auto &&...all) { hsp::cross_edges(target, all...); }));
    }
    for (uint32_t k = 0; k < count; ++k) {
      const double rise = corners.value[edges[k].gone] - corners.value[edges[k].near / 4];
      known += expected.error[to[k]] < 4.0 ? 1U : 0U;
      steep += rise <= 0.5 ? 1U : 0U;
      doubtful += rise > 0.5 && expected.error[to[k]] >= 4.0 ? 1U : 0U;
    }
  }
  EXPECT_GT(known, 500U);
  EXPECT_GT(steep, 100U);
  EXPECT_GT(doubtful, 100U);
}

TEST(WideCells, CompareFacets) {
  oracle::RandomSource random(2);
  uint32_t apart = 0, inside = 0, reached = 0;
  for (int round = 0; round < 3000; ++round) {
    const uint32_t count = static_cast<uint32_t>(random.in(1, random.one_in(2) ? 6 : 64));
    const int64_t away = random.in(0, 30);
    const Numbers u(random, count, 4 + away), w(random, count, 4 + away);
    std::vector<FlatLine> lines;
    for (int64_t line = random.in(1, 5); line > 0; --line) {
      lines.push_back({static_cast<float>(random.in(-2, 2)), static_cast<float>(random.in(-2, 2)),
                       static_cast<float>(random.in(-2, 4))});
    }
    const double margin = static_cast<double>(random.in(0, 2)) / 8;
    FacetSides expected{~uint64_t{0} >> (64 - count), false, true};
    for (const FlatLine &line : lines) {
      uint32_t beyond = 0, near = 0;
      for (uint32_t k = 0; k < count; ++k) {
        const double value = double{line.u} * u[k] + double{line.w} * w[k] - double{line.h};
        if (!(value < -margin)) expected.inside &= ~bit(k);
        beyond += value > margin ? 1 : 0;
        near += value < -margin ? 1 : 0;
      }
      expected.reached = expected.reached && near > 0;
      expected.apart = expected.apart || beyond == count;
    }
    if (expected.apart) expected = {0, true, false};
    const auto check = [&](const FacetSides &found) {
      ASSERT_EQ(found.inside, expected.inside);
      ASSERT_EQ(found.apart, expected.apart);
      ASSERT_EQ(found.reached, expected.reached);
    };
    const uint32_t line_count = static_cast<uint32_t>(lines.size());
    ASSERT_NO_FATAL_FAILURE(
        check(hsp::compare_facets_in_lanes<1>(u.data(), w.data(), count, lines.data(), line_count, margin)));
    ASSERT_NO_FATAL_FAILURE(
        check(hsp::compare_facets_in_lanes<2>(u.data(), w.data(), count, lines.data(), line_count, margin)));
    for (const hsp::Target target : runnable_targets()) {
      ASSERT_NO_FATAL_FAILURE(
          check(hsp::compare_facets(target, u.data(), w.data(), count, lines.data(), line_count, margin)));
    }
    apart += expected.apart ? 1U : 0U;
    inside += expected.inside != 0 ? 1U : 0U;
    reached += expected.reached && expected.inside == 0 ? 1U : 0U;
  }
  EXPECT_GT(reached, 50U);
  EXPECT_GT(apart, 100U);
  EXPECT_GT(inside, 100U);
}

TEST(WideCells, FindPlanesAndDominance) {
  oracle::RandomSource random(3);
  uint32_t near = 0, dominant = 0, concentric = 0, before = 0, not_before = 0;
  for (int round = 0; round < 1000; ++round) {
    const uint32_t count = static_cast<uint32_t>(random.in(1, random.one_in(2) ? 12 : 150));
    const Numbers x(random, count, 9), y(random, count, 9), z(random, count, 9);
    const Numbers radius(random, count, 30), power(random, count, 400);
    Numbers not_discarded(random, count, 0);
    for (uint32_t k = 0; k < count + 7; ++k) not_discarded.data()[k] = k < count && !random.one_in(4) ? 1 : 0;
    const MemberArrays members{x.data(), y.data(), z.data(), radius.data(), power.data(), not_discarded.data(), count};
    const uint32_t own = static_cast<uint32_t>(random.in(0, count - 1));
    const hsp::MemberBall own_ball{x[own], y[own], z[own], radius[own], power[own]};
    const double limit = static_cast<double>(random.in(-4, 60)) / 8;
    const auto centre = [&](uint32_t k) { return hsp::Vec3{x[k], y[k], z[k]}; };
    // Its distance, infinite if it does not count, and its plane.
    std::vector<std::pair<double, UnitPlane>> expected;
    for (uint32_t k = 0; k < count; ++k) {
      const hsp::Vec3 v = centre(k) - centre(own);
      const double h = dot(v, v) - (radius[k] - radius[own]) * (radius[k] + radius[own]);
      const double distance = h * std::fabs(h) / dot(v, v);
      const bool counts = k != own && not_discarded[k] > 0 && distance <= limit;
      near += counts ? 1 : 0;
      expected.push_back({counts ? distance : hsp::done_with,
                          hsp::CubeFrame::between(centre(own), radius[own], centre(k), radius[k])});
    }
    Numbers px(random, count, 1), py(random, count, 1), pz(random, count, 1), ph(random, count, 1),
        pd(random, count, 1);
    PlaneOrder order{};
    uint32_t nearest[hsp::most_ordered];
    const PlaneArrays planes{px.data(), py.data(), pz.data(), ph.data(), pd.data(), nearest, &order};
    const auto check = [&] {
      for (uint32_t k = 0; k < count; ++k) {
        const auto &[distance, plane] = expected[k];
        ASSERT_EQ(pd[k], distance);
        if (std::isinf(distance)) continue;  // done with, or of two balls with one centre
        ASSERT_TRUE(px[k] == plane.v.x && py[k] == plane.v.y && pz[k] == plane.v.z && ph[k] == plane.h);
      }
      ASSERT_EQ(order.next, 0U);
      ASSERT_EQ(order.count, count <= hsp::most_ordered ? count : 0);
      std::vector<uint32_t> sorted(order.count);
      std::iota(sorted.begin(), sorted.end(), 0U);
      std::stable_sort(sorted.begin(), sorted.end(),
                       [&](uint32_t a, uint32_t b) { return expected[a].first < expected[b].first; });
      ASSERT_TRUE(std::equal(sorted.begin(), sorted.end(), nearest));
    };
    hsp::find_planes_in_lanes<1>(members, own_ball, limit, planes);
    ASSERT_NO_FATAL_FAILURE(check());
    hsp::find_planes_in_lanes<2>(members, own_ball, limit, planes);
    ASSERT_NO_FATAL_FAILURE(check());

    const hsp::Vec3 point = 0.25 * centre(static_cast<uint32_t>(random.in(0, count - 1)));
    const double least = static_cast<double>(random.in(-400, 40)) / 8;
    bool is_before = true;
    for (uint32_t k = 0; k < count; ++k) {
      const bool is_less = power[k] - power[own] - dot(centre(k) - centre(own), point) > least;
      is_before = is_before && (is_less || pd[k] == hsp::done_with);
    }
    ++(is_before ? before : not_before);
    for (uint32_t k = count; k < count + 7; ++k) pd.data()[k] = hsp::done_with;
    EXPECT_EQ(hsp::is_before_all_in_lanes<1>(members, own_ball, point, least, pd.data()), is_before);
    EXPECT_EQ(hsp::is_before_all_in_lanes<2>(members, own_ball, point, least, pd.data()), is_before);

    const uint32_t first = static_cast<uint32_t>(random.in(0, count - 1));
    const double side = static_cast<double>(random.in(1, 8)), error = static_cast<double>(random.in(0, 2)) / 8;
    uint64_t dominance = 0;
    for (uint32_t k = first; k < count && k < first + 64; ++k) {
      const double spread = side * (std::fabs(x[k] - x[own]) + std::fabs(y[k] - y[own]) + std::fabs(z[k] - z[own]));
      if (std::fabs(power[k] - power[own]) > spread + error || spread == 0) dominance |= bit(k - first);
      concentric += spread == 0 && k != own ? 1U : 0U;
    }
    dominant += dominance != 0 ? 1U : 0U;
    EXPECT_EQ(hsp::find_dominance_in_lanes<1>(members, own, first, side, error), dominance);
    EXPECT_EQ(hsp::find_dominance_in_lanes<2>(members, own, first, side, error), dominance);
    for (const hsp::Target target : runnable_targets()) {
      hsp::find_planes(target, members, own_ball, limit, planes);
      ASSERT_NO_FATAL_FAILURE(check());
      EXPECT_EQ(hsp::is_before_all(target, members, own_ball, point, least, pd.data()), is_before);
      EXPECT_EQ(hsp::find_dominance(target, members, own, first, side, error), dominance);
    }
  }
  EXPECT_GT(near, 1000U);
  EXPECT_GT(before, 50U);
  EXPECT_GT(not_before, 50U);
  EXPECT_GT(dominant, 100U);
  EXPECT_GT(concentric, 0U);
}

}  // namespace
