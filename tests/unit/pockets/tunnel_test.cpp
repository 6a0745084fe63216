// Tunnels: their tightest gate against relaxation over the gates that are not avoided, their points against the
// distance from all balls.
#include "pockets/tunnel.hpp"

#include <gtest/gtest.h>

#include <set>

#include "checked_pores.hpp"
#include "stopped_at.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::no_id;
using hsp::pore_outside;

// The level of the tightest gate of the widest path, without some gates.
double width(const BuiltPores &pores, uint32_t from, uint32_t to, const std::vector<uint32_t> &avoided) {
  std::vector<double> at(pores.maxima().size() + 1, -INFINITY);
  at[hsp::node_of(from)] = INFINITY;
  for (bool changed = true; changed;) {
    changed = false;
    for (uint32_t k = 0; k < pores.gates().size(); ++k) {
      const hsp::PoreGate &gate = pores.gates()[k];
      if (std::find(avoided.begin(), avoided.end(), k) != avoided.end()) continue;
      for (const uint32_t side : {0U, 1U}) {
        const double through = std::min(at[hsp::node_of(gate.end[side])], gate.point.level);
        double &there = at[hsp::node_of(gate.end[1 - side])];
        changed = changed || through > there;
        there = std::max(there, through);
      }
    }
  }
  return at[hsp::node_of(to)];
}

double distance_at(const oracle::Balls &balls, const hsp::Vec3 &x, uint32_t ball) {
  const auto &b = balls[ball];
  const double dx = x.x - static_cast<double>(b.x), dy = x.y - static_cast<double>(b.y),
               dz = x.z - static_cast<double>(b.z);
  return std::sqrt(dx * dx + dy * dy + dz * dz) - static_cast<double>(b.radius);
}

// Beyond the box around all centres.
bool is_outside(const oracle::Balls &balls, const hsp::Vec3 &at) {
  const double x[3] = {at.x, at.y, at.z};
  for (int axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY;
    for (const auto &ball : balls) {
      const auto centre = static_cast<double>(axis == 0 ? ball.x : axis == 1 ? ball.y : ball.z);
      low = std::min(low, centre);
      high = std::max(high, centre);
    }
    if (x[axis] < low || x[axis] > high) return true;
  }
  return false;
}

int compared_halfway = 0, unknown_parts = 0;

void check_points(const oracle::Balls &balls, const BuiltPores &pores, const hsp::TunnelFinder &finder,
                  const hsp::TunnelSummary &found) {
  uint32_t gates = 0, tightest = no_id;
  double length = 0.0;
  for (uint32_t k = 0; k < finder.points().size(); ++k) {
    const hsp::TunnelPoint &point = finder.points()[k];
    double level = INFINITY;
    for (uint32_t b = 0; b < balls.size(); ++b) level = std::min(level, distance_at(balls, point.position, b));
    ASSERT_NEAR(point.level, level, 4.0) << oracle::to_text(balls);
    ASSERT_GE(level, found.level - 4.0);
    for (const uint32_t ball : point.ball) {
      if (ball != no_id) {
        ASSERT_NEAR(distance_at(balls, point.position, ball), level, 8.0);
      }
    }
    if (point.gate != no_id) {
      ++gates;
      tightest = tightest == no_id ? point.gate : std::max(tightest, point.gate);
      ASSERT_EQ(point.level, pores.gates()[point.gate].point.level);
      // It rises to both sides.
      ASSERT_GE(finder.points()[k - 1].level, point.level - 1e-6);
      ASSERT_GE(finder.points()[k + 1].level, point.level - 1e-6);
    }
    if (k == 0) continue;
    const hsp::TunnelPoint &before = finder.points()[k - 1];
    const hsp::Vec3 d = point.position - before.position;
    length += std::sqrt(dot(d, d));
    // Two ways that meet at a maximum have it once.
    ASSERT_TRUE(point.maximum == no_id || point.maximum != before.maximum) << oracle::to_text(balls);
    // The way between them is known well enough to draw it, and its width.
    double reach = INFINITY, of_any = INFINITY, halfway = INFINITY;
    for (const uint32_t ball : point.ball) {
      for (const uint32_t other : before.ball) {
        if (ball == no_id || other == no_id) continue;
        const double lowest = std::min(before.level, point.level);
        const auto least = static_cast<double>(std::min(balls[ball].radius, balls[other].radius));
        of_any = std::min(of_any, lowest + least);
        if (ball == other) reach = std::min(reach, lowest + least);
      }
    }
    const bool shared = reach < INFINITY;
    if (!shared) reach = of_any;
    const bool leaps = std::sqrt(dot(d, d)) > 0.1 * reach;
    unknown_parts += leaps && !(is_outside(balls, before.position) && is_outside(balls, point.position)) ? 1 : 0;
    for (uint32_t b = 0; b < balls.size(); ++b) {
      halfway = std::min(halfway, distance_at(balls, before.position + 0.5 * d, b));
    }
    const double mean = 0.5 * (before.level + point.level);
    if (shared && !leaps) {
      ASSERT_LE(halfway, mean + 8.0);
      ASSERT_GT(halfway, mean - reach / 800 - 8.0);
      ++compared_halfway;
    }
    const auto stays = [](const hsp::TunnelPoint &each) { return each.gate != no_id || each.maximum != no_id; };
    const bool first = k == 1, last = k + 1 == finder.points().size();
    if ((!stays(point) && !last) || (!stays(before) && !first)) {
      ASSERT_GE(std::sqrt(dot(d, d)), std::fabs(point.level) / 256);
    }
  }
  ASSERT_EQ(gates, found.gates);
  ASSERT_EQ(tightest, found.gate);
  ASSERT_DOUBLE_EQ(length, found.length);
}

