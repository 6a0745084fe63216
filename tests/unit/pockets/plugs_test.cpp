// Plugs of mouths against the corners of discs in their plane; what they leave of pockets against a flood of cells,
// which tells of many whether they are closed; plugs in leaks, until all are.
#include "pockets/plugs.hpp"

#include <gtest/gtest.h>

#include <set>

#include "built_pores.hpp"
#include "built_topology.hpp"
#include "free_cells.hpp"
#include "pockets/pore_questions.hpp"
#include "pore_sets.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::no_id;
using Point = std::array<double, 3>;
using Flat = std::array<double, 2>;

Point place_of(const hsp::CriticalPoint &point) {
  return {point.position.x, point.position.y, point.position.z};
}

// The nearest balls of a mouth as discs of its plane, around its point.
struct Discs {
  Discs(const BuiltPores &pores, const oracle::Balls &grown, const hsp::PoreGate &mouth) {
    const Point at = place_of(mouth.point);
    std::vector<Point> from;
    for (const uint32_t ball : pores.builder().tied(mouth.point)) {
      const oracle::LatticeBall &b = grown[ball];
      from.push_back(
          {static_cast<double>(b.x) - at[0], static_cast<double>(b.y) - at[1], static_cast<double>(b.z) - at[2]});
      radius.push_back(static_cast<double>(b.radius));
    }
    const auto times = [](const Point &p, const Point &q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
    // Axes of the plane: the first ball, and whatever is most across it.
    Point u = from[0], v{};
    const auto scale = [&](Point &p) {
      const double length = std::sqrt(times(p, p));
      for (double &x : p) x /= length;
    };
    scale(u);
    double most = 0.0;
    for (const Point &p : from) {
      const double along = times(p, u);
      const Point across{p[0] - along * u[0], p[1] - along * u[1], p[2] - along * u[2]};
      if (times(across, across) / times(p, p) <= most) continue;
      most = times(across, across) / times(p, p);
      v = across;
    }
    scale(v);
    for (const Point &p : from) centre.push_back({times(p, u), times(p, v)});
    // In their order around the point.
    for (size_t k = 0; k < from.size(); ++k) order.push_back(k);
    const auto turn = [&](size_t k) { return std::atan2(centre[k][1], centre[k][0]); };
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return turn(a) < turn(b); });
  }
  // How far the farthest corner is, or end of a gap.
  double reach() const {
    double most = 0.0;
    for (size_t k = 0; k < order.size(); ++k) {
      const size_t a = order[k], b = order[(k + 1) % order.size()];
      const double dx = centre[b][0] - centre[a][0], dy = centre[b][1] - centre[a][1], d = std::hypot(dx, dy);
      if (d >= radius[a] + radius[b]) {
        for (const auto &[at, r] : {std::pair{a, radius[a]}, std::pair{a, d - radius[b]}}) {
          most = std::max(most, std::hypot(centre[at][0] + r * dx / d, centre[at][1] + r * dy / d));
        }
        continue;
      }
      const double x = (d * d + radius[a] * radius[a] - radius[b] * radius[b]) / (2.0 * d);
      const double y = std::sqrt(std::max(0.0, radius[a] * radius[a] - x * x));
      const auto far = [&](double side) {
        return std::hypot(centre[a][0] + (x * dx - side * dy) / d, centre[a][1] + (x * dy + side * dx) / d);
      };
      most = std::max(most, std::min(far(y), far(-y)));
    }
    return most;
  }
  // Whether a point of the plane is in the polygon of the centres and in no disc.
  bool is_open(const Flat &at) const {
    for (size_t k = 0; k < order.size(); ++k) {
      const Flat &a = centre[order[k]], &b = centre[order[(k + 1) % order.size()]];
      if ((b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0]) < 0.0) return false;
      if (std::hypot(at[0] - a[0], at[1] - a[1]) < radius[order[k]]) return false;
    }
    return true;
  }
  // The farthest point of a grid that is joined to the middle by open ones.
  double flooded(double spacing) const {
    std::set<std::pair<int, int>> seen{{0, 0}};
    std::vector<std::pair<int, int>> stack{{0, 0}};
    double most = 0.0;
    while (!stack.empty() && seen.size() < 20000) {
      const auto [x, y] = stack.back();
      stack.pop_back();
      most = std::max(most, spacing * std::hypot(x, y));
      for (const auto &[i, j] : {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
        const std::pair<int, int> next{x + i, y + j};
        if (!is_open({spacing * next.first, spacing * next.second}) || !seen.insert(next).second) continue;
        stack.push_back(next);
      }
    }
    return most;
  }

  std::vector<Flat> centre;
  std::vector<double> radius;
  std::vector<size_t> order;
};

struct Seen {
  int plugs = 0, closed = 0, open = 0, filled = 0, known_closed = 0;
  int rooms = 0, leaks = 0;
};

