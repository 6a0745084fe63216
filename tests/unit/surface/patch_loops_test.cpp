// Chains of borders; loops that bound one piece or two, and what they measure: in every width the same.
#include "surface/patch_loops.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "built_creases.hpp"
#include "core/elementary.hpp"
#include "surface/cut_patches.hpp"
#include "sweep_length.hpp"
#include "tied_families.hpp"

namespace {

using hsp::BorderArc;
using hsp::no_id;

BorderArc arc(uint32_t start, uint32_t end) {
  return {0, start, end, no_id, no_id, no_id, {}, {}};
}

// One large ball beside a vertex without anything else to say.
const BuiltSurface &three_balls() {
  static const BuiltSurface *const built = [] {
    support::BallList list;
    list.add(0, 0, 0, 1.0);
    list.add(2.5, 0, 0, 1.0);
    list.add(1.25, 2.165, 0, 1.0);
    return new BuiltSurface(list, 1.0, 1e-6);
  }();
  return *built;
}

bool chains(std::vector<BorderArc> &arcs) {
  const hsp::ActualBalls actual(three_balls().balls(), three_balls().boundary());
  return hsp::PatchLoops(actual, 0, {arcs.data(), static_cast<uint32_t>(arcs.size())}).chain();
}

TEST(PatchLoops, Chains) {
  std::vector<BorderArc> arcs = {arc(1, 2), arc(5, 6), arc(3, 1), arc(6, 5), arc(no_id, no_id), arc(2, 3)};
  ASSERT_TRUE(chains(arcs));
  const uint32_t next[] = {5, 3, 0, 1, 4, 2}, loop[] = {0, 1, 0, 1, 4, 0};
  for (uint32_t k = 0; k < 6; ++k) {
    EXPECT_EQ(arcs[k].next, next[k]);
    EXPECT_EQ(arcs[k].loop, loop[k]);
  }
}

TEST(PatchLoops, WhatDoesNotClose) {
  std::vector<BorderArc> open = {arc(1, 2), arc(2, 3)};
  EXPECT_FALSE(chains(open));
  std::vector<BorderArc> forked = {arc(1, 2), arc(2, 1), arc(2, 1)};
  EXPECT_FALSE(chains(forked));
  std::vector<BorderArc> joined = {arc(1, 2), arc(3, 2), arc(2, 1)};
  EXPECT_FALSE(chains(joined));
}

struct Groups {
  uint32_t several = 0, holes = 0;
};
// Sizes of loops tell which bound one piece, and so do ways between them, which are asked where sizes say nothing.
void group_in_both_ways(const support::TiedSet &set, Groups &groups) {
  const BuiltSurface built(set.balls, set.probe, 0.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  BuiltCreases creases(built);
  ASSERT_EQ(creases.status(), hsp::Status::ok);
  for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
    SCOPED_TRACE(v);
    const hsp::Span<BorderArc> arcs = creases.border(v);
    hsp::PatchLoops loops(creases.actual(), v, arcs);
    std::vector<hsp::ArcFigures> figures(arcs.size());
    ASSERT_TRUE(loops.chain());
    bool is_group = false;
    for (uint32_t k = 0; k < arcs.size(); ++k) {
      ASSERT_TRUE(loops.measure(k, figures[k]));
      is_group = is_group || arcs[k].loop != arcs[0].loop;
    }
    if (!is_group) continue;
    const hsp::Span<const hsp::ArcFigures> known(figures.data(), arcs.size());
    ASSERT_TRUE(loops.group(known));
    std::vector<uint32_t> piece(arcs.size());
    for (uint32_t k = 0; k < arcs.size(); ++k) piece[k] = arcs[k].piece;
    // A loop of a half sphere. Ways between points that are infinitely near each other may not be decided.
    figures[0].exterior += loops.steradians(0, known) - 2 * hsp::pi;
    if (!loops.group(known)) continue;
    ++groups.several;
    for (uint32_t k = 0; k < arcs.size(); ++k) {
      for (uint32_t j = 0; j < k; ++j) {
        EXPECT_EQ(piece[j] == piece[k], arcs[j].piece == arcs[k].piece);
        if (arcs[k].loop != arcs[j].loop && piece[k] == piece[j]) ++groups.holes;
      }
    }
  }
}

TEST(PatchLoops, GroupAlikeBySizeAndByCrossings) {
  Groups groups;
  for (const support::TiedFamily &family : support::tied_families) {
    SCOPED_TRACE(family.name);
    for (int seed = 0; seed < oracle::rounds(2, 40) && !testing::Test::HasFailure(); ++seed) {
      group_in_both_ways(family.member(static_cast<uint64_t>(seed)), groups);
    }
  }
  EXPECT_GT(groups.several, 20U);
  // Probes on both sides of a triangle meet in a circle, which is a hole in either patch.
  support::TiedSet triangle{{}, 1.0};
  triangle.balls.add(0, 0, 0, 1.0);
  triangle.balls.add(3.3, 0, 0, 1.0);
  triangle.balls.add(1.65, 2.858, 0, 1.0);
  group_in_both_ways(triangle, groups);
  EXPECT_GT(groups.holes, 0U);
}

// A side of a triangle that nothing cuts: a part of a great circle between two balls' directions.
TEST(PatchLoops, MeasuresSides) {
  const BuiltSurface &built = three_balls();
  const hsp::ActualBalls actual(built.balls(), built.boundary());
  ASSERT_GT(built.boundary().vertex_count(), 0U);
  const hsp::VertexRecord &record = built.boundary().vertex(0);
  std::vector<BorderArc> arcs;
  for (uint32_t slot = 0; slot < 3; ++slot) {
    const hsp::SideOfPatch side = hsp::side_of_patch(record, slot);
    const auto towards = [&](uint32_t of) {
      return hsp::BorderPoint{hsp::BorderPoint::Kind::towards_ball, 0, {0, record.ball[of], no_id}};
    };
    arcs.push_back({hsp::PatchArc::side(slot), side.second, side.first, no_id, no_id, no_id, towards(side.second),
                    towards(side.first)});
  }
  hsp::PatchLoops loops(actual, 0, {arcs.data(), 3});
  ASSERT_TRUE(loops.chain());
  // The angle between two centres 2.5 apart, seen from a distance of 2, and by l'Huilier's theorem the triangle's area.
  const double side = 2 * std::asin(1.25 / 2);
  std::vector<hsp::ArcFigures> all(3);
  for (uint32_t k = 0; k < 3; ++k) {
    hsp::ArcFigures &figures = all[k];
    ASSERT_TRUE(loops.measure(k, figures));
    EXPECT_NEAR(figures.angle, side, 1e-3);
    EXPECT_EQ(figures.height, 0.0);
    EXPECT_NEAR(dot(figures.axis, figures.axis), 1.0, 1e-12);
    EXPECT_NEAR(dot(figures.chord, figures.chord), 1.25 * 1.25, 1e-3);
    EXPECT_GT(figures.exterior, 0.0);
  }
  const hsp::Span<const hsp::ArcFigures> figures(all.data(), 3);
  ASSERT_TRUE(loops.group(figures));
  const double area = loops.steradians(0, figures);
  const double t = std::tan(side * 3 / 4), u = std::tan(side / 4);
  EXPECT_NEAR(area, 4 * std::atan(std::sqrt(t * u * u * u)), 1e-3);
}

}  // namespace
