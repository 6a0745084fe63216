// The connected parts of the space that some balls leave free, bounded from both sides by the cells of a grid around
// the balls. Free cells are free as a whole, and are joined across common sides: each part of free cells lies within
// one part of space. Touched cells are not covered as a whole, and are joined at common corners too: each part of space
// lies within one part of touched cells. Middle cells have a free middle, and are joined across sides: their volume is
// about that of the free space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

class FreeCells {
 public:
  static constexpr size_t none = SIZE_MAX;
  struct Part {
    double volume = 0.0;
    bool outside = false;
  };

  // The longest side of the box around the balls is divided into `parts` cells.
  FreeCells(const Balls &balls, int parts) {
    std::array<double, 3> high{-1e300, -1e300, -1e300};
    low_ = {1e300, 1e300, 1e300};
    for (const LatticeBall &ball : balls) {
      const std::array<double, 3> c = centre(ball);
      for (size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], c[k] - static_cast<double>(ball.radius));
        high[k] = std::max(high[k], c[k] + static_cast<double>(ball.radius));
      }
    }
    side_ = std::max({high[0] - low_[0], high[1] - low_[1], high[2] - low_[2]}) / parts;
    for (size_t k = 0; k < 3; ++k) {
      low_[k] -= 2.0 * side_;
      count_[k] = static_cast<int>((high[k] - low_[k]) / side_) + 3;
    }
    const double reach = 0.5 * std::sqrt(3.0) * side_ + 2.0;
    std::vector<bool> free, touched, middles;
    for (int z = 0; z < count_[2]; ++z) {
      for (int y = 0; y < count_[1]; ++y) {
        for (int x = 0; x < count_[0]; ++x) {
          const std::array<double, 3> at{low_[0] + (x + 0.5) * side_, low_[1] + (y + 0.5) * side_,
                                         low_[2] + (z + 0.5) * side_};
          bool is_free = true, is_touched = true, is_middle = true;
          for (const LatticeBall &ball : balls) {
            const std::array<double, 3> c = centre(ball);
            const double dx = c[0] - at[0], dy = c[1] - at[1], dz = c[2] - at[2], square = dx * dx + dy * dy + dz * dz;
            const double r = static_cast<double>(ball.radius);
            is_free = is_free && square > (r + reach) * (r + reach);
            is_middle = is_middle && square > r * r;
            is_touched = is_touched && (r <= reach || square > (r - reach) * (r - reach));
            if (!is_touched) break;
          }
          free.push_back(is_free);
          touched.push_back(is_touched);
          middles.push_back(is_middle);
        }
      }
    }
    flood(free, false, free_);
    flood(touched, true, touched_);
    flood(middles, false, middles_);
  }

  // The part that the cell of a point is in, or none.
  size_t free_at(const std::array<double, 3> &point) const { return part_at(free_, point); }
  size_t touched_at(const std::array<double, 3> &point) const { return part_at(touched_, point); }
  size_t middle_at(const std::array<double, 3> &point) const { return part_at(middles_, point); }
  const Part &middle_part(size_t part) const { return middles_.parts[part]; }
  const Part &free_part(size_t part) const { return free_.parts[part]; }
  const Part &touched_part(size_t part) const { return touched_.parts[part]; }

 private:
  struct Flooded {
    std::vector<size_t> part_of;
    std::vector<Part> parts;
  };
  static std::array<double, 3> centre(const LatticeBall &ball) {
    return {static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)};
  }
  size_t number(int x, int y, int z) const {
    return (static_cast<size_t>(z) * static_cast<size_t>(count_[1]) + static_cast<size_t>(y)) *
               static_cast<size_t>(count_[0]) +
           static_cast<size_t>(x);
  }
  size_t part_at(const Flooded &flooded, const std::array<double, 3> &point) const {
    std::array<int, 3> cell;
    for (size_t k = 0; k < 3; ++k) {
      const double at = std::floor((point[k] - low_[k]) / side_);
      cell[k] = static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count_[k] - 1)));
    }
    return flooded.part_of[number(cell[0], cell[1], cell[2])];
  }
  void flood(const std::vector<bool> &open, bool corners, Flooded &flooded) const {
    flooded.part_of.assign(open.size(), none);
    std::vector<std::array<int, 3>> stack;
    for (int z = 0; z < count_[2]; ++z) {
      for (int y = 0; y < count_[1]; ++y) {
        for (int x = 0; x < count_[0]; ++x) {
          if (!open[number(x, y, z)] || flooded.part_of[number(x, y, z)] != none) continue;
          Part part;
          stack.push_back({x, y, z});
          flooded.part_of[number(x, y, z)] = flooded.parts.size();
          while (!stack.empty()) {
            const std::array<int, 3> cell = stack.back();
            stack.pop_back();
            part.volume += side_ * side_ * side_;
            for (int d = 0; d < 27; ++d) {
              const std::array<int, 3> step{d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
              if (!corners && std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]) != 1) continue;
              std::array<int, 3> next;
              bool inside = true;
              for (size_t k = 0; k < 3; ++k) {
                next[k] = cell[k] + step[k];
                inside = inside && next[k] >= 0 && next[k] < count_[k];
              }
              if (!inside) {
                part.outside = true;
                continue;
              }
              const size_t id = number(next[0], next[1], next[2]);
              if (!open[id] || flooded.part_of[id] != none) continue;
              flooded.part_of[id] = flooded.parts.size();
              stack.push_back(next);
            }
          }
          flooded.parts.push_back(part);
        }
      }
    }
  }

  std::array<double, 3> low_;
  std::array<int, 3> count_{};
  double side_ = 0.0;
  Flooded free_, touched_, middles_;
};

}  // namespace oracle
