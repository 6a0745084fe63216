// Families of a few balls that tie in many ways, exactly or up to a small offset. For such sets two patches of a smooth
// surface are most likely to contradict each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ball_list.hpp"
#include "random_numbers.hpp"

namespace support {

struct TiedSet {
  BallList balls;
  double probe = 0;
};

class TiedSets {
 public:
  explicit TiedSets(uint64_t seed) : random_(seed) {}

  TiedSet random_points() {
    for (int i = 0; i < 5; ++i) add({3 * fraction(), 3 * fraction(), 3 * fraction(), 0});
    return finish({1, 1.4, 2, 3, 8});
  }
  template <int count, int hundredths>
  TiedSet lattice_points() {
    for (int i = 0; i < count; ++i) add({whole(0, 2), whole(0, 2), whole(0, 2), hundredths / 100.0});
    return finish({1, 1.4, 2, 3, 8});
  }
  TiedSet points_and_balls() {
    for (int i = 0; i < 10; ++i) add({3 * fraction(), 3 * fraction(), 3 * fraction(), in(0, 3) == 0 ? 0 : fraction()});
    return finish({.25, .5, 1, 1.4, 2, 3});
  }
  TiedSet on_a_circle() {
    constexpr double at[][2] = {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}};
    const double unit = pick({.2, .1, .3});
    for (int left = in(3, 6); left > 0; --left) {
      const double *const q = at[in(0, 5)];
      const double side = sign();
      add({unit * side * q[0], unit * side * q[1], 0, 0});
    }
    if (in(0, 1) == 1) add({0, 0, unit * in(-5, 5), 0});
    return finish({.5, 1, 1.4, 2, 5});
  }
  TiedSet nested() {
    add({0, 0, 0, 2});
    for (int left = in(2, 5); left > 0; --left) {
      const auto k = static_cast<uint32_t>(in(0, static_cast<int>(set_.balls.size()) - 1));
      const double x = set_.balls.xyz[3 * k], y = set_.balls.xyz[3 * k + 1], z = set_.balls.xyz[3 * k + 2];
      const double outer = set_.balls.radius[k], inner = outer * pick({.5, .75, .25, 1}),
                   way = sign() * (outer - inner);
      switch (in(0, 4)) {
        case 0:
          add({x, y, z, inner});
          break;
        case 1:
          add({x + way, y, z, inner});
          break;
        case 2:
          add({x, y + way, z, inner});
          break;
        case 3:
          add({x, y, z + way, inner});
          break;
        default:
          add({x + .6 * way, y + .8 * way, z, inner});
      }
    }
    add({2, 0, 0, 0});
    if (in(0, 1) == 1) add({0, 1.2, 1.6, 0});
    return finish({.25, .5, 1, 2});
  }
  TiedSet radii_of_all_sizes() {
    for (int left = in(3, 6); left > 0; --left)
      add({whole(0, 3), whole(0, 3), whole(0, 3), pick({0, 0, .01, .1, 1, 1.5})});
    return finish({1, 1.4, 2, 8});
  }
  // Balls at the corners of a cube, an octahedron or a cuboctahedron, with spheres through its middle.
  TiedSet cage() {
    const int squares = 3 - in(0, 2);
    const double a = pick({.5, 1, 1.5});
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          if (x * x + y * y + z * z == squares) add({a * x, a * y, a * z, 0});
        }
      }
    }
    set_.probe = pick({.25, .5, 1, 2});
    const double reach = std::sqrt(squares) * a;
    double radius = reach > set_.probe ? std::nearbyint(1e8 * (reach - set_.probe)) / 1e8 : 0;
    if (in(0, 2) == 0) radius = pick({0, .25, .5, .75});
    for (double &r : set_.balls.radius) r = radius;
    if (in(0, 3) == 0) add({0, 0, 0, pick({0, .1, .25})});
    return set_;
  }
  // Probes at points of a lattice: balls on spheres of radius 3 around two such points.
  TiedSet probes_on_a_lattice() {
    constexpr double at[][3] = {{1, 2, 2}, {2, 1, 2}, {2, 2, 1}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
    const double unit = pick({.5, .25, 1});
    set_.probe = unit * pick({1, 2, 3, 1.5});
    for (int left = in(3, 6); left > 0; --left) {
      const double *const q = at[in(0, 5)];
      const double x = sign() * q[0] + (in(0, 2) == 0 ? in(1, 2) : 0), y = sign() * q[1], z = sign() * q[2];
      add({unit * x, unit * y, unit * z, 3 * unit - set_.probe});
    }
    return set_;
  }
  // Balls in a plane; probes on both sides of it touch.
  TiedSet probes_that_touch() {
    constexpr double of[][4] = {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}, {6, 6, 7, 11}};
    const double *const t = of[in(0, 5)];
    const int height = in(0, 2);
    const double unit = pick({.25, .125, .1});
    set_.probe = unit * t[height];
    for (int left = in(3, 6); left > 0; --left) {
      const int first = 1 + in(0, 1);
      add({unit * sign() * t[(height + first) % 3], unit * sign() * t[(height + 3 - first) % 3], 0,
           unit * t[3] - set_.probe});
    }
    return set_;
  }
  // Spheres through one circle, and balls around it.
  TiedSet through_a_circle() {
    constexpr double of[][2] = {{3, 5}, {-3, 5}, {0, 4}, {4.2, 5.8}, {7.5, 8.5}, {-7.5, 8.5}, {-4.2, 5.8}};
    constexpr double around[][2] = {{4, 0}, {0, 4}, {2.4, 3.2}, {-3.2, 2.4}};
    set_.probe = .25 * pick({4, 4.5, 5, 6});
    add({0, 0, 0, 1});
    for (int left = in(3, 6); left > 0; --left) {
      const double *const q = of[in(0, 6)];
      if (.25 * q[1] >= set_.probe) add({.25 * q[0], 0, 0, .25 * q[1] - set_.probe});
    }
    for (int left = in(0, 3); left > 0; --left) {
      const double *const q = around[in(0, 3)];
      add({.25 * in(-1, 1), .25 * q[0], .25 * q[1], pick({0, .25, .5})});
    }
    return set_;
  }
  TiedSet wide_ratios() {
    for (int i = 0; i < 6; ++i) add({2 * fraction(), 2 * fraction(), 2 * fraction(), std::pow(10, -3 * fraction())});
    return finish({.3, 1, 1.4, 3, 8});
  }
  TiedSet crystal() {
    const bool by_faces = in(0, 1) == 1;
    for (int left = in(3, 8); left > 0; --left) {
      int x = in(0, 2), y = in(0, 2), z = in(0, 2);
      const int middle = in(0, 1);
      if (by_faces) z += (x + y + z) % 2;
      if (!by_faces) x = x / 2 * 2 + middle, y = y / 2 * 2 + middle, z = z / 2 * 2 + middle;
      add({.75 * x, .75 * y, .75 * z, pick({0, .25, .530330, .75})});
    }
    return finish({.5, .75, 1, 1.4});
  }
  // Two balls touch in a point, others pass through it.
  TiedSet touching() {
    constexpr double at[13][3] = {{.6, .8, 0},    {-.6, .8, 0},    {.8, 0, .6},    {0, .6, .8},  {0, 1, 0},
                                  {0, -1, 0},     {0, 0, 1},       {0, 0, -1},     {.6, 0, -.8}, {0, -.6, .8},
                                  {.48, .6, .64}, {-.48, .64, .6}, {.64, .48, -.6}};
    set_.probe = pick({.25, .5, .125, 1});
    add({1, 0, 0, 1 - set_.probe});
    add({-1, 0, 0, 1 - set_.probe});
    for (int left = in(2, 6); left > 0; --left) {
      const double *const q = at[in(0, 12)];
      add({q[0], q[1], q[2], 1 - set_.probe});
    }
    return set_;
  }

  // Moves each ball by up to `by` along each axis.
  void move(double by, TiedSet &set) {
    for (double &x : set.balls.xyz) x += std::nearbyint((2 * fraction() - 1) * by * 1e9) / 1e9;
  }

 private:
  // A struct, as the numbers in braces are drawn in order; the arguments of a function need not be.
  struct Ball {
    double x, y, z, radius;
  };
  double fraction() { return std::floor(random_.fraction() * 1e6) / 1e6; }
  int in(int low, int high) { return low + static_cast<int>(random_.below(static_cast<uint32_t>(high - low + 1))); }
  double whole(int low, int high) { return in(low, high); }
  double sign() { return in(0, 1) == 1 ? 1 : -1; }
  double pick(std::initializer_list<double> of) { return *(of.begin() + in(0, static_cast<int>(of.size()) - 1)); }
  void add(const Ball &ball) { set_.balls.add(ball.x, ball.y, ball.z, ball.radius); }
  TiedSet finish(std::initializer_list<double> probes) {
    set_.probe = pick(probes);
    return set_;
  }

  Random random_;
  TiedSet set_;
};

