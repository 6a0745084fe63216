#include "section_2/vertical_decomposition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <map>
#include <utility>

namespace bench {
namespace {

struct Interval {
  double low, high;
};

// A cube, or all of space.
struct Region {
  std::array<Interval, 3> side{};
  bool bounded = false;
};

// An arc of a slice from left to right: the lower or the upper half of a circle, or the floor or the lid of a cube.
using Arc = uint64_t;
constexpr Arc nothing = 0, floor_arc = 1, lid_arc = 2;
constexpr Arc lower_arc(size_t sphere) {
  return 2 * sphere + 4;
}
constexpr Arc upper_arc(size_t sphere) {
  return 2 * sphere + 5;
}
constexpr bool is_circle(Arc arc) {
  return arc >= 4;
}
constexpr bool is_upper(Arc arc) {
  return (arc & 1) != 0;
}

// The source of a wall: the end of a circle, or one of the crossings of two arcs.
struct Wall {
  enum Kind : uint32_t { region_begins, region_ends, circle_begins, circle_ends, crossing } kind;
  uint32_t first, second, which;
  friend auto operator<=>(const Wall &, const Wall &) = default;
};

struct Trapezoid {
  Arc bottom, top;
  Wall left, right;
  bool free;
  friend auto operator<=>(const Trapezoid &, const Trapezoid &) = default;
};

struct Slice {
  std::vector<Trapezoid> trapezoids;  // ascending
  uint64_t doubtful = 0;
};

class Slicer {
 public:
  Slicer(const std::vector<Sphere> &spheres, const Region &region)
      : spheres_(spheres), region_(region), radius_(spheres.size()) {}

  void cut(double x, Slice &slice) {
    slice_ = &slice;
    slice.trapezoids.clear();
    slice.doubtful = 0;
    find_circles(x);
    find_events();
    arcs_.clear();
    auto event = events_.begin();
    if (region_.bounded) {
      begin_at_side();
      while (event != events_.end() && event->y <= y_side().low) ++event;
    }
    left_.assign(arcs_.size() + 1, Wall{Wall::region_begins, 0, 0, 0});
    for (; event != events_.end() && (!region_.bounded || event->y < y_side().high); ++event) pass(*event);
    for (size_t gap = 0; gap <= arcs_.size(); ++gap) close(gap, Wall{Wall::region_ends, 0, 0, 0});
    std::sort(slice.trapezoids.begin(), slice.trapezoids.end());
  }

 private:
  struct Event {
    double y, z;
    Wall wall;
    Arc arc[2];  // of a crossing
  };

  const Interval &y_side() const { return region_.side[1]; }
  const Interval &z_side() const { return region_.side[2]; }

  void find_circles(double x) {
    circles_.clear();
    for (size_t i = 0; i < spheres_.size(); ++i) {
      const Sphere &s = spheres_[i];
      const double h = s.r * s.r - (x - s.x) * (x - s.x);
      if (h <= 0) continue;
      radius_[i] = std::sqrt(h);
      if (region_.bounded && (s.y + radius_[i] <= y_side().low || s.y - radius_[i] >= y_side().high)) continue;
      circles_.push_back(i);
    }
  }

  Arc half(size_t i, double z) const { return z > spheres_[i].z ? upper_arc(i) : lower_arc(i); }

  void find_events() {
    events_.clear();
    for (const size_t i : circles_) {
      const Sphere &s = spheres_[i];
      const uint32_t id = static_cast<uint32_t>(i);
      events_.push_back({s.y - radius_[i], s.z, {Wall::circle_begins, id, 0, 0}, {lower_arc(i), upper_arc(i)}});
      events_.push_back({s.y + radius_[i], s.z, {Wall::circle_ends, id, 0, 0}, {lower_arc(i), upper_arc(i)}});
      if (!region_.bounded) continue;
      for (const Arc plane : {floor_arc, lid_arc}) {
        const double z = plane == floor_arc ? z_side().low : z_side().high;
        const double h = radius_[i] * radius_[i] - (z - s.z) * (z - s.z);
        if (h <= 0) continue;
        for (const uint32_t which : {0U, 1U}) {
          const double y = which == 0 ? s.y - std::sqrt(h) : s.y + std::sqrt(h);
          events_.push_back({y, z, {Wall::crossing, id, static_cast<uint32_t>(plane), 2 + which}, {half(i, z), plane}});
        }
      }
    }
    for (size_t a = 0; a < circles_.size(); ++a) {
      for (size_t b = a + 1; b < circles_.size(); ++b) cross(circles_[a], circles_[b]);
    }
    std::sort(events_.begin(), events_.end(), [](const Event &a, const Event &b) { return a.y < b.y; });
  }

