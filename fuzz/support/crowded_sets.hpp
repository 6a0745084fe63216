// Sets of some hundred balls with many neighbours each, made from few bytes. A set has up to four pieces, each of a
// kind that is slow for some algorithm. Balls of few lattice steps make ties, balls of many steps make none.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "fuzz_input.hpp"
#include "random_balls.hpp"
#include "random_numbers.hpp"

namespace fuzz {

class CrowdedSet {
 public:
  CrowdedSet(Bytes &bytes, uint32_t most) : bytes_(bytes), most_(most), random_(bytes.byte()) {
    for (uint32_t pieces = 1 + bytes.below(4); pieces > 0; --pieces) add_piece();
  }
  ScaledBalls take() { return std::move(set_); }

 private:
  static constexpr int64_t farthest = int64_t{1} << 28;

  // A length from one lattice step to 1.6 million.
  int64_t length() {
    int64_t steps = 1 + int64_t{bytes_.below(16)};
    for (uint32_t zeros = bytes_.below(6); zeros > 0; --zeros) steps *= 10;
    return steps;
  }
  // The difference of a radius from that of the ball before it: mostly 0.
  int64_t growth(int64_t of) { return bytes_.one_in(3) ? std::max<int64_t>(of >> bytes_.below(12), 1) : 0; }

  void add(const oracle::LatticePoint &at, int64_t radius) {
    if (set_.n() == most_) return;
    oracle::LatticePoint centre = offset_;
    for (size_t axis = 0; axis < 3; ++axis) {
      centre[axis] += at[axis];
      if (jitter_ > 0) centre[axis] += random_.in(-jitter_, jitter_);
      centre[axis] = std::clamp(centre[axis], -farthest, farthest);
    }
    set_.balls.push_back(oracle::ball_around(centre, std::clamp<int64_t>(radius, 0, farthest)));
  }

  oracle::LatticePoint along(const oracle::LatticeBall &direction, int64_t times) const {
    return {direction.x * times, direction.y * times, direction.z * times};
  }
  oracle::LatticeBall direction() { return pythagorean[bytes_.below(static_cast<uint32_t>(std::size(pythagorean)))]; }
  static int64_t rounded(double x) { return std::llround(x); }

