#include "tiling.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace bench {
namespace {

constexpr double closest = 3.0;  // Angstrom, between centres of different copies
constexpr double step = 0.5;     // Angstrom, by which copies are pushed together

using Vector = std::array<double, 3>;

struct Box {
  Vector low{};
  Vector high{};
};

Box box_of(const Balls &balls) {
  Box box;
  for (size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = box.high[axis] = balls.xyz[axis];
    for (size_t i = axis; i < balls.xyz.size(); i += 3) {
      box.low[axis] = std::min(box.low[axis], balls.xyz[i]);
      box.high[axis] = std::max(box.high[axis], balls.xyz[i]);
    }
  }
  return box;
}

// The centres, shifted, that lie in the box grown by `closest`.
std::vector<Vector> centres_near(const Balls &balls, const Vector &shift, const Box &box) {
  std::vector<Vector> found;
  for (size_t i = 0; i < balls.xyz.size(); i += 3) {
    Vector centre{};
    bool inside = true;
    for (size_t axis = 0; axis < 3; ++axis) {
      centre[axis] = balls.xyz[i + axis] + shift[axis];
      inside = inside && centre[axis] >= box.low[axis] - closest && centre[axis] <= box.high[axis] + closest;
    }
    if (inside) found.push_back(centre);
  }
  return found;
}

// Whether a copy shifted so has a centre nearer than `closest` to one of the original.
bool too_close(const Balls &balls, const Box &box, const Vector &shift) {
  Box shifted = box;
  for (size_t axis = 0; axis < 3; ++axis) {
    shifted.low[axis] += shift[axis];
    shifted.high[axis] += shift[axis];
  }
  const std::vector<Vector> copy = centres_near(balls, shift, box);
  const std::vector<Vector> original = centres_near(balls, {}, shifted);
  for (const Vector &a : copy) {
    for (const Vector &b : original) {
      const double square =
          (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]);
      if (square < closest * closest) return true;
    }
  }
  return false;
}

// Whether any of the 26 neighbours on the lattice comes too close; by symmetry half of them are enough.
bool too_tight(const Balls &balls, const Box &box, const Vector &period) {
  for (int code = 14; code < 27; ++code) {
    const Vector shift{(code / 9 - 1) * period[0], (code / 3 % 3 - 1) * period[1], (code % 3 - 1) * period[2]};
    if (too_close(balls, box, shift)) return true;
  }
  return false;
}

// The box's size less as much as leaves no copies too close. Half the box stays: beyond that, copies that are not
// neighbours on the lattice would have to be looked at.
Vector tightest_period(const Balls &balls, const Box &box) {
  Vector period{};
  double most = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double size = box.high[axis] - box.low[axis];
    period[axis] = size + closest;
    most = axis == 0 ? size / 2 : std::min(most, size / 2);
  }
  for (double pushed = step; pushed <= most; pushed += step) {
    const Vector tighter{period[0] - step, period[1] - step, period[2] - step};
    if (too_tight(balls, box, tighter)) break;
    period = tighter;
  }
  return period;
}

}  // namespace

std::array<double, 3> tiling_period(const Balls &balls) {
  return tightest_period(balls, box_of(balls));
}

Balls tied_lattice(int side) {
  Balls one;
  one.name = "lattice";
  one.xyz = {0.0, 0.0, 0.0};
  one.radius = {1.8};
  return tiled(one, side);
}

Balls tiled(const Balls &balls, int copies) {
  const Vector period = tiling_period(balls);
  Balls all;
  all.name = balls.name + "_x" + std::to_string(copies * copies * copies);
  for (int x = 0; x < copies; ++x) {
    for (int y = 0; y < copies; ++y) {
      for (int z = 0; z < copies; ++z) {
        const Vector shift{x * period[0], y * period[1], z * period[2]};
        for (size_t i = 0; i < balls.xyz.size(); ++i) all.xyz.push_back(balls.xyz[i] + shift[i % 3]);
        all.radius.insert(all.radius.end(), balls.radius.begin(), balls.radius.end());
      }
    }
  }
  return all;
}

}  // namespace bench
