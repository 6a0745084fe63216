#include "named_balls.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "point_lattices.hpp"

namespace oracle {
namespace {

using Integer = int64_t;

Integer nearest(double value) {
  return static_cast<Integer>(std::floor(value + 0.5));
}

// Carbon and hydrogen rings of benzene; lengths in units of 1e-8 angstrom.
Balls benzene(double probe) {
  constexpr double unit = 1e8;
  Balls balls;
  for (int k = 0; k < 6; ++k)
    for (const auto &[distance, radius] : {std::array{1.39, 1.70}, std::array{2.48, 1.20}}) {
      const double angle = k * std::numbers::pi / 3;
      balls.push_back({nearest(distance * std::cos(angle) * unit), nearest(distance * std::sin(angle) * unit), 0,
                       nearest((radius + probe) * unit)});
    }
  return balls;
}

// The truncated icosahedron with edges of 1.42 units, the cage radius being 3.52 units.
Balls fullerene(double unit, double radius) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  const std::array<std::array<double, 3>, 3> corners = {
      {{0, 1, 3 * golden}, {1, 2 + golden, 2 * golden}, {golden, 2, 2 * golden + 1}}};
  Balls balls;
  for (const auto &corner : corners)
    for (unsigned signs = 0; signs < 8; ++signs) {
      if (corner[0] == 0 && (signs & 1U) != 0) continue;
      std::array<Integer, 3> v{};
      for (size_t k = 0; k < 3; ++k) v[k] = nearest(((signs >> k & 1U) != 0 ? -1 : 1) * corner[k] / 2 * 1.42 * unit);
      for (size_t turn = 0; turn < 3; ++turn)
        balls.push_back({v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3], nearest(radius * unit)});
    }
  return balls;
}

Balls belted(const Balls &more) {
  return joined(joined({{0, 0, 0, 100}}, ring_around_z(16, 100, 0, 25)), more);
}

// Balls all over a sphere, in rings whose members and distances overlap.
Balls hollow_shell(double sphere_radius, Integer radius) {
  Balls balls = {{0, 0, nearest(sphere_radius), radius}, {0, 0, nearest(-sphere_radius), radius}};
  constexpr std::array<int, 5> members = {7, 12, 14, 12, 7};
  for (size_t k = 0; k < members.size(); ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k + 1) / 6;
    const Integer height = nearest(sphere_radius * std::cos(angle));
    balls = joined(balls, ring_around_z(members[k], sphere_radius * std::sin(angle), height, radius));
  }
  return balls;
}