  void add_piece() {
    const uint32_t kind = bytes_.below(11);
    const int64_t count = 1 + int64_t{bytes_.below(most_)};
    const int64_t radius = length(), spacing = length(), more = growth(radius);
    const oracle::LatticeBall way = direction();
    jitter_ = bytes_.one_in(3) ? length() : 0;
    offset_ = bytes_.one_in(3) ? along(direction(), length()) : oracle::LatticePoint{};
    switch (kind) {
      case 0:  // anywhere in a cube
        for (int64_t k = 0; k < count; ++k) {
          oracle::LatticePoint at{};
          for (int64_t &coordinate : at) coordinate = random_.in(-spacing, spacing);
          add(at, radius + (more > 0 ? random_.in(0, more) : 0));
        }
        break;
      case 1:  // on a line: of one size, or a cone; all of one centre with a spacing that is nearly none
        for (int64_t k = 0; k < count; ++k) add(along(way, k * spacing), radius + k * more);
        break;
      case 2:  // on a circle, or a spiral of radii
        for (int64_t k = 0; k < count; ++k) {
          const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
          const auto size = static_cast<double>(spacing);
          add({rounded(size * std::cos(angle)), rounded(size * std::sin(angle)), 0}, radius + k * more);
        }
        break;
      case 3:  // on a sphere, in a spiral
        for (int64_t k = 0; k < count; ++k) {
          const double z = (static_cast<double>(2 * k + 1) / static_cast<double>(count)) - 1.0;
          const double angle = 2.399963229728653 * static_cast<double>(k), flat = std::sqrt(1.0 - z * z);
          const auto size = static_cast<double>(spacing);
          add({rounded(size * flat * std::cos(angle)), rounded(size * flat * std::sin(angle)), rounded(size * z)},
              radius + (more > 0 ? random_.in(0, more) : 0));
        }
        break;
      case 4: {  // a lattice, cubic or face-centred
        const int64_t side = 1 + rounded(std::cbrt(static_cast<double>(count)));
        const bool centred = bytes_.one_in(2);
        for (int64_t k = 0; k < side * side * side; ++k) {
          const int64_t x = k % side, y = k / side % side, z = k / side / side;
          if (!centred || (x + y + z) % 2 == 0) add({x * spacing, y * spacing, z * spacing}, radius);
        }
        break;
      }
      case 5:  // around one centre
        for (int64_t k = 0; k < count; ++k) add({}, radius + k * std::max<int64_t>(more, 1));
        break;
      case 6:  // each in the one before: touching it in one point, or nearly
        for (int64_t k = 0; k < count; ++k) {
          add(along(way, k * spacing), (count - k) * spacing * way.radius + (more > 0 ? random_.in(-1, 1) : 0));
        }
        break;
      case 7:  // all spheres through one point
        for (int64_t k = 0; k < count; ++k) {
          const oracle::LatticeBall &to = pythagorean[static_cast<uint64_t>(k) % std::size(pythagorean)];
          const auto turn = static_cast<size_t>(k) / std::size(pythagorean);
          oracle::LatticePoint at{};
          for (size_t axis = 0; axis < 3; ++axis) {
            at[axis] = centre_of(to)[(axis + turn) % 3] * spacing * ((turn / 3 >> axis & 1U) != 0 ? -1 : 1);
          }
          add(at, to.radius * spacing);
        }
        break;
      case 9: {  // of one size around points of the lattice on a circle or a sphere: all spheres through two points, or
                 // all planes through one
        const int64_t step = 1 + int64_t{bytes_.below(16)};
        const bool sphere = bytes_.below(2) == 1;
        const int64_t squared = sphere ? 446 : int64_t{5} * 5 * 13 * 13 * 17 * 29 * 37;
        const int64_t largest = rounded(std::floor(std::sqrt(static_cast<double>(squared)))),
                      deep = sphere ? largest : 0;
        int64_t left = count;
        for (int64_t z = -deep; z <= deep; ++z) {
          for (int64_t x = -largest; x <= largest && left > 0; ++x) {
            const int64_t rest = squared - x * x - z * z;
            const int64_t y = rest < 0 ? -1 : rounded(std::sqrt(static_cast<double>(rest)));
            if (y < 0 || y * y != rest) continue;
            for (const int64_t side : {y, -y}) add({x * step, side * step, z * step}, radius * step);
            left -= 2;
          }
        }
        break;
      }
      case 10: {  // around one ball, whose planes with the others nearly go through one point
        const double height = bytes_.below(16) / 16.0, width = std::pow(10.0, -static_cast<double>(bytes_.below(5)));
        oracle::RandomSource random(random_.next());
        for (const oracle::LatticeBall &ball :
             oracle::balls_of_near_planes(random, static_cast<size_t>(count), radius, height, width)) {
          add(centre_of(ball), ball.radius);
        }
        break;
      }
      default: {  // copies of all so far, exact or not, here or aside, of the same radii or larger ones
        const uint32_t there = set_.n();
        const oracle::LatticePoint aside = offset_;
        const int64_t step = bytes_.one_in(2) ? spacing : 0;
        for (int64_t copy = 1; there > 0 && set_.n() < most_ && copy <= count; ++copy) {
          for (uint32_t i = 0; i < there; ++i) {
            const oracle::LatticeBall ball = set_.balls[i];
            for (size_t axis = 0; axis < 3; ++axis) offset_[axis] = aside[axis] + centre_of(ball)[axis];
            add(along(way, copy * step), ball.radius + copy * more);
          }
        }
      }
    }
  }

  Bytes &bytes_;
  uint32_t most_;
  support::Random random_;
  ScaledBalls set_;
  oracle::LatticePoint offset_{};
  int64_t jitter_ = 0;
};

}  // namespace fuzz
