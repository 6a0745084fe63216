// Which balls meet which cubes, by looking at all of them, and where the empty cubes between them belong.
#include "cells/cube_cover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "built_free_space.hpp"
#include "random_balls.hpp"

namespace {

using hsp::CubeCoordinates;
using hsp::no_id;
using oracle::Balls;

bool meets(const hsp::exact::LatticeBall &ball, const CubeCoordinates &cube, int64_t side) {
  const auto gap = [&](int64_t c, int64_t k) {
    const int64_t nearest = std::clamp(c, k * side, k * side + side);
    return oracle::Int128{nearest - c} * (nearest - c);
  };
  const auto distance = gap(ball.centre.x, cube.x) + gap(ball.centre.y, cube.y) + gap(ball.centre.z, cube.z);
  return distance <= oracle::Int128{ball.radius} * ball.radius;
}

struct Box {
  CubeCoordinates low{0, 0, 0}, high{0, 0, 0};
  template <class Visit>
  void for_each(Visit visit) const {
    for (int64_t z = low.z; z <= high.z; ++z) {
      for (int64_t y = low.y; y <= high.y; ++y) {
        for (int64_t x = low.x; x <= high.x; ++x) visit(CubeCoordinates{x, y, z});
      }
    }
  }
};

void check(const Balls &balls, uint32_t &empty_seen) {
  const BuiltFreeSpace built(balls);
  const hsp::CubeCover &cover = built.space().cover;
  const hsp::EmptyRuns &runs = built.space().runs;
  const int64_t side = built.grid().side();
  Box box;
  for (uint32_t k = 0; k < cover.cubes(); ++k) {
    const CubeCoordinates &cube = cover.cube(k);
    if (k == 0) box = {cube, cube};
    box.low = {std::min(box.low.x, cube.x), std::min(box.low.y, cube.y), std::min(box.low.z, cube.z)};
    box.high = {std::max(box.high.x, cube.x), std::max(box.high.y, cube.y), std::max(box.high.z, cube.z)};
  }
  box.low = {box.low.x - 2, box.low.y - 2, box.low.z - 2};
  box.high = {box.high.x + 2, box.high.y + 2, box.high.z + 2};
  if ((box.high.x - box.low.x) * (box.high.y - box.low.y) * (box.high.z - box.low.z) > 20000) return;

  uint32_t entries = 0, met = 0;
  std::set<uint32_t> found;
  std::set<std::pair<uint32_t, uint32_t>> contacts;
  box.for_each([&](const CubeCoordinates &cube) {
    std::vector<uint32_t> expected;
    for (uint32_t i = 0; i < built.balls().n; ++i) {
      if (meets(built.balls().ball(i), cube, side)) expected.push_back(i);
    }
    const uint32_t k = cover.find(cube);
    ASSERT_EQ(k == no_id, expected.empty());
    if (k != no_id) {
      ASSERT_EQ(std::vector<uint32_t>(cover.balls(k).begin(), cover.balls(k).end()), expected);
      entries += static_cast<uint32_t>(expected.size());
      ++met;
      return;
    }
    ++empty_seen;
    const uint32_t run = runs.find(cover, cube);
    ASSERT_LT(run, runs.count());
    found.insert(run);
    for (const CubeCoordinates &next :
         {CubeCoordinates{cube.x + 1, cube.y, cube.z}, CubeCoordinates{cube.x, cube.y + 1, cube.z},
          CubeCoordinates{cube.x, cube.y, cube.z + 1}}) {
      if (cover.find(next) != no_id) continue;
      const uint32_t other = runs.find(cover, next);
      if (other != run) contacts.insert({std::min(run, other), std::max(run, other)});
    }
  });
  std::map<uint32_t, Box> boxes;
  runs.for_each_run(cover, [&](uint32_t run, const CubeCoordinates &from, const CubeCoordinates &to) {
    EXPECT_TRUE(boxes.insert({run, {from, {to.x - 1, to.y - 1, to.z - 1}}}).second);
  });
  ASSERT_EQ(boxes.size(), runs.count());
  box.for_each([&](const CubeCoordinates &cube) {
    uint32_t holding = 0;
    for (const auto &[run, held] : boxes) {
      if (held.low.x > cube.x || held.high.x < cube.x || held.low.y > cube.y || held.high.y < cube.y ||
          held.low.z > cube.z || held.high.z < cube.z) {
        continue;
      }
      ++holding;
      ASSERT_EQ(cover.find(cube), no_id);
      ASSERT_EQ(runs.find(cover, cube), run);
    }
    ASSERT_EQ(holding, cover.find(cube) == no_id ? 1U : 0U);
  });
  ASSERT_EQ(entries, cover.entries());
  ASSERT_EQ(met, cover.cubes());
  ASSERT_EQ(found.size(), runs.count());
  ASSERT_EQ(runs.find(cover, {0, 0, box.low.z - 1000}), 0U);
  std::set<std::pair<uint32_t, uint32_t>> listed;
  uint32_t calls = 0;
  runs.for_each_contact(cover, [&](uint32_t a, uint32_t b) {
    listed.insert({std::min(a, b), std::max(a, b)});
    ++calls;
  });
  ASSERT_EQ(listed, contacts);
  ASSERT_EQ(calls, listed.size());
}

// Around every ball: the set is too wide for all cubes of the box.
TEST(CubeCover, OfCollidingCubes) {
  oracle::RandomSource random(2);
  for (int time = 0; time < 4; ++time) {
    const BuiltFreeSpace built(oracle::colliding_balls(random, 200));
    const hsp::CubeCover &cover = built.space().cover;
    const int64_t side = built.grid().side();
    for (uint32_t i = 0; i < built.balls().n; ++i) {
      const CubeCoordinates at = built.grid().cube_at(built.balls().ball(i).centre);
      const Box box{{at.x - 1, at.y - 1, at.z - 1}, {at.x + 1, at.y + 1, at.z + 1}};
      box.for_each([&](const CubeCoordinates &cube) {
        std::vector<uint32_t> expected;
        for (uint32_t j = 0; j < built.balls().n; ++j) {
          if (meets(built.balls().ball(j), cube, side)) expected.push_back(j);
        }
        const uint32_t k = cover.find(cube);
        ASSERT_EQ(k == no_id, expected.empty());
        if (k == no_id) return;
        ASSERT_EQ(std::vector<uint32_t>(cover.balls(k).begin(), cover.balls(k).end()), expected);
      });
    }
  }
}

TEST(CubeCover, IsThatOfAllPairs) {
  oracle::RandomSource random(1);
  uint32_t empty = 0;
  for (int k = 0; k < 150; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(0, 12)));
    ASSERT_NO_FATAL_FAILURE(check(balls, empty)) << oracle::to_text(balls);
  }
  // Far apart: rows and layers without balls.
  for (int k = 0; k < 60; ++k) {
    Balls balls;
    const int64_t n = random.in(1, 8);
    for (int64_t i = 0; i < n; ++i) {
      const int64_t x = random.in(-30, 30), y = random.in(-30, 30), z = random.in(-30, 30);
      balls.push_back({x, y, z, random.in(1, 3)});
    }
    ASSERT_NO_FATAL_FAILURE(check(balls, empty)) << oracle::to_text(balls);
  }
  EXPECT_GT(empty, 10000U);
}

}  // namespace