void add_small_sets(std::vector<KnownBalls> &sets) {
  sets.push_back({"no ball", {}, 0, 0, 0});
  sets.push_back({"one ball", {{0, 0, 0, 5}}, 1, 0, 2});
  sets.push_back({"one ball of radius 0", {{7, -3, 2, 0}}, 1, 0, 2});
  sets.push_back({"two balls of radius 0", {{0, 0, 0, 0}, {1, 0, 0, 0}}, 2, 0, 4});
  sets.push_back({"the same ball of radius 0 twice", {{1, 1, 1, 0}, {1, 1, 1, 0}}, 1, 0, 2});
  sets.push_back({"a ball of radius 0 on a sphere", {{0, 0, 0, 5}, {3, 4, 0, 0}}, 1, 0, 2});
  sets.push_back({"a ball of radius 0 on a sphere, of lower rank", {{0, 0, 0, 5}, {-3, -4, 0, 0}}, 1, 0, 2});
  sets.push_back({"three times the same ball", {{0, 0, 0, 5}, {0, 0, 0, 5}, {0, 0, 0, 5}}, 1, 0, 2});
  sets.push_back({"concentric", {{0, 0, 0, 5}, {0, 0, 0, 3}, {0, 0, 0, 4}}, 1, 0, 2});
  sets.push_back({"a duplicate of one of a pair", {{0, 0, 0, 5}, {4, 0, 0, 5}, {4, 0, 0, 5}}, 1, 0, 2});
  sets.push_back({"externally tangent", {{0, 0, 0, 5}, {10, 0, 0, 5}}, 1, 0, 2});
  sets.push_back({"externally tangent, slanted", {{0, 0, 0, 5}, {4, 6, -12, 9}}, 1, 0, 2});
  sets.push_back({"one step apart", {{0, 0, 0, 5}, {11, 0, 0, 5}}, 2, 0, 4});
  sets.push_back({"internally tangent, the small ball of higher rank", {{0, 0, 0, 5}, {3, 0, 0, 2}}, 1, 0, 2});
  sets.push_back({"internally tangent, the small ball of lower rank", {{0, 0, 0, 5}, {-3, 0, 0, 2}}, 1, 0, 2});
  sets.push_back({"internally tangent at a pole", {{0, 0, 0, 5}, {0, 0, 3, 2}}, 1, 0, 2});
  sets.push_back({"three through a circle", {{0, 0, 0, 5}, {6, 0, 0, 5}, {3, 0, 0, 4}}, 1, 0, 2});
  sets.push_back({"five through a circle",
                  {{0, 0, 0, 12}, {5, 0, 0, 13}, {-5, 0, 0, 13}, {9, 0, 0, 15}, {-16, 0, 0, 20}},
                  1,
                  0,
                  2});
  sets.push_back(
      {"five in a row, touching", {{0, 0, 0, 1}, {2, 0, 0, 1}, {4, 0, 0, 1}, {6, 0, 0, 1}, {8, 0, 0, 1}}, 1, 0, 2});
  sets.push_back({"three mutually tangent", {{0, 0, 0, 5}, {10, 0, 0, 5}, {5, 12, 0, 8}}, 1, 0, 0});
  sets.push_back({"four mutually tangent", {{0, 0, 0, 1}, {2, 0, 0, 1}, {1, -2, 2, 2}, {1, 2, 2, 2}}, 1, 0, -4});
  sets.push_back({"two circles of one sphere touch", {{0, 0, 0, 25}, {31, 0, 0, 17}, {0, 31, 0, 17}}, 1, 0, 2});
  sets.push_back({"four through a point, two sides of it free",
                  {{2, 3, 6, 7}, {6, 2, 3, 7}, {3, 6, 2, 7}, {6, 3, 2, 7}},
                  1,
                  0,
                  2});
  sets.push_back({"four around a point", {{6, 3, 2, 7}, {-6, 3, 2, 7}, {0, -6, 2, 7}, {2, 3, -6, 7}}, 1});
  sets.push_back({"six through a point",
                  {{5, 0, 0, 5}, {-5, 0, 0, 5}, {0, 5, 0, 5}, {0, -5, 0, 5}, {0, 0, 5, 5}, {0, 0, -5, 5}},
                  1,
                  0,
                  2});
  sets.push_back({"a void of one point is none",  // four balls close at the point that is common to all
                  {{3, 4, 0, 5}, {-3, 4, 0, 5}, {0, -4, 3, 5}, {0, -4, -3, 5}},
                  1,
                  0,
                  2});
}

