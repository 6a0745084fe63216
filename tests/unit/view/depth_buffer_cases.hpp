// The floor of depths: never above the highest front, by points; where it must lie, by hand; and the same in whatever
// order balls raise it.
#pragma once

#include <cmath>
#include <initializer_list>
#include <limits>

#include "cases.hpp"
#include "view/depth_buffer.hpp"

namespace cases {

// In memory of fixed size, for at most four balls.
class SmallFloor {
 public:
  static constexpr uint32_t most_balls = 4;

  SmallFloor(const hsp::BoundingBox &box, double extent, double largest) : workspace_(memory_, sizeof memory_) {
    floor_.carve(workspace_, most_balls);
    floor_.lay_out(box, extent, largest);
  }
  SmallFloor(const SmallFloor &) = delete;
  ~SmallFloor() { hsp::unpoison(memory_, sizeof memory_); }

  hsp::DepthBuffer &floor() { return floor_; }
  // The height of a floor, found by bisection: below it, is_below(height) holds.
  template <class Below>
  static double height(double low, double high, Below is_below) {
    for (int k = 0; k < 100; ++k) {
      const double middle = (low + high) / 2;
      (is_below(middle) ? low : high) = middle;
    }
    return low;
  }
  // The floor at a point as a ball of next to no size meets it, and the lowest one around the point.
  double at(double x, double y, double extent) {
    return height(-9 * extent, 9 * extent, [&](double z) { return floor_.hides({x, y, z, 0.0}); });
  }
  double around(double x, double y, double extent) {
    const hsp::BoundingBox point{x, x, y, y};
    return height(-9 * extent, 9 * extent, [&](double z) { return floor_.is_above(point, z); });
  }