struct TiedFamily {
  const char *name;
  TiedSet (TiedSets::*make)();
  double moved = 0;

  TiedSet member(uint64_t seed) const {
    TiedSets sets(seed * 977 + 13);
    TiedSet set = (sets.*make)();
    if (moved > 0) sets.move(moved, set);
    return set;
  }
};

inline constexpr TiedFamily tied_families[] = {
    {"random points", &TiedSets::random_points},
    {"points on a lattice", &TiedSets::lattice_points<5, 0>},
    {"points on a lattice, 1e-7 off", &TiedSets::lattice_points<5, 0>, 1e-7},
    {"four points on a lattice, 1e-7 off", &TiedSets::lattice_points<4, 0>, 1e-7},
    {"three points on a lattice, 1e-7 off", &TiedSets::lattice_points<3, 0>, 1e-7},
    {"tiny balls on a lattice, 1e-6 off", &TiedSets::lattice_points<5, 1>, 1e-6},
    {"small balls on a lattice, 1e-7 off", &TiedSets::lattice_points<5, 10>, 1e-7},
    {"balls on a lattice, 1e-8 off", &TiedSets::lattice_points<5, 100>, 1e-8},
    {"points and balls", &TiedSets::points_and_balls},
    {"points on a circle", &TiedSets::on_a_circle},
    {"points on a circle, 1e-7 off", &TiedSets::on_a_circle, 1e-7},
    {"points on a circle, 1e-9 off", &TiedSets::on_a_circle, 1e-9},
    {"nested", &TiedSets::nested},
    {"nested, 1e-8 off", &TiedSets::nested, 1e-8},
    {"radii of all sizes", &TiedSets::radii_of_all_sizes},
    {"radii of all sizes, 1e-7 off", &TiedSets::radii_of_all_sizes, 1e-7},
    {"cages", &TiedSets::cage},
    {"cages, 1e-7 off", &TiedSets::cage, 1e-7},
    {"probes on a lattice", &TiedSets::probes_on_a_lattice},
    {"probes on a lattice, 1e-8 off", &TiedSets::probes_on_a_lattice, 1e-8},
    {"probes that touch", &TiedSets::probes_that_touch},
    {"probes that touch, 1e-8 off", &TiedSets::probes_that_touch, 1e-8},
    {"through a circle", &TiedSets::through_a_circle},
    {"through a circle, 1e-8 off", &TiedSets::through_a_circle, 1e-8},
    {"wide ratios", &TiedSets::wide_ratios},
    {"crystals", &TiedSets::crystal},
    {"touching", &TiedSets::touching},
    {"touching, 1e-9 off", &TiedSets::touching, 1e-9},
};

}  // namespace support