void expect_plug(const BuiltPores &pores, const oracle::Balls &grown, const hsp::PoreGate &mouth,
                 const hsp::exact::LatticeBall &plug, Seen &seen) {
  const Discs discs(pores, grown, mouth);
  const double reach = discs.reach(), radius = static_cast<double>(plug.radius);
  double largest = 0.0;
  for (const double r : discs.radius) largest = std::max(largest, r);
  ASSERT_GE(radius, reach);
  ASSERT_LE(radius, reach + 2e-6 * (reach + largest) + 8.0);
  ASSERT_LE(discs.flooded(reach / 20.0), radius);
  ++seen.plugs;
}

// The sizes of pockets, as plugs leave them, and which of them are open.
struct Sizes {
  std::vector<double> volume;
  std::vector<int> parts;
  std::vector<bool> open;
  bool any_open() const { return std::find(open.begin(), open.end(), true) != open.end(); }
};

// Those between some balls and plugs. leaks: what gets out between the plugs. False if it is not known where shells
// are, as plugs may all but touch balls in a point.
bool find_sizes(const BuiltPores &pores, hsp::PocketFinder &finder, BuiltPores &plugged, const oracle::Balls &all,
                uint32_t first_plug, Sizes &sizes, hsp::PocketFinder &leaks) {
  BuiltTopology topology(all);
  hsp::RegionFinder regions;
  CarvedMemory memory;
  memory.carve(regions, plugged.limits());
  const hsp::BallsAround around(plugged.grid());
  hsp::Status status = regions.find(plugged.builder(), around, topology.boundary(), nullptr, 0, first_plug);
  if (status == hsp::Status::range) return false;
  EXPECT_EQ(status, hsp::Status::ok);
  leaks.begin_leaks(plugged.builder());
  status = finder.match(pores.builder(), regions, [&](uint32_t maximum, uint32_t &region) {
    const Point at = place_of(pores.maxima()[maximum].point);
    const hsp::exact::Vector point{std::llround(at[0]), std::llround(at[1]), std::llround(at[2])};
    hsp::PoreLocation place;
    const hsp::Status found = hsp::locate(plugged.builder(), around, point, 0, place);
    if (found != hsp::Status::ok || place.maximum == no_id) return found;
    region = regions.region_of(plugged.builder(), place.maximum);
    leaks.mark(place.maximum, finder.pocket_of(maximum));
    return found;
  });
  EXPECT_EQ(status, hsp::Status::ok);
  leaks.find_leaks(plugged.builder());
  const size_t pockets = finder.pockets().size();
  sizes = {std::vector<double>(pockets), std::vector<int>(pockets), std::vector<bool>(pockets)};
  finder.visit_regions(
      regions.regions(), [&](uint32_t pocket) { sizes.open[pocket] = true; },
      [&](uint32_t pocket, const hsp::PoreRegion &region) {
        sizes.volume[pocket] += region.volume;
        ++sizes.parts[pocket];
        EXPECT_LE(region.plug_area, region.area);
      });
  // Without a leak nothing gets out.
  EXPECT_EQ(leaks.all_mouths().empty(), !sizes.any_open());
  return true;
}

// Cells prove that a pocket is open, or that it is closed, or neither.
void expect_flood(const BuiltPores &pores, const hsp::PocketFinder &finder, double narrow, const oracle::Balls &all,
                  const Sizes &sizes, Seen &seen) {
  const oracle::FreeCells cells(all, 44);
  for (uint32_t p = 0; p < finder.pockets().size(); ++p) {
    std::set<uint32_t> members;
    for (const uint32_t maximum : finder.maxima(finder.pockets()[p])) members.insert(maximum);
    std::set<size_t> free, touched, middles;
    for (const uint32_t maximum : members) {
      const Point at = place_of(pores.maxima()[maximum].point);
      free.insert(cells.free_at(at));
      touched.insert(cells.touched_at(at));
      middles.insert(cells.middle_at(at));
    }
    free.erase(oracle::FreeCells::none);
    touched.erase(oracle::FreeCells::none);
    middles.erase(oracle::FreeCells::none);
    bool surely_open = false, surely_closed = true;
    double least = 0.0, most = 0.0, about = 0.0;
    for (const size_t part : free) {
      surely_open = surely_open || cells.free_part(part).outside;
      least += cells.free_part(part).volume;
    }
    for (const size_t part : touched) {
      surely_closed = surely_closed && !cells.touched_part(part).outside;
      most += cells.touched_part(part).volume;
    }
    for (const size_t part : middles) about += cells.middle_part(part).volume;
    for (uint32_t k = 0; k < pores.maxima().size(); ++k) {
      if (!(pores.maxima()[k].point.level > narrow) || members.count(k) > 0) continue;
      const Point at = place_of(pores.maxima()[k].point);
      surely_open = surely_open || free.count(cells.free_at(at)) > 0;
      surely_closed = surely_closed && touched.count(cells.touched_at(at)) == 0;
    }
    seen.known_closed += surely_closed ? 1 : 0;
    seen.open += sizes.open[p] ? 1 : 0;
    seen.closed += sizes.open[p] ? 0 : 1;
    seen.filled += !sizes.open[p] && sizes.parts[p] == 0 ? 1 : 0;
    if (surely_open) {
      ASSERT_TRUE(sizes.open[p]) << oracle::to_text(all);
    }
    if (surely_closed) {
      ASSERT_FALSE(sizes.open[p]) << oracle::to_text(all);
      ASSERT_LE(sizes.volume[p], most * (1.0 + 1e-9)) << oracle::to_text(all);
    }
    if (sizes.open[p]) continue;
    ASSERT_GE(sizes.volume[p], least * (1.0 - 1e-9)) << oracle::to_text(all);
    if (least < 1e23) continue;  // a room of some hundred cells
    ASSERT_NEAR(about, sizes.volume[p], 0.03 * about) << oracle::to_text(all);
    ++seen.rooms;
  }
}