 private:
  alignas(64) unsigned char memory_[32 * 1024];
  hsp::Workspace workspace_;
  hsp::DepthBuffer floor_;
};

struct Discs {
  uint32_t n;
  hsp::ProjectedBall disc[4];
  uint32_t least;  // points of 32 x 32 at which there must be a floor
};
constexpr Discs disc_sets[] = {{1, {{0, 0, 0, 100}}, 500},
                               {1, {{1e6, -1e6, 3e6, 100}}, 500},
                               {2, {{0, 0, 0, 100}, {60, 20, 80, 100}}, 300},
                               {3, {{0, 0, 0, 100}, {60, 20, 80, 50}, {-150, 70, -90, 30}}, 150},
                               {4, {{0, 0, 0, 100}, {1, 0, 1, 100}, {0, 90, 0, 100}, {-90, 0, -50, 100}}, 300},
                               // Too far apart for small cells.
                               {2, {{0, 0, 0, 100}, {9e5, 9e5, 0, 100}}, 0},
                               {2, {{-200, 300, 7, 100}, {3e3, -2e3, 0, 90}}, 0},
                               // Far wider than cells are for.
                               {2, {{0, 0, 0, 600}, {0, 0, 580, 40}}, 700}};

inline double extent_of(const Discs &c) {
  double extent = 0;
  for (uint32_t k = 0; k < c.n; ++k) {
    for (const double length : {c.disc[k].x, c.disc[k].y, c.disc[k].z}) {
      extent = std::fmax(extent, std::fabs(length) + c.disc[k].r);
    }
  }
  return extent;
}
inline hsp::BoundingBox box_around(const Discs &c) {
  if (c.n == 0) return {};
  constexpr double infinite = std::numeric_limits<double>::infinity();
  hsp::BoundingBox box{infinite, -infinite, infinite, -infinite};
  for (uint32_t k = 0; k < c.n; ++k) {
    const hsp::ProjectedBall &disc = c.disc[k];
    box = {std::fmin(box.left, disc.x - disc.r), std::fmax(box.right, disc.x + disc.r),
           std::fmin(box.bottom, disc.y - disc.r), std::fmax(box.top, disc.y + disc.r)};
  }
  return box;
}

// At most the highest front, wherever there is one, and else below all balls.
inline uint32_t floors_lie_below_fronts() {
  return first_failing(disc_sets, [](const Discs &c) {
    const double extent = extent_of(c);
    const hsp::BoundingBox box = box_around(c);
    SmallFloor small(box, extent, 100);
    for (uint32_t k = 0; k < c.n; ++k) small.floor().raise(c.disc[k]);
    uint32_t found = 0;
    for (int row = 0; row < 32; ++row) {
      for (int column = 0; column < 32; ++column) {
        const double x = box.left + (box.right - box.left) * (column + .5) / 32;
        const double y = box.bottom + (box.top - box.bottom) * (row + .5) / 32;
        double front = -3 * extent;
        for (uint32_t k = 0; k < c.n; ++k) {
          const hsp::ProjectedBall &disc = c.disc[k];
          const double dx = x - disc.x, dy = y - disc.y, squared = disc.r * disc.r - dx * dx - dy * dy;
          if (squared >= 0.0) front = std::fmax(front, disc.z + std::sqrt(squared));
        }
        const double floor = small.at(x, y, extent);
        if (floor > front || small.around(x, y, extent) > floor) return false;
        if (floor > -2 * extent) ++found;
      }
    }
    return found >= c.least;
  });
}

// Cells have a fifth of the largest radius as their side. A ball of radius 100 in the middle of one or on a corner.
struct Cell {
  hsp::ProjectedBall disc, asked;
  bool hidden;
};
constexpr Cell cells[] = {
    // On a corner of four cells of side 20: the floor around it is that above their other corners, 20 sqrt 2 away.
    {{0, 0, 0, 100}, {0, 0, 95.9 - 1, 1}, true},
    {{0, 0, 0, 100}, {0, 0, 95.92 - 1, 1}, false},
    {{0, 0, 7, 100}, {0, 0, 102.9 - 1, 1}, true},
    {{0, 0, 7, 100}, {0, 0, 102.92 - 1, 1}, false},
    // In the middle of a cell, 10 sqrt 2 from its corners.
    {{10, 10, 0, 100}, {10, 10, 98.9 - 5, 5}, true},
    {{10, 10, 0, 100}, {10, 10, 99 - 5, 5}, false},
    // A disc that reaches into the next column, whose far corners are 10 and 30 away. Its own front is lower there, by
    // 5 - 3 = 2.
    {{10, 10, 0, 100}, {16, 10, 96.8 - 5, 5}, true},
    {{10, 10, 0, 100}, {16, 10, 96.9 - 5, 5}, false},
    // A cell of the rim is not filled.
    {{0, 0, 0, 100}, {88, 0, -50, 2}, false},
    {{0, 0, 0, 100}, {70, 30, -50, 2}, true},
    // A ball smaller than a cell fills none.
    {{10, 10, 0, 14}, {10, 10, -50, 2}, false},
    {{10, 10, 0, 14.2}, {10, 10, -50, 2}, true}};

inline uint32_t floors_by_hand() {
  return first_failing(cells, [](const Cell &c) {
    SmallFloor small({-200, 200, -200, 200}, 300, 100);
    if (small.floor().hides(c.asked)) return false;
    small.floor().raise(c.disc);
    if (small.floor().hides(c.asked) != c.hidden) return false;
    // A hidden ball stays so, whatever raises the floor.
    small.floor().raise({c.disc.x, c.disc.y, c.disc.z - 30, c.disc.r});
    return small.floor().hides(c.asked) == c.hidden;
  });
}

// Discs that meet more cells than are looked at together: one that is hidden is so at all of its points.
inline uint32_t hidden_large_discs_are_hidden_everywhere() {
  Random random(7);
  uint32_t hidden = 0, shown = 0;
  for (uint32_t round = 0; round < 400; ++round) {
    SmallFloor small({0, 1200, 0, 1200}, 2000, 100);
    const auto part = [&random] { return 100.0 * static_cast<double>(random.below(9)); };
    for (uint32_t k = 0; k < 3; ++k) small.floor().raise({200 + part(), 200 + part(), 100, 300 + part()});
    const hsp::ProjectedBall asked{250 + 0.9 * part(), 250 + 0.9 * part(), -400, 200 + 0.1 * part()};
    if (!small.floor().hides(asked)) {
      ++shown;
      continue;
    }
    ++hidden;
    for (double v = -asked.r; v <= asked.r; v += 15) {
      for (double u = -asked.r; u <= asked.r; u += 15) {
        const double squared = asked.r * asked.r - u * u - v * v;
        if (squared < 0.0) continue;
        if (!small.floor().hides({asked.x + u, asked.y + v, asked.z + std::sqrt(squared), 0.0})) return round;
      }
    }
  }
  return hidden > 20 && shown > 20 ? all_hold : 1000;
}

// The lowest floor of coarse cells, 80 wide from -80 on, above which a ball of radius 100 fills the one around (40, 40)
// up to its corners, 40 sqrt 2 away.
struct Box {
  hsp::BoundingBox box;
  double height;
  bool above;
};
constexpr Box boxes[] = {
    {{40, 40, 40, 40}, 82.4, true}, {{40, 40, 40, 40}, 82.5, false}, {{1, 79, 1, 79}, 82.4, true},
    {{1, 79, 1, 79}, 82.5, false},  {{1, 81, 1, 79}, -290, false},   {{-1, 79, 1, 79}, -290, false},
    {{1, 79, 1, 81}, -290, false},  {{1, 79, -1, 79}, -290, false},  {{-40, -40, 40, 40}, -290, false}};

inline uint32_t floors_of_boxes() {
  return first_failing(boxes, [](const Box &c) {
    SmallFloor small({-80, 240, -80, 240}, 300, 100);
    if (small.floor().is_above(c.box, -290)) return false;
    small.floor().raise({40, 40, 0, 100});
    return small.floor().is_above(c.box, c.height) == c.above;
  });
}

// is_above() says of a box what hides() says of balls all over it, after every ball that raises the floor: the floors
// of coarse cells and tiles are never too high, and are looked after when too low.
inline uint32_t boxes_know_what_has_been_raised() {
  Random random(11);
  SmallFloor small({0, 1200, 0, 1200}, 2000, 100);
  const hsp::BoundingBox whole{150, 1100, 150, 1100};
  for (uint32_t round = 0; round < 6; ++round) {
    for (int row = 0; row < 25; ++row) {
      for (int column = 0; column < 25; ++column) {
        small.floor().raise({column * 50.0, row * 50.0, 100.0 * round, 100});
        const double x = 80.0 * static_cast<double>(random.below(15));
        const double y = 80.0 * static_cast<double>(random.below(15));
        const double height = 100.0 * static_cast<double>(random.below(round + 2));
        bool above = true;  // each of the cells, at its middle, above which a front of next to no size lies
        for (double v = y + 10; v < y + 80; v += 20) {
          for (double u = x + 10; u < x + 80; u += 20) {
            above = above && small.floor().hides({u, v, height, 0.0});
          }
        }
        if (small.floor().is_above({x + 10, x + 70, y + 10, y + 70}, height) != above) return round;
      }
    }
    if (!small.floor().is_above(whole, 100.0 * round + 10) || small.floor().is_above(whole, 100.0 * round + 100)) {
      return 10 + round;
    }
  }
  return all_hold;
}

// A floor over the first tile of 16 x 16 cells, 320 wide, and a part of the next one above or to the right.
inline uint32_t tiles_know_their_own_floors() {
  constexpr bool swaps[] = {false, true};
  return first_failing(swaps, [](bool swap) {
    SmallFloor small({0, 1200, 0, 1200}, 2000, 100);
    for (double v = 0; v <= 400; v += 50) {
      for (double u = 0; u <= 320; u += 50) small.floor().raise({swap ? v : u, swap ? u : v, 0, 100});
    }
    const auto is_above = [&](double left, double right, double bottom, double top) {
      return small.floor().is_above(
          swap ? hsp::BoundingBox{bottom, top, left, right} : hsp::BoundingBox{left, right, bottom, top}, 0);
    };
    return is_above(10, 310, 10, 310) && is_above(10, 70, 330, 390) && !is_above(10, 70, 570, 630) &&
           is_above(10, 310, 10, 390);
  });
}

// Balls that have heights next to 0, which differ by less than the depths of the centres can tell.
inline uint32_t the_order_of_raising_has_no_effect() {
  constexpr double extent = 1e7;
  constexpr double side = 4e5;  // of 2 cells
  constexpr double margin = 0x1p-43 * extent;
  hsp::BoundingBox box;
  box.left = box.bottom = -side;  // the first 4 x 4 cells lie around the discs' centre
  box.right = box.top = 10 * side;
  Random random(5);
  for (uint32_t round = 0; round < 2000; ++round) {
    hsp::ProjectedBall disc[2];
    for (hsp::ProjectedBall &each : disc) {
      const double r = 570000.0 + random.below(430000);
      const double R = r - 4 * margin;
      const double front = std::sqrt(R * R * (1.0 - 0x1p-40) - side * side - side * side);
      each = {0.0, 0.0, 4 * margin - front + random.below(1000) * 1e-12, r};
    }
    double found[2];
    for (uint32_t first = 0; first < 2; ++first) {
      SmallFloor small(box, extent, 1e6);
      small.floor().raise(disc[first]);
      small.floor().raise(disc[1 - first]);
      found[first] = SmallFloor::height(-1, 1, [&](double z) { return small.floor().is_above({}, z); });
    }
    if (!(found[0] > -1e-4) || found[0] != found[1]) return round;  // the heights are indeed next to 0
  }
  return all_hold;
}

inline constexpr Check view_depth_buffer[] = {
    {"floors_lie_below_fronts", floors_lie_below_fronts},
    {"floors_by_hand", floors_by_hand},
    {"hidden_large_discs_are_hidden_everywhere", hidden_large_discs_are_hidden_everywhere},
    {"floors_of_boxes", floors_of_boxes},
    {"boxes_know_what_has_been_raised", boxes_know_what_has_been_raised},
    {"tiles_know_their_own_floors", tiles_know_their_own_floors},
    {"the_order_of_raising_has_no_effect", the_order_of_raising_has_no_effect}};

}  // namespace cases
