// Caps that are dropped in a part of space cover nothing there that others do not, by points of the sphere all over it;
// and where nothing is left, the caps that are named cover all.
#include "sphere/cell_cutting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "bumps.hpp"
#include "indexed_search.hpp"
#include "random_balls.hpp"

namespace {

using Part = hsp::CellCutting::Part;

struct Cutting {
  Cutting(const hsp::Caps &caps, const hsp::CellBox &box, Part part = Part::sphere)
      : state(caps.count, hsp::CapState::waits),
        all(caps.count),
        cell(caps, part, false, {state.data(), caps.count}, box) {
    std::iota(all.begin(), all.end(), 0U);
  }
  hsp::Span<const uint32_t> numbers() const { return {all.data(), static_cast<uint32_t>(all.size())}; }

  std::vector<uint8_t> state;
  std::vector<uint32_t> all;
  hsp::CellCutting cell;
};

double depth(const hsp::Caps &caps, uint32_t k, const hsp::Vec3 &p) {
  return caps.ux[k] * p.x + caps.uy[k] * p.y + caps.uz[k] * p.z - caps.b[k];
}

double part(oracle::RandomSource &random, double least, double most) {
  return least + (most - least) * static_cast<double>(random.in(0, 1000000)) / 1e6;
}

// By points of the sphere, or of the ball, in a box. Returns how many there were.
uint32_t expect_others_to_cover(oracle::RandomSource &random, const hsp::Caps &caps, const hsp::CellBox &box,
                                Cutting &cutting, bool left, Part of = Part::sphere) {
  std::vector<uint32_t> stay(caps.count + 1);
  stay.resize(left ? 0 : cutting.cell.covering({stay.data(), caps.count + 1}));
  for (uint32_t k = 0; k < caps.count && left; ++k) {
    if (cutting.state[k] != hsp::CapState::dropped) stay.push_back(k);
  }
  uint32_t points = 0;
  for (int sample = 0; sample < 400; ++sample) {
    hsp::Vec3 p{part(random, -1, 1), part(random, -1, 1), part(random, -1, 1)};
    if (of == Part::sphere) p = (1 / std::sqrt(dot(p, p))) * p;
    if (std::fabs(p.x - box.x) > box.half || std::fabs(p.y - box.y) > box.half || std::fabs(p.z - box.z) > box.half) {
      continue;
    }
    bool in_all = !left, in_those = false;
    for (uint32_t k = 0; k < caps.count; ++k) in_all = in_all || depth(caps, k, p) > 1e-12;
    for (const uint32_t k : stay) in_those = in_those || depth(caps, k, p) > -1e-12;
    if (in_all) {
      EXPECT_TRUE(in_those);
    }
    ++points;
  }
  return points;
}

TEST(CellCutting, CapsThatAreDroppedDoNotMatter) {
  oracle::RandomSource random(68);
  uint32_t buried = 0, dropped = 0, points = 0;
  for (int set = 0; set < 200; ++set) {
    const uint32_t n = static_cast<uint32_t>(random.in(5, 80));
    IndexedSearch search(bumps(random, n, 0.2, set % 2 == 0 ? 0.5 : 1.4));
    for (uint32_t i = 0; i < search.size(); ++i) {
      if (search.balls().r[i] != 1000000 || !search.gather(i)) continue;
      const hsp::Caps &caps = search.caps;
      const hsp::CellBox box{part(random, -0.8, 0.8), part(random, -0.8, 0.8), part(random, -0.8, 0.8),
                             part(random, 0.05, 0.6)};
      Cutting cutting(caps, box);
      const bool left = cutting.cell.cut_by(cutting.numbers(), set % 3 == 0 ? 0.1 * box.half : 0.0);
      if (left) cutting.cell.drop(cutting.numbers());
      buried += left ? 0 : 1;
      for (const uint8_t state : cutting.state) dropped += left && state == hsp::CapState::dropped ? 1 : 0;
      points += expect_others_to_cover(random, caps, box, cutting, left);
    }
  }
  EXPECT_GT(buried, 10U);
  EXPECT_GT(dropped, 1000U);
  EXPECT_GT(points, 1000U);
}

// Planes that nearly go through one point, and others around a cone: so many cut in the order given that there is no
// room for more. With the deepest first more are dropped.
TEST(CellCutting, CutsAnewByTheDeepest) {
  oracle::RandomSource random(70);
  uint32_t without_room = 0, buried = 0, stayed = 0, stay = 0, points = 0;
  oracle::Balls balls = oracle::balls_of_near_planes(random, 200, 100000, 0.4, 1e-2);
  for (int k = 0; k < 200; ++k) {
    const double angle = k * std::numbers::pi / 100, distance = 1e5 * (0.2 + 1.3 * random.fraction());
    const double across = distance * std::sin(1.0), along = distance * std::cos(1.0);
    balls.push_back({std::llround(across * std::cos(angle)), std::llround(across * std::sin(angle)),
                     std::llround(along), std::llround(std::sqrt(1e10 + distance * distance - 6e4 * distance))});
  }
  IndexedSearch search(balls);
  for (uint32_t i = 0; i < search.size(); ++i) {
    if (!search.gather(i)) continue;
    const hsp::Caps &caps = search.caps;
    Cutting cutting(caps, {}, Part::ball);
    if (!cutting.cell.cut_by(cutting.numbers(), 0.0) || !cutting.cell.lacks_room()) continue;
    ++without_room;
    cutting.cell.drop(cutting.numbers());
    std::vector<uint32_t> left;
    for (uint32_t k = 0; k < caps.count; ++k) {
      if (cutting.state[k] == hsp::CapState::dropped) continue;
      cutting.state[k] = hsp::CapState::stays;
      left.push_back(k);
    }
    stayed += static_cast<uint32_t>(left.size());
    const std::vector<uint32_t> before = left;
    const bool some_left = cutting.cell.cut_anew({left.data(), static_cast<uint32_t>(left.size())});
    if (some_left) cutting.cell.drop({before.data(), static_cast<uint32_t>(before.size())});
    buried += some_left ? 0 : 1;
    for (const uint8_t state : cutting.state) stay += some_left && state != hsp::CapState::dropped ? 1 : 0;
    points += expect_others_to_cover(random, caps, {}, cutting, some_left, Part::ball);
  }
  EXPECT_GT(without_room, 5U);
  EXPECT_GT(buried, 0U);
  EXPECT_LT(4 * stay, 3 * stayed);
  EXPECT_GT(points, 1000U);
}

// Those that cut less deep wait.
TEST(CellCutting, WaitsWithThoseThatAreNotDeep) {
  oracle::RandomSource random(69);
  IndexedSearch search(bumps(random, 40, 0.3, 0.6));
  uint32_t tried = 0;
  for (uint32_t i = 0; i < search.size(); ++i) {
    if (search.balls().r[i] != 1000000 || !search.gather(i)) continue;
    Cutting none(search.caps, {});
    EXPECT_TRUE(none.cell.cut_by(none.numbers(), 8.0));
    EXPECT_TRUE(none.cell.some_wait());
    for (const uint8_t state : none.state) EXPECT_EQ(state, hsp::CapState::waits);
    Cutting some(search.caps, {});
    EXPECT_TRUE(some.cell.cut_by(some.numbers(), 0.0));
    EXPECT_FALSE(some.cell.some_wait());
    for (const uint8_t state : some.state) EXPECT_NE(state, hsp::CapState::waits);
    ++tried;
  }
  EXPECT_EQ(tried, 1U);
}

}  // namespace