  void cross(size_t i, size_t j) {
    const Sphere &s = spheres_[i], &t = spheres_[j];
    const double dy = t.y - s.y, dz = t.z - s.z, d2 = dy * dy + dz * dz;
    const double sum = radius_[i] + radius_[j], difference = radius_[i] - radius_[j];
    if (d2 >= sum * sum || d2 <= difference * difference) return;
    const double along = (d2 + sum * difference) / (2 * d2);
    const double h = std::sqrt(std::max(0.0, radius_[i] * radius_[i] / d2 - along * along));
    for (const uint32_t which : {0U, 1U}) {
      const double side = which == 0 ? -h : h;
      const double z = s.z + along * dz + side * dy;
      const Wall wall{Wall::crossing, static_cast<uint32_t>(i), static_cast<uint32_t>(j), which};
      events_.push_back({s.y + along * dy - side * dz, z, wall, {half(i, z), half(j, z)}});
    }
  }

  double height(Arc arc, double y) const {
    if (arc == floor_arc) return z_side().low;
    if (arc == lid_arc) return z_side().high;
    const size_t i = static_cast<size_t>(arc / 2 - 2);
    const double d = y - spheres_[i].y;
    const double h = std::sqrt(std::max(0.0, radius_[i] * radius_[i] - d * d));
    return is_upper(arc) ? spheres_[i].z + h : spheres_[i].z - h;
  }

  void sort_arcs(double y) {
    std::sort(arcs_.begin(), arcs_.end(), [&](Arc a, Arc b) { return height(a, y) < height(b, y); });
  }

  // The arcs over the left side of a cube.
  void begin_at_side() {
    const double y = y_side().low;
    arcs_ = {floor_arc, lid_arc};
    for (const size_t i : circles_) {
      if (spheres_[i].y - radius_[i] > y || spheres_[i].y + radius_[i] <= y) continue;
      arcs_.push_back(lower_arc(i));
      arcs_.push_back(upper_arc(i));
    }
    sort_arcs(y);
  }

  size_t place_of(Arc arc) const {
    return static_cast<size_t>(std::find(arcs_.begin(), arcs_.end(), arc) - arcs_.begin());
  }

  // The trapezoid below arc number `gap` ends.
  void close(size_t gap, const Wall &right) {
    int depth = 0;
    bool within = !region_.bounded;
    for (size_t k = 0; k < gap; ++k) {
      if (is_circle(arcs_[k])) {
        depth += is_upper(arcs_[k]) ? -1 : 1;
      } else {
        within = arcs_[k] == floor_arc;
      }
    }
    if (!within) return;
    slice_->trapezoids.push_back(
        {gap > 0 ? arcs_[gap - 1] : nothing, gap < arcs_.size() ? arcs_[gap] : nothing, left_[gap], right, depth == 0});
  }

  void pass(const Event &event) {
    if (event.wall.kind == Wall::circle_begins) {
      size_t gap = 0;
      while (gap < arcs_.size() && height(arcs_[gap], event.y) < event.z) ++gap;
      close(gap, event.wall);
      arcs_.insert(arcs_.begin() + static_cast<std::ptrdiff_t>(gap), {event.arc[0], event.arc[1]});
      left_[gap] = event.wall;
      left_.insert(left_.begin() + static_cast<std::ptrdiff_t>(gap), 2, event.wall);
      return;
    }
    size_t low = place_of(event.arc[0]), high = place_of(event.arc[1]);
    const bool ends = event.wall.kind == Wall::circle_ends;
    if (low == arcs_.size() || high == arcs_.size()) {
      ++slice_->doubtful;
      return;
    }
    if (low > high && !ends) std::swap(low, high);
    if (high != low + 1) {
      ++slice_->doubtful;
      if (!ends) return;
      sort_arcs(event.y - 1e-9);
      low = place_of(event.arc[0]);
      if (place_of(event.arc[1]) != low + 1) return;
    }
    for (size_t gap = low; gap < low + 3; ++gap) close(gap, event.wall);
    if (ends) {
      const auto at = static_cast<std::ptrdiff_t>(low);
      arcs_.erase(arcs_.begin() + at, arcs_.begin() + at + 2);
      left_.erase(left_.begin() + at, left_.begin() + at + 2);
      left_[low] = event.wall;
    } else {
      std::swap(arcs_[low], arcs_[low + 1]);
      for (size_t gap = low; gap < low + 3; ++gap) left_[gap] = event.wall;
    }
  }

