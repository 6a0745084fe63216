// The kernels of vertex_sides.hpp and cube_members.hpp for registers of every width, held against plain loops.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "cells/cube_members.hpp"
#include "cells/vertex_sides.hpp"
#include "core/processor.hpp"
#include "random_balls.hpp"

namespace {

using hsp::FacetSides;
using hsp::FlatLine;
using hsp::MemberArrays;
using hsp::PlaneCandidate;
using hsp::PlaneNumbers;
using hsp::PointValues;
using hsp::VertexSides;

// Multiples of 1/8, so that sums and products are exact and some values are equal to the margin.
class Numbers {
 public:
  Numbers(oracle::RandomSource &random, uint32_t count, int64_t most) {
    for (uint32_t k = 0; k < count; ++k) values_.push_back(static_cast<double>(random.in(-most, most)) / 8);
    values_.resize(count + 3, 1e9);  // what is behind the last one must have no effect
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

TEST(WideCells, FindSidesOfVertices) {
  oracle::RandomSource random(1);
  uint32_t beyond = 0, unsure = 0, nothing = 0;
  for (int round = 0; round < 3000; ++round) {
    const uint32_t count = static_cast<uint32_t>(random.in(1, 64));
    const Numbers x(random, count, 20), y(random, count, 20), z(random, count, 20);
    Numbers value(random, count, 1);
    const PlaneNumbers plane{static_cast<double>(random.in(-2, 2)), static_cast<double>(random.in(-2, 2)),
                             static_cast<double>(random.in(-2, 2)), static_cast<double>(random.in(-1, 12))};
    const double margin = static_cast<double>(random.in(0, 2)) / 8;
    VertexSides expected{0, 0};
    std::vector<double> values;
    for (uint32_t k = 0; k < count; ++k) {
      values.push_back(plane.x * x[k] + plane.y * y[k] + plane.z * z[k] - plane.h);
      if (values[k] > margin) expected.beyond |= bit(k);
      if (values[k] > -margin && values[k] <= margin) expected.unsure |= bit(k);
    }
    const auto check = [&](const VertexSides &found) {
      ASSERT_EQ(found.beyond, expected.beyond);
      ASSERT_EQ(found.unsure, expected.unsure);
      for (uint32_t k = 0; k < count; ++k) ASSERT_EQ(value[k], values[k]);
    };
    const PointValues points{x.data(), y.data(), z.data(), value.data()};
    ASSERT_NO_FATAL_FAILURE(check(hsp::find_sides<1>(points, count, plane, margin)));
    ASSERT_NO_FATAL_FAILURE(check(hsp::find_sides<2>(points, count, plane, margin)));
#if HSP_AVX2
    if (hsp::has_avx2()) {
      ASSERT_NO_FATAL_FAILURE(check(hsp::find_sides_avx2(points, count, plane, margin)));
    }
#endif
    beyond += expected.beyond != 0 ? 1U : 0U;
    unsure += expected.unsure != 0 ? 1U : 0U;
    nothing += (expected.beyond | expected.unsure) == 0 ? 1U : 0U;
  }
  EXPECT_GT(beyond, 500U);
  EXPECT_GT(unsure, 200U);
  EXPECT_GT(nothing, 20U);
}

TEST(WideCells, CompareFacets) {
  oracle::RandomSource random(2);
  uint32_t apart = 0, inside = 0;
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
    FacetSides expected{~uint64_t{0} >> (64 - count), false};
    for (const FlatLine &line : lines) {
      uint32_t beyond = 0;
      for (uint32_t k = 0; k < count; ++k) {
        const double value = double{line.u} * u[k] + double{line.w} * w[k] - double{line.h};
        if (!(value < -margin)) expected.inside &= ~bit(k);
        beyond += value > margin ? 1 : 0;
      }
      expected.apart = expected.apart || beyond == count;
    }
    if (expected.apart) expected.inside = 0;
    const auto check = [&](const FacetSides &found) {
      ASSERT_EQ(found.inside, expected.inside);
      ASSERT_EQ(found.apart, expected.apart);
    };
    const uint32_t line_count = static_cast<uint32_t>(lines.size());
    ASSERT_NO_FATAL_FAILURE(check(hsp::compare_facets<1>(u.data(), w.data(), count, lines.data(), line_count, margin)));
    ASSERT_NO_FATAL_FAILURE(check(hsp::compare_facets<2>(u.data(), w.data(), count, lines.data(), line_count, margin)));
#if HSP_AVX2
    if (hsp::has_avx2()) {
      ASSERT_NO_FATAL_FAILURE(
          check(hsp::compare_facets_avx2(u.data(), w.data(), count, lines.data(), line_count, margin)));
    }
#endif
    apart += expected.apart ? 1U : 0U;
    inside += expected.inside != 0 ? 1U : 0U;
  }
  EXPECT_GT(apart, 100U);
  EXPECT_GT(inside, 100U);
}

TEST(WideCells, ListCandidatesAndFindDominance) {
  oracle::RandomSource random(3);
  uint32_t listed = 0, dominant = 0, concentric = 0;
  for (int round = 0; round < 1000; ++round) {
    const uint32_t count = static_cast<uint32_t>(random.in(1, random.one_in(2) ? 12 : 150));
    const Numbers x(random, count, 9), y(random, count, 9), z(random, count, 9);
    const Numbers radius(random, count, 30), power(random, count, 400);
    const MemberArrays members{x.data(), y.data(), z.data(), radius.data(), power.data(), count};
    const uint32_t own = static_cast<uint32_t>(random.in(0, count - 1));
    std::vector<uint64_t> in_game(count / 64 + 1);
    for (uint32_t k = 0; k < count; ++k) in_game[k / 64] |= random.one_in(4) ? 0 : bit(k % 64);
    const double limit = static_cast<double>(random.in(-4, 60)) / 8;
    std::vector<PlaneCandidate> expected;
    for (uint32_t k = 0; k < count; ++k) {
      const double vx = x[k] - x[own], vy = y[k] - y[own], vz = z[k] - z[own];
      const double length = vx * vx + vy * vy + vz * vz;
      const double h = length + (radius[own] - radius[k]) * (radius[own] + radius[k]);
      if (k == own || (in_game[k / 64] >> k % 64 & 1) == 0 || !(h * std::fabs(h) / length <= limit)) continue;
      expected.push_back({h * std::fabs(h) / length, k});
    }
    std::vector<PlaneCandidate> list(count + 4);
    const auto check = [&](uint32_t found) {
      ASSERT_EQ(found, expected.size());
      for (uint32_t k = 0; k < found; ++k) {
        ASSERT_EQ(list[k].distance, expected[k].distance);
        ASSERT_EQ(list[k].member, expected[k].member);
      }
    };
    ASSERT_NO_FATAL_FAILURE(check(hsp::list_candidates<1>(members, in_game.data(), own, limit, list.data())));
    ASSERT_NO_FATAL_FAILURE(check(hsp::list_candidates<2>(members, in_game.data(), own, limit, list.data())));
    listed += static_cast<uint32_t>(expected.size());

    const uint32_t first = static_cast<uint32_t>(random.in(0, count - 1));
    const double side = static_cast<double>(random.in(1, 8)), doubt = static_cast<double>(random.in(0, 2)) / 8;
    uint64_t dominance = 0;
    for (uint32_t k = first; k < count && k < first + 64; ++k) {
      const double spread = side * (std::fabs(x[k] - x[own]) + std::fabs(y[k] - y[own]) + std::fabs(z[k] - z[own]));
      if (std::fabs(power[k] - power[own]) > spread + doubt || spread == 0) dominance |= bit(k - first);
      concentric += spread == 0 && k != own ? 1U : 0U;
    }
    dominant += dominance != 0 ? 1U : 0U;
    EXPECT_EQ(hsp::find_dominance<1>(members, own, first, side, doubt), dominance);
    EXPECT_EQ(hsp::find_dominance<2>(members, own, first, side, doubt), dominance);
#if HSP_AVX2
    if (hsp::has_avx2()) {
      ASSERT_NO_FATAL_FAILURE(check(hsp::list_candidates_avx2(members, in_game.data(), own, limit, list.data())));
      EXPECT_EQ(hsp::find_dominance_avx2(members, own, first, side, doubt), dominance);
    }
#endif
  }
  EXPECT_GT(listed, 1000U);
  EXPECT_GT(dominant, 100U);
  EXPECT_GT(concentric, 0U);
}

}  // namespace
