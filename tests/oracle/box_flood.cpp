#include "box_flood.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

using Shift = std::array<int, 3>;

uint32_t rank_of(const std::vector<Shift> &ways) {
  const auto cross = [](const Shift &u, const Shift &v) {
    return Shift{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const auto is_zero = [](const Shift &v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; };
  if (ways.empty()) return 0;
  const Shift &first = ways[0];
  const auto second = std::find_if(ways.begin(), ways.end(), [&](const Shift &w) { return !is_zero(cross(first, w)); });
  if (second == ways.end()) return 1;
  const Shift normal = cross(first, *second);
  return std::any_of(ways.begin(), ways.end(),
                     [&](const Shift &w) { return normal[0] * w[0] + normal[1] * w[1] + normal[2] * w[2] != 0; })
             ? 3
             : 2;
}

struct Component {
  uint32_t directions;
  size_t cells;
};

// The components of open cells. Each cell remembers the copy of the box in which it was first reached. A cell that is
// reached again in another copy shows that the component goes on for ever along the difference of the two copies.
std::vector<Component> components_of(const std::vector<bool> &open, int parts, bool corners) {
  const auto number = [&](const Shift &c) { return static_cast<size_t>((c[2] * parts + c[1]) * parts + c[0]); };
  std::vector<bool> seen(open.size());
  std::vector<Shift> copy(open.size());
  std::vector<Component> components;
  for (size_t start = 0; start < open.size(); ++start) {
    if (!open[start] || seen[start]) continue;
    std::vector<Shift> ways, stack;
    size_t cells = 0;
    const int at = static_cast<int>(start);
    stack.push_back({at % parts, at / parts % parts, at / parts / parts});
    seen[start] = true;
    copy[start] = {0, 0, 0};
    while (!stack.empty()) {
      const Shift cell = stack.back();
      stack.pop_back();
      ++cells;
      for (int d = 0; d < 27; ++d) {
        const Shift step{d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
        if (!corners && std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]) != 1) continue;
        Shift next, there = copy[number(cell)];
        for (size_t k = 0; k < 3; ++k) {
          next[k] = (cell[k] + step[k] + parts) % parts;
          there[k] += cell[k] + step[k] < 0 ? -1 : cell[k] + step[k] >= parts ? 1 : 0;
        }
        const size_t id = number(next);
        if (!open[id]) continue;
        if (seen[id]) {
          Shift way;
          for (size_t k = 0; k < 3; ++k) way[k] = there[k] - copy[id][k];
          if (way != Shift{0, 0, 0} && std::find(ways.begin(), ways.end(), way) == ways.end()) ways.push_back(way);
          continue;
        }
        seen[id] = true;
        copy[id] = there;
        stack.push_back(next);
      }
    }
    components.push_back({rank_of(ways), cells});
  }
  return components;
}

// Which cells are free as a whole, and which are not covered as a whole.
struct Cells {
  std::vector<bool> free, touched;
};

Cells cells_of(const Balls &balls, const BoxRows &box, double level, int parts) {
  double reach = 2.0;
  for (const LatticePoint &side : box) {
    reach += 0.5 / parts *
             std::hypot(static_cast<double>(side[0]), static_cast<double>(side[1]), static_cast<double>(side[2]));
  }
  std::vector<LatticeBall> all;
  for (int a = -2; a <= 2; ++a) {
    for (int b = -2; b <= 2; ++b) {
      for (int c = -2; c <= 2; ++c) {
        for (const LatticeBall &ball : balls) all.push_back(moved_by(ball, box, {a, b, c}));
      }
    }
  }
  Cells cells;
  for (int k = 0; k < parts; ++k) {
    for (int j = 0; j < parts; ++j) {
      for (int i = 0; i < parts; ++i) {
        const auto place = [&](size_t axis) {
          const auto side = [&](size_t v, int m) { return static_cast<double>(box[v][axis]) * (m + 0.5) / parts; };
          return side(0, i) + side(1, j) + side(2, k);
        };
        const double x = place(0), y = place(1), z = place(2);
        double least = 1e300;
        for (const LatticeBall &ball : all) {
          least = std::min(least, std::hypot(static_cast<double>(ball.x) - x, static_cast<double>(ball.y) - y,
                                             static_cast<double>(ball.z) - z) -
                                      static_cast<double>(ball.radius));
        }
        cells.free.push_back(least > level + reach);
        cells.touched.push_back(least > level - reach);
      }
    }
  }
  return cells;
}

}  // namespace

DirectionBounds free_directions(const Balls &balls, const BoxRows &box, double level, int parts) {
  const Cells cells = cells_of(balls, box, level, parts);
  const auto most = [&](const std::vector<bool> &open, bool corners) {
    uint32_t directions = 0;
    for (const Component &each : components_of(open, parts, corners))
      directions = std::max(directions, each.directions);
    return directions;
  };
  return {most(cells.free, false), most(cells.touched, true)};
}

VolumeBounds free_volumes(const Balls &balls, const BoxRows &box, double level, int parts) {
  const Cells cells = cells_of(balls, box, level, parts);
  const auto volumes = [&](const std::vector<bool> &open, bool corners) {
    std::vector<double> sorted;
    for (const Component &each : components_of(open, parts, corners)) {
      sorted.push_back(static_cast<double>(each.cells) / (static_cast<double>(parts) * parts * parts));
    }
    std::sort(sorted.rbegin(), sorted.rend());
    return sorted;
  };
  return {volumes(cells.free, false), volumes(cells.touched, true)};
}

}  // namespace oracle