// Of straight lines; the outside costs nothing.
double cost_of(const BuiltPores &pores, const hsp::PoreGate &gate) {
  double sum = 0.0;
  for (const uint32_t end : gate.end) {
    if (end == pore_outside) continue;
    const hsp::CriticalPoint &top = pores.maxima()[end].point;
    const hsp::Vec3 d = top.position - gate.point.position;
    sum += std::sqrt(dot(d, d)) / (top.level * gate.point.level);
  }
  return gate.point.level > 0.0 ? sum : INFINITY;
}

void check_cheapest(BuiltPores &pores, hsp::TunnelFinder &finder, hsp::TunnelEnds ends, double of_widest) {
  hsp::TunnelSummary found{};
  ends.by_cost = true;
  ASSERT_EQ(finder.find(pores.builder(), pores.grid(), ends, found), hsp::Status::ok);
  std::vector<double> least(pores.maxima().size() + 1, INFINITY);
  least[hsp::node_of(found.there ? found.ends[0].maximum : pore_outside)] = 0.0;
  for (bool changed = found.there; changed;) {
    changed = false;
    for (uint32_t k = 0; k < pores.gates().size(); ++k) {
      const hsp::PoreGate &gate = pores.gates()[k];
      if (std::find(ends.avoided.begin(), ends.avoided.end(), k) != ends.avoided.end()) continue;
      for (const uint32_t side : {0U, 1U}) {
        const double through = least[hsp::node_of(gate.end[side])] + cost_of(pores, gate);
        double &there = least[hsp::node_of(gate.end[1 - side])];
        changed = changed || through < there;
        there = std::min(there, through);
      }
    }
  }
  ASSERT_TRUE(found.there || of_widest == INFINITY);
  if (!found.there) return;
  ASSERT_NEAR(found.cost, least[hsp::node_of(found.ends[1].maximum)], 1e-9 * found.cost);
  ASSERT_LE(found.cost, of_widest * (1.0 + 1e-9));
  double along = 0.0;
  for (const hsp::TunnelPoint &point : finder.points()) {
    if (point.gate != no_id) along += cost_of(pores, pores.gates()[point.gate]);
  }
  ASSERT_NEAR(along, found.cost, 1e-9 * found.cost);
}

// A finder, by the points that it may need.
struct Limited {
  hsp::TunnelFinder &finder;
  const BuiltPores &pores;
  void carve(hsp::Workspace &workspace, const uint32_t &points) {
    finder.carve(workspace, pores.maxima().size(), pores.gates().size(), points);
  }
};
// With room for more points than tunnels here have.
class RoomyFinder : public hsp::TunnelFinder {
 public:
  explicit RoomyFinder(const BuiltPores &pores) {
    Limited limited{*this, pores};
    memory_.carve(limited, uint32_t{20000});
  }

 private:
  CarvedMemory memory_;
};