  const std::vector<Sphere> &spheres_;
  const Region region_;
  std::vector<double> radius_;   // of each circle
  std::vector<size_t> circles_;  // spheres that the slice meets
  std::vector<Event> events_;
  std::vector<Arc> arcs_;   // from below
  std::vector<Wall> left_;  // of the gap below each arc, and of the last gap
  Slice *slice_ = nullptr;
};

class CellCount {
 public:
  CellCount(const std::vector<Sphere> &spheres, Spheres kind, const Region &region)
      : spheres_(spheres), disjoint_(kind == Spheres::disjoint), region_(region), slicer_(spheres, region) {}

  DecompositionSize run() {
    const std::vector<double> abscissae = find_abscissae();
    Slice last, next;
    double last_x = 0;
    bool first = true;
    for (size_t k = 0; k + 1 < abscissae.size(); ++k) {
      const double low = abscissae[k], high = abscissae[k + 1];
      if (high - low < 1e-12) continue;
      if (disjoint_ && !region_.bounded) {
        slicer_.cut(0.5 * (low + high), next);
        add_new(last, next);
        std::swap(last, next);
        continue;
      }
      // Four slices, so that what begins and ends in between is seen.
      const double margin = 1e-4 * (high - low);
      for (int part = 0; part < 4; ++part) {
        const double x = low + margin + (high - low - 2 * margin) * part / 3;
        slicer_.cut(x, next);
        if (first || part == 0) {
          add_new(last, next);
        } else {
          refine(last_x, last, x, next);
        }
        first = false;
        std::swap(last, next);
        last_x = x;
      }
    }
    return size_;
  }