void add_lattices(std::vector<KnownBalls> &sets) {
  // In a lattice of touching balls the nerve is the grid graph: tunnels = edges - balls + 1.
  sets.push_back({"cube, edges touch", box_lattice({2, 2, 2}, {4, 4, 4}, 2), 1, 0, -8});
  sets.push_back({"slanted cube, edges touch", slanted_lattice({2, 2, 2}, {2, 2, 2}, 7), 1, 0, -8});
  sets.push_back({"cubic lattice, touching", box_lattice({3, 3, 3}, {2, 2, 2}, 1), 1, 0, -54});
  sets.push_back({"slanted lattice, touching", slanted_lattice({3, 3, 3}, {2, 2, 2}, 7), 1, 0, -54});
  sets.push_back({"cubic lattice, overlapping", box_lattice({3, 3, 3}, {4, 4, 4}, 3), 1, 8, std::nullopt});
  sets.push_back({"rectangles that close", box_lattice({2, 2, 1}, {6, 8, 1}, 5), 1, 0, 2});
  sets.push_back({"two rectangles that close", box_lattice({2, 2, 2}, {6, 8, 11}, 5), 2, 0, 4});
  sets.push_back({"two rectangles that close and touch", box_lattice({2, 2, 2}, {6, 8, 10}, 5), 1, 0, -4});
  // Half diagonal 7 of 4 x 6 x 12: eight spheres through one point, no void left.
  sets.push_back({"box that just closes", box_lattice({2, 2, 2}, {4, 6, 12}, 7), 1, 0, 2});
  sets.push_back({"box lattice that just closes", box_lattice({3, 3, 3}, {4, 6, 12}, 7), 1, 0, 2});
  sets.push_back({"slanted box that just closes", slanted_lattice({2, 2, 2}, {4, 6, 12}, 49), 1, 0, 2});
  sets.push_back({"slanted box that just does not close", slanted_lattice({2, 2, 2}, {4, 6, 12}, 48), 1, 1, 4});
  sets.push_back({"box lattice, radius 6", box_lattice({3, 3, 2}, {4, 6, 12}, 6), 1});
  sets.push_back({"face-centred, octahedral holes close", chosen_points(4, 2, 2, is_face_centred), 1});
  sets.push_back({"face-centred, larger", chosen_points(4, 3, 4, is_face_centred), 1});
  sets.push_back({"diamond, holes close", chosen_points(5, 2, 4, is_diamond), 1});
  sets.push_back({"hexagon in a slanted plane",
                  {{1, -1, 0, 1}, {1, 0, -1, 1}, {0, 1, -1, 1}, {-1, 1, 0, 1}, {-1, 0, 1, 1}, {0, -1, 1, 1}},
                  1,
                  0,
                  0});
  sets.push_back(
      {"hexagon with its centre",
       {{2, -2, 0, 2}, {2, 0, -2, 2}, {0, 2, -2, 2}, {-2, 2, 0, 2}, {-2, 0, 2, 2}, {0, -2, 2, 2}, {0, 0, 0, 1}},
       1,
       0,
       std::nullopt});
}

void add_molecules(std::vector<KnownBalls> &sets) {
  sets.push_back({"benzene", benzene(0), 1, 0, 2});
  sets.push_back({"benzene, accessible to a probe of 1.4", benzene(1.4), 1, 0, 2});
  sets.push_back({"fullerene", fullerene(50, 1.7), 1, 1, 4});
  sets.push_back({"fullerene of large balls", fullerene(50, 3.1), 1, 1, 4});
  sets.push_back({"fullerene without hollow", fullerene(50, 3.6), 1, 0, 2});
}

void add_nested_sets(std::vector<KnownBalls> &sets) {
  sets.push_back({"belt", belted({}), 1, 0, 2});
  sets.push_back({"belt with bumps at the poles", belted({{0, 0, 95, 20}, {30, 10, -90, 20}}), 1, 0, 2});
  sets.push_back({"belt with many bumps",
                  belted({{0, 0, 95, 10}, {50, 0, 85, 10}, {-50, 5, 85, 10}, {30, 10, -90, 20}}), 1, 0, 2});
  const Balls bumps = {{0, 0, 99, 9}, {0, 0, -97, 9}, {83, 0, 55, 3}};
  sets.push_back({"two belts with bumps", belted(joined(bumps, ring_around_z(12, 60, 80, 18))), 1, 0, 2});
  Balls upright;
  for (const LatticeBall &ball : belted({{95, 0, 0, 20}, {-93, 20, 10, 20}, {-88, -40, 10, 10}}))
    upright.push_back(ball);
  for (size_t k = 1; k <= 16; ++k) upright[k] = {0, upright[k].x, upright[k].y, upright[k].radius};
  sets.push_back({"upright belt with bumps", upright, 1, 0, 2});
  const Balls shell = hollow_shell(100, 42);
  sets.push_back({"hollow shell", shell, 1, 1, 4});
  sets.push_back({"hollow shell with a ball inside", joined(shell, {{0, 5, 0, 30}}), 2, 1, 6});
  sets.push_back({"hollow shell with a ball that touches it from inside", joined(shell, {{0, 0, 28, 30}}), 1, 1, 4});
  sets.push_back({"hollow shell with balls inside and outside",
                  joined(shell, {{0, 0, 0, 20}, {0, 30, 30, 5}, {0, 0, 180, 30}}), 4, 1, 10});
}

}  // namespace

std::vector<KnownBalls> known_balls() {
  std::vector<KnownBalls> sets;
  add_small_sets(sets);
  add_lattices(sets);
  add_molecules(sets);
  add_nested_sets(sets);
  return sets;
}

}  // namespace oracle