TEST(Tunnel, IsTheWidestThatAvoidsGates) {
  oracle::RandomSource random(1);
  int tunnels = 0, gates = 0, blocked = 0, alternatives = 0;
  for (int turn = 0; turn < oracle::sets(40); ++turn) {
    const oracle::Balls balls = turn % 2 == 0 ? pore_sets::general_set(random, 40, turn / 2 % pore_sets::general_kinds)
                                              : pore_sets::tied_set(random, 24, turn / 2 % pore_sets::tied_kinds);
    const int64_t floor = turn % 4 < 2 ? 0 : BuiltPores::lowest(balls);
    BuiltPores pores(balls, floor);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    if (pores.maxima().empty()) continue;
    RoomyFinder finder(pores);
    const auto any_place = [&] {
      const auto last = static_cast<int64_t>(pores.maxima().size()) - 1;
      const hsp::Vec3 &at = pores.maxima()[static_cast<uint32_t>(random.in(0, last))].point.position;
      return hsp::exact::Vector{std::llround(at.x), std::llround(at.y), std::llround(at.z)};
    };
    const hsp::exact::Vector from = any_place(), to = any_place();
    const bool to_outside = turn % 3 != 0;
    std::vector<uint32_t> avoided;
    for (int next = 0; next < 4; ++next) {
      hsp::TunnelSummary found{};
      const hsp::Span<const uint32_t> without(avoided.data(), static_cast<uint32_t>(avoided.size()));
      const hsp::TunnelEnds ends{from, to_outside ? nullptr : &to, without, floor, false};
      ASSERT_EQ(finder.find(pores.builder(), pores.grid(), ends, found), hsp::Status::ok);
      const uint32_t a = found.ends[0].maximum, b = found.ends[1].maximum;
      if (a == no_id || b == no_id) break;
      const double expected = width(pores, a, b, avoided);
      ASSERT_EQ(found.there, expected != -INFINITY);
      if (!found.there) {
        ++blocked;
        ASSERT_TRUE(finder.points().empty());
        break;
      }
      // Gates that tie are in one order, whatever the last bits of their levels.
      ASSERT_NEAR(found.level, std::min({expected, found.ends[0].level, found.ends[1].level}), 1e-6);
      ASSERT_EQ(found.gate == no_id, expected == INFINITY);
      if (found.gate != no_id) {
        ASSERT_NEAR(pores.gates()[found.gate].point.level, expected, 1e-6);
      }
      ASSERT_NO_FATAL_FAILURE(check_points(balls, pores, finder, found));
      ++tunnels;
      alternatives += next > 0 ? 1 : 0;
      gates += static_cast<int>(found.gates);
      if (found.gate == no_id) break;
      // One point less is too few.
      const double cost = found.cost;
      const uint32_t tightest = found.gate;
      const uint32_t needed = finder.needed_points();
      ASSERT_GE(needed, finder.points().size());
      hsp::TunnelFinder small;
      Limited limited_small{small, pores};
      CarvedMemory other;
      other.carve(limited_small, needed - 1);
      ASSERT_EQ(small.find(pores.builder(), pores.grid(), ends, found), hsp::Status::capacity);
      ASSERT_EQ(small.needed_points(), needed);
      ASSERT_TRUE(small.points().empty());
      ASSERT_NO_FATAL_FAILURE(check_cheapest(pores, finder, ends, cost));
      avoided.push_back(tightest);
    }
  }
  EXPECT_GT(tunnels, 40);
  EXPECT_GT(compared_halfway, 40 * tunnels / 4);
  EXPECT_LT(200 * unknown_parts, compared_halfway);
  EXPECT_GT(gates, tunnels);
  EXPECT_GT(alternatives, 20);
  EXPECT_GT(blocked, 3);
}

// From beside a ball without a radius, and beside a small one, into a wide cage: points get the farther apart the
// farther they are from it, and are no more than it takes.
TEST(Tunnel, PointsLieCloseBesideASmallBall) {
  constexpr int64_t side = int64_t{1} << 30;
  for (const int64_t radius : {int64_t{0}, int64_t{1000}}) {
    oracle::Balls balls = {{0, 0, 0, radius}};
    for (int k = 0; k < 8; ++k) {
      balls.push_back(
          {(k & 1) != 0 ? side : -side, (k & 2) != 0 ? side : -side, (k & 4) != 0 ? side : -side, side / 2});
    }
    BuiltPores pores(balls, 0);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    RoomyFinder finder(pores);
    for (const int64_t off : {radius + 400, radius + 20000}) {
      const hsp::exact::Vector from{off, off / 7, -off / 3}, to{side / 2, 0, side / 3};
      for (const hsp::exact::Vector *end : {static_cast<const hsp::exact::Vector *>(nullptr), &to}) {
        const int unknown_before = unknown_parts;
        hsp::TunnelSummary found{};
        ASSERT_EQ(finder.find(pores.builder(), pores.grid(), {from, end, {}, 0, false}, found), hsp::Status::ok);
        ASSERT_TRUE(found.there);
        ASSERT_NO_FATAL_FAILURE(check_points(balls, pores, finder, found));
        EXPECT_EQ(unknown_parts, unknown_before);
        EXPECT_LT(finder.points().size(), 600U);
      }
    }
  }
}

// Through a porous cube from corner to corner: stopped on the way it is not said that there is none.
TEST(Tunnel, StopsAtEachQuestion) {
  constexpr int side = 9;
  oracle::RandomSource random(2);
  oracle::Balls balls;
  for (int k = 0; k < side * side * side; ++k) {
    balls.push_back({100 * (k % side) + random.in(-9, 9), 100 * (k / side % side) + random.in(-9, 9),
                     100 * (k / side / side) + random.in(-9, 9), 40});
  }
  BuiltPores pores(balls, 0);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  RoomyFinder finder(pores);
  const hsp::exact::Vector from{50, 50, 50}, to{750, 750, 750};
  hsp::TunnelSummary found{};
  expect_stops_at_questions(5, 200, [&](const hsp::Executor &executor) {
    return finder.find(pores.builder(), pores.grid(), {from, &to, {}, 0, false}, found, hsp::Patience(&executor));
  });
  EXPECT_TRUE(found.there);
}

}  // namespace