 private:
  // The abscissae where spheres and circles begin and end; for disjoint spheres also those where equators cross, and
  // where the sides of cubes are met.
  std::vector<double> find_abscissae() const {
    double low = region_.side[0].low, high = region_.side[0].high;
    if (!region_.bounded) {
      low = high = spheres_.empty() ? 0 : spheres_[0].x;
      for (const Sphere &s : spheres_) {
        low = std::min(low, s.x - s.r - 1);
        high = std::max(high, s.x + s.r + 1);
      }
    }
    std::vector<double> found{low, high};
    const auto add = [&](double x) {
      if (x > low && x < high) found.push_back(x);
    };
    const auto add_both = [&](double x, double squared) {
      if (squared <= 0) return;
      add(x - std::sqrt(squared));
      add(x + std::sqrt(squared));
    };
    for (const Sphere &s : spheres_) {
      add_both(s.x, s.r * s.r);
      add(s.x);
      if (!region_.bounded || !disjoint_) continue;
      for (const double z : {region_.side[2].low, region_.side[2].high})
        add_both(s.x, s.r * s.r - (z - s.z) * (z - s.z));
      for (const double y : {region_.side[1].low, region_.side[1].high})
        add_both(s.x, s.r * s.r - (y - s.y) * (y - s.y));
    }
    for (size_t i = 0; i < spheres_.size(); ++i) {
      for (size_t j = i + 1; j < spheres_.size(); ++j) add_pair(spheres_[i], spheres_[j], add);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  template <class Add>
  void add_pair(const Sphere &s, const Sphere &t, Add add) const {
    const double dx = t.x - s.x, dy = t.y - s.y, dz = t.z - s.z;
    const double sum = s.r + t.r, difference = s.r - t.r;
    const double d2 = dx * dx + dy * dy + dz * dz;
    if (d2 < sum * sum && d2 > difference * difference) {
      const double along = (d2 + sum * difference) / (2 * d2);
      const double reach = std::sqrt(std::max(0.0, (s.r * s.r - along * along * d2) * (1 - dx * dx / d2)));
      add(s.x + along * dx - reach);
      add(s.x + along * dx + reach);
    }
    const double p2 = dx * dx + dy * dy;
    if (disjoint_ && p2 < sum * sum && p2 > difference * difference) {
      const double along = (p2 + sum * difference) / (2 * p2);
      const double side = std::sqrt(std::max(0.0, s.r * s.r / p2 - along * along));
      add(s.x + along * dx - side * dy);
      add(s.x + along * dx + side * dy);
    }
  }

  // Counts the trapezoids that were not there before.
  void add_new(const Slice &before, const Slice &now) {
    auto at = before.trapezoids.begin();
    for (const Trapezoid &trapezoid : now.trapezoids) {
      while (at != before.trapezoids.end() && *at < trapezoid) ++at;
      if (at != before.trapezoids.end() && *at == trapezoid) continue;
      ++size_.cells;
      size_.free += trapezoid.free ? 1 : 0;
    }
    size_.doubtful += now.doubtful;
  }

  void refine(double low, const Slice &before, double high, const Slice &now) {
    if (before.trapezoids == now.trapezoids) return;
    if (high - low < 1e-7) return add_new(before, now);
    Slice middle;
    const double x = 0.5 * (low + high);
    slicer_.cut(x, middle);
    refine(low, before, x, middle);
    refine(x, middle, high, now);
  }

  const std::vector<Sphere> &spheres_;
  const bool disjoint_;
  const Region region_;
  Slicer slicer_;
  DecompositionSize size_;
};

}  // namespace

DecompositionSize decomposition_of_space(const std::vector<Sphere> &spheres, Spheres kind) {
  return CellCount(spheres, kind, {}).run();
}

DecompositionSize decomposition_in_cubes(const std::vector<Sphere> &spheres, Spheres kind) {
  constexpr double origin = 0.123456;  // no side goes through a centre
  double side = 0;
  for (const Sphere &s : spheres) side = std::max(side, 2 * s.r);
  std::map<std::array<int, 3>, std::vector<Sphere>> cubes;
  const auto interval = [&](int k) { return Interval{origin + k * side, origin + (k + 1) * side}; };
  for (const Sphere &s : spheres) {
    const std::array<double, 3> centre{s.x, s.y, s.z};
    std::array<int, 3> first{}, last{};
    for (size_t axis = 0; axis < 3; ++axis) {
      first[axis] = static_cast<int>(std::floor((centre[axis] - s.r - origin) / side));
      last[axis] = static_cast<int>(std::floor((centre[axis] + s.r - origin) / side));
    }
    std::array<int, 3> at{};
    for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) {
      for (at[1] = first[1]; at[1] <= last[1]; ++at[1]) {
        for (at[2] = first[2]; at[2] <= last[2]; ++at[2]) {
          double squared = 0;
          for (size_t axis = 0; axis < 3; ++axis) {
            const Interval range = interval(at[axis]);
            const double gap = centre[axis] - std::clamp(centre[axis], range.low, range.high);
            squared += gap * gap;
          }
          if (squared < s.r * s.r) cubes[at].push_back(s);
        }
      }
    }
  }
  DecompositionSize sum;
  for (const auto &[at, met] : cubes) {
    const DecompositionSize size =
        CellCount(met, kind, {{interval(at[0]), interval(at[1]), interval(at[2])}, true}).run();
    sum.cells += size.cells;
    sum.free += size.free;
    sum.doubtful += size.doubtful;
  }
  return sum;
}

std::vector<Sphere> figure_4(uint32_t n) {
  std::vector<Sphere> spheres;
  const uint32_t half = n / 2;
  const double step = 0.5 / half;
  for (uint32_t k = 0; k < half; ++k) spheres.push_back({k * step, 0, -1.5 - 2.001 * k, 1});
  for (uint32_t k = 0; k < n - half; ++k) spheres.push_back({1, -1 + k * step, 1.5 + 2.001 * k, 1});
  return spheres;
}

}  // namespace bench
