#include "peers_inputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "hardsphere.h"
#include "lattice_lengths.hpp"
#include "point_lattices.hpp"

namespace degenerate {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

struct Amount {
  Real area = 0;
  Real volume = 0;
  friend Amount operator+(Amount a, Amount b) { return {a.area + b.area, a.volume + b.volume}; }
  friend Amount operator-(Amount a, Amount b) { return {a.area - b.area, a.volume - b.volume}; }
  friend Amount operator*(Real times, Amount a) { return {times * a.area, times * a.volume}; }
};

Amount ball(Real radius) {
  return {4 * pi * radius * radius, 4 * pi / 3 * radius * radius * radius};
}

// The cap that a plane at a distance from the centre cuts off.
Amount cap(Real radius, Real distance) {
  const Real height = radius - distance;
  return {2 * pi * radius * height, pi * height * height * (3 * radius - height) / 3};
}

// Two balls that cross, at a distance.
Amount pair(Real first, Real second, Real distance) {
  const Real to_circle = (distance * distance + first * first - second * second) / (2 * distance);
  return ball(first) + ball(second) - cap(first, to_circle) - cap(second, distance - to_circle);
}

Right formula(Amount amount) {
  return {Arbiter::formula, amount.area, amount.volume};
}

Right refused(int32_t status, uint32_t first_bad) {
  return {Arbiter::status, 0, 0, status, first_bad};
}

Right crambin_times(Real scale) {
  return {Arbiter::reference, crambin_area * scale * scale, crambin_volume * scale * scale * scale};
}

const Right slices;
const Topology nothing{0, 0, 0, 0};
const Topology solid{1, 0, 1, 2};

BallList grid(double radius, double spacing) {
  BallList balls = oracle::in_lengths(oracle::box_lattice({5, 5, 5}, {1, 1, 1}, 0), spacing);
  std::fill(balls.radius.begin(), balls.radius.end(), radius);
  return balls;
}

BallList of(std::initializer_list<std::array<double, 4>> list) {
  BallList balls;
  for (const auto &[x, y, z, r] : list) balls.add(x, y, z, r);
  return balls;
}

BallList changed(BallList balls, double shift, double scale) {
  for (double &x : balls.xyz) x = (x + shift) * scale;
  for (double &r : balls.radius) r *= scale;
  return balls;
}

BallList with_more(const BallList &balls, double share) {
  BallList all = balls;
  for (size_t i = 0; i < balls.radius.size(); ++i)
    all.add(balls.xyz[3 * i], balls.xyz[3 * i + 1], balls.xyz[3 * i + 2], share * balls.radius[i]);
  return all;
}

// In the directions of the 26 neighbours in a cubic lattice.
BallList cage() {
  BallList balls = oracle::in_lengths(oracle::cage_of_26(1, 0), 1);
  for (size_t i = 0; i < balls.size(); ++i) {
    double *const centre = &balls.xyz[3 * i];
    const double distance = std::hypot(centre[0], centre[1], centre[2]);
    for (size_t k = 0; k < 3; ++k) centre[k] = 3 * centre[k] / distance;
    balls.radius[i] = 1.6;
  }
  return balls;
}

void add_few_balls(std::vector<PeersRow> &rows) {
  rows.push_back({"1 ball", of({{1, 2, 3, 1.5}}), formula(ball(1.5L)), solid, "ok", "ok", "ok", "ok / segfault"});
  rows.push_back({"2 balls apart",
                  of({{0, 0, 0, 1}, {4, 0, 0, 1.5}}),
                  formula(ball(1) + ball(1.5L)),
                  {2, 0, 2, 4},
                  "ok",
                  "ok",
                  "ok",
                  "ok / segfault"});
  rows.push_back({"a ball twice", of({{0, 0, 0, 1.5}, {0, 0, 0, 1.5}}), formula(ball(1.5L)), solid, "ok", "NaN",
                  "0 (both dropped)", "NaN / 80 % low"});
  rows.push_back({"2 crossing balls and a copy of one", of({{0, 0, 0, 1.5}, {1.25, 0, 0, 1.5}, {1.25, 0, 0, 1.5}}),
                  formula(pair(1.5L, 1.5L, 1.25L)), solid, "ok", "NaN", "33 % low", "NaN / 39 % off"});
  rows.push_back({"concentric, other radius", of({{0, 0, 0, 1}, {0, 0, 0, 1.5}}), formula(ball(1.5L)), solid, "ok",
                  "NaN", "ok", "ok"});
  rows.push_back({"a ball inside another", of({{0, 0, 0, 2}, {0.5, 0.25, 0, 1}}), formula(ball(2)), solid, "ok", "ok",
                  "ok", "ok"});
  rows.push_back({"a ball that touches another from inside", of({{0, 0, 0, 2}, {1, 0, 0, 1}}), formula(ball(2)), solid,
                  "ok", "ok", "ok", "ok"});
  rows.push_back({"2 balls that touch", of({{0, 0, 0, 1}, {2.5, 0, 0, 1.5}}), formula(ball(1) + ball(1.5L)), solid,
                  "ok", "ok", "ok", "ok / segfault"});
  rows.push_back({"5 x 5 x 5 grid, spacing 2, radius 1 (all touch)",
                  grid(1, 2),
                  formula(125 * ball(1)),
                  {1, 0, 1, 2 * (125 - 300)},
                  "ok",
                  "ok",
                  "ok",
                  "ok / segfault"});
  rows.push_back({"radius 0, outside a ball",
                  of({{0, 0, 0, 1.5}, {2, 0, 0, 0}}),
                  formula(ball(1.5L)),
                  {2, 0, 2, 4},
                  "ok",
                  "ok",
                  "ok",
                  "ok / segfault"});
  rows.push_back({"radius 0, inside a ball", of({{0, 0, 0, 1.5}, {1, 0, 0, 0}}), formula(ball(1.5L)), solid, "ok", "ok",
                  "ok", "ok"});
  rows.push_back({"5 collinear balls", of({{0, 0, 0, 1}, {1.5, 0, 0, 1}, {3, 0, 0, 1}, {4.5, 0, 0, 1}, {6, 0, 0, 1}}),
                  formula(5 * ball(1) - 8 * cap(1, 0.75L)), solid, "ok", "ok", "ok", "approximate"});
}

void add_common_points(std::vector<PeersRow> &rows) {
  const double t = 1 / std::sqrt(3.0);
  rows.push_back({"4 spheres through one point, tetrahedral",
                  of({{t, t, t, 1}, {-t, -t, t, 1}, {-t, t, -t, 1}, {t, -t, -t, 1}}), slices, solid, "**3e-3 wrong**",
                  "1e-9 off", "ok", "approximate"});
  rows.push_back({"4 spheres through an exposed common vertex",
                  of({{0.6, 0, -0.8, 1}, {-0.6, 0, -0.8, 1}, {0, 0.6, -0.8, 1}, {0, -0.6, -0.8, 1}}), slices, solid,
                  "ok", "ok", "ok", "approximate"});
  const double h = std::sqrt(0.75);
  rows.push_back({"hexagon and its centre, radius 1, spacing 1",
                  of({{0, 0, 0, 1},
                      {1, 0, 0, 1},
                      {0.5, h, 0, 1},
                      {-0.5, h, 0, 1},
                      {-1, 0, 0, 1},
                      {-0.5, -h, 0, 1},
                      {0.5, -h, 0, 1}}),
                  slices, solid, "ok", "2e-9 off", "**NaN**", "approximate"});
  rows.push_back(
      {"5 x 5 x 5 grid, spacing 1, radius 1", grid(1, 1), slices, solid, "ok", "**NaN**", "**NaN**", "approximate"});
  rows.push_back({"5 x 5 x 5 grid, spacing 1, radius 0.75",
                  grid(0.75, 1),
                  slices,
                  {1, 64, 65, 2 * 65},
                  "ok",
                  "**NaN**",
                  "ok",
                  "7 % off"});
  // The radius is rounded up to the lattice, so that the 64 holes between eight balls each are closed.
  rows.push_back({"5 x 5 x 5 grid, spacing 1, radius sqrt(3)/2 (8 spheres through the middle of each cube)", grid(h, 1),
                  slices, solid, "**35 % wrong**", "**NaN**", "ok", "approximate"});
  rows.push_back({"closed cavity, 26 balls on a shell", cage(), slices, {1, 1, 2, 4}, "ok", "ok", "ok", "approximate"});
}

void add_crambin(std::vector<PeersRow> &rows, const BallList &crambin) {
  const Topology &topology = crambin_topology;
  rows.push_back({"crambin, every ball twice", with_more(crambin, 1), crambin_times(1), topology, "ok", "**exit(1)**",
                  "**0**", "NaN / 8 % off"});
  rows.push_back({"crambin, a ball of half the size in every ball", with_more(crambin, 0.5), crambin_times(1), topology,
                  "ok", "**exit(1)**", "ok", "ok"});
  rows.push_back({"crambin, shifted by 1e4", changed(crambin, 1e4, 1), crambin_times(1), topology, "ok", "ok",
                  "volume 2e-9 wrong", "unchanged"});
  rows.push_back({"crambin, shifted by 1e6", changed(crambin, 1e6, 1), crambin_times(1), topology, "ok", "ok",
                  "volume 4e-7 wrong", "unchanged"});
  rows.push_back({"crambin times 1e-6", changed(crambin, 0, 1e-6), crambin_times(1e-6L), topology, "**160 % wrong**",
                  "**1e-3 wrong**", "refuses", "unchanged"});
  rows.push_back({"crambin times 1e+6", changed(crambin, 0, 1e6), crambin_times(1e6L), topology, "ok", "**58 % wrong**",
                  "ok", "unchanged"});
}

void add_refused(std::vector<PeersRow> &rows) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  rows.push_back({"NaN coordinate", of({{0, 0, 0, 1}, {1, nan, 0, 1}}), refused(HSP_E_NOT_FINITE, 1), nothing,
                  "silently a free ball", "exit(1)", "silently a free ball", "assertion ends the process"});
  rows.push_back({"infinite coordinate", of({{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, -infinity, 1}}),
                  refused(HSP_E_NOT_FINITE, 2), nothing, "silently a free ball", "exit(1)", "silently a free ball",
                  "error return"});
  rows.push_back({"NaN radius", of({{0, 0, 0, nan}, {1, 0, 0, 1}}), refused(HSP_E_NOT_FINITE, 0), nothing, "NaN",
                  "7e19 (garbage)", "NaN", "NaN / segfault"});
  rows.push_back({"radius -1", of({{0, 0, 0, 1}, {4, 0, 0, -1}}), refused(HSP_E_NEGATIVE, 1), nothing,
                  "area as of radius 1, volume 0", "area as of radius 1, volume 0", "area as of radius 1, volume 0",
                  "area as of radius 1"});
  rows.push_back({"0 balls", {}, formula({}), nothing, "0", "segfault", "0", "assertion ends the process"});
}

}  // namespace

std::vector<PeersRow> peers_rows(const BallList &crambin) {
  std::vector<PeersRow> rows;
  add_few_balls(rows);
  add_common_points(rows);
  add_crambin(rows, crambin);
  add_refused(rows);
  return rows;
}

}  // namespace degenerate