// The pockets of a set, with plugs in mouths and then in leaks, until they are closed.
void check_set(const oracle::Balls &balls, int64_t narrow, int64_t wide, Seen &seen) {
  BuiltPores pores(balls, 0);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  hsp::PocketFinder finder;
  CarvedMemory memory;
  memory.carve(finder, pores.limits());
  finder.find(pores.builder(), static_cast<double>(narrow), static_cast<double>(wide));
  oracle::Balls all = balls;
  for (auto &ball : all) ball.radius = hsp::grown_radius(ball.radius, narrow);
  const oracle::Balls grown = all;
  for (const uint32_t mouth : finder.all_mouths()) {
    const hsp::PoreGate &gate = pores.gates()[mouth];
    const hsp::exact::LatticeBall plug = hsp::plug_of(pores.builder(), pores.grid(), gate, narrow);
    expect_plug(pores, grown, gate, plug, seen);
    all.push_back({plug.centre.x, plug.centre.y, plug.centre.z, plug.radius});
  }
  bool more = true;
  for (int times = 0; more; ++times) {
    ASSERT_LT(times, 20) << oracle::to_text(balls);
    BuiltPores plugged(all, 0);
    ASSERT_EQ(plugged.status(), hsp::Status::ok);
    hsp::PocketFinder leaks;
    CarvedMemory leak_memory;
    leak_memory.carve(leaks, plugged.limits());
    Sizes sizes;
    const auto first_plug = static_cast<uint32_t>(balls.size());
    if (!find_sizes(pores, finder, plugged, all, first_plug, sizes, leaks)) return;
    more = sizes.any_open();
    if (times == 0 || !more) expect_flood(pores, finder, static_cast<double>(narrow), all, sizes, seen);
    for (const uint32_t leak : leaks.all_mouths()) {
      const hsp::exact::LatticeBall plug = hsp::plug_of(plugged.builder(), plugged.grid(), plugged.gates()[leak], 0);
      all.push_back({plug.centre.x, plug.centre.y, plug.centre.z, plug.radius});
    }
    seen.leaks += static_cast<int>(leaks.all_mouths().size());
  }
}

// Around a place that is free, with a hole or two.
oracle::Balls wall_with_holes(oracle::RandomSource &random) {
  const int64_t unit = 100000000;
  const auto direction = [&] {
    const double z = 2.0 * random.fraction() - 1.0, turn = 6.283185307179586 * random.fraction();
    const double across = std::sqrt(1.0 - z * z);
    return Point{across * std::cos(turn), across * std::sin(turn), z};
  };
  const Point hole[2] = {direction(), direction()};
  const double wide[2] = {0.88 + 0.08 * random.fraction(), random.one_in(2) ? 0.9 : 2.0};
  oracle::Balls balls;
  while (balls.size() < 180) {
    const Point to = direction();
    bool in_hole = false;
    for (int h = 0; h < 2; ++h) in_hole |= to[0] * hole[h][0] + to[1] * hole[h][1] + to[2] * hole[h][2] > wide[h];
    if (in_hole) continue;
    const auto along = [&](double part) {
      return static_cast<int64_t>(part * 2.0 * static_cast<double>(unit)) + random.in(-unit / 8, unit / 8);
    };
    balls.push_back({along(to[0]), along(to[1]), along(to[2]), random.in(unit / 2, unit * 3 / 4)});
  }
  return balls;
}

TEST(Plugs, CloseWhatAFloodDoesNotGetOutOf) {
  oracle::RandomSource random(17);
  const int64_t unit = 100000000;
  Seen seen;
  for (int turn = 0; turn < oracle::sets(24); ++turn) {
    const int kind = turn / 4;
    const oracle::Balls balls = turn % 4 == 0   ? pore_sets::general_set(random, 60, kind % pore_sets::general_kinds)
                                : turn % 4 == 1 ? pore_sets::tied_set(random, 40, kind % pore_sets::tied_kinds)
                                                : wall_with_holes(random);
    const int64_t narrow = random.in(0, unit / 8);
    check_set(balls, narrow, narrow + random.in(unit / 10, unit), seen);
    if (HasFatalFailure()) return;
  }
  if (oracle::sets(24) < 24) return;
  EXPECT_GT(seen.plugs, 100);
  EXPECT_GT(seen.open, 3);
  EXPECT_GT(seen.filled, 10);
  EXPECT_GT(seen.known_closed, 10);
  EXPECT_GT(seen.leaks, 10);
  EXPECT_GT(seen.rooms, 4);
}

}  // namespace
