#include "flood_fill.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "disjoint_sets.hpp"

namespace oracle {
namespace {

// The largest integer whose square is at most a number.
int64_t floor_root(int64_t square) {
  auto root = static_cast<int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

struct Reach {
  int64_t nearest;
  int64_t farthest;
};

// How far the points of low .. low + side are from a number.
Reach reach(int64_t low, int64_t side, int64_t from) {
  const int64_t before = low - from;
  const int64_t after = from - (low + side);
  return {std::max({before, after, int64_t{0}}), std::max(-before, -after)};
}

size_t columns_between(int64_t low, int64_t high, int64_t side) {
  return static_cast<size_t>(std::max<int64_t>(1, (high - low + side - 1) / side));
}

void include(Box &box, const LatticePoint &low, const LatticePoint &high) {
  for (size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], low[k]);
    box.high[k] = std::max(box.high[k], high[k]);
  }
}

}  // namespace

Box box_around(const Balls &balls, int64_t margin) {
  if (balls.empty()) return {};
  Box box;
  for (size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint centre = centre_of(balls[i]);
    const int64_t radius = balls[i].radius;
    const LatticePoint low = {centre[0] - radius, centre[1] - radius, centre[2] - radius};
    const LatticePoint high = {centre[0] + radius, centre[1] + radius, centre[2] + radius};
    if (i == 0) box = {low, high};
    include(box, low, high);
  }
  for (size_t k = 0; k < 3; ++k) {
    box.low[k] -= margin;
    box.high[k] += margin;
  }
  return box;
}

FloodFill::FloodFill(const Balls &balls, const Box &box, int64_t side)
    : box_(box),
      side_(side),
      columns_x_(columns_between(box.low[0], box.high[0], side)),
      columns_y_(columns_between(box.low[1], box.high[1], side)) {
  if (side <= 0 || side % 2 != 0) throw std::invalid_argument("columns need a middle");
  Balls by_x = balls;
  std::sort(by_x.begin(), by_x.end());
  int64_t largest = 0;
  for (const LatticeBall &ball : by_x) largest = std::max(largest, ball.radius);

  std::vector<std::vector<Interval>> met(columns_y_);      // by each column of a slab of equal x, by any ball
  std::vector<std::vector<Interval>> covered(columns_y_);  // by one ball
  for (size_t i = 0; i < columns_x_; ++i) {
    const int64_t x = box_.low[0] + static_cast<int64_t>(i) * side_;
    auto ball = std::lower_bound(by_x.begin(), by_x.end(), x - largest,
                                 [](const LatticeBall &b, int64_t value) { return b.x < value; });
    for (; ball != by_x.end() && ball->x <= x + side_ + largest; ++ball) {
      const int64_t weight = ball->radius * ball->radius;
      const Reach in_x = reach(x, side_, ball->x);
      const int64_t rest = weight - in_x.nearest * in_x.nearest;
      if (rest < 0) continue;
      const int64_t half_width = floor_root(rest) + 1;
      const auto place = [&](int64_t y) {
        return std::clamp<int64_t>((y - box_.low[1]) / side_, 0, static_cast<int64_t>(columns_y_) - 1);
      };
      for (int64_t j = place(ball->y - half_width); j <= place(ball->y + half_width); ++j) {
        const Reach in_y = reach(box_.low[1] + j * side_, side_, ball->y);
        const int64_t near = rest - in_y.nearest * in_y.nearest;
        if (near < 0) continue;
        const int64_t root = floor_root(near);
        const int64_t above = root * root == near ? root : root + 1;
        met[static_cast<size_t>(j)].push_back({ball->z - above, ball->z + above});
        const int64_t far = weight - in_x.farthest * in_x.farthest - in_y.farthest * in_y.farthest;
        if (far < 0) continue;
        const int64_t below = floor_root(far);
        covered[static_cast<size_t>(j)].push_back({ball->z - below, ball->z + below});
      }
    }
    for (size_t j = 0; j < columns_y_; ++j) {
      append_gaps(met[j], 2, certain_);  // so that a whole height lies inside
      append_gaps(covered[j], 1, perhaps_);
    }
  }
  certain_.first.push_back(certain_.runs.size());
  perhaps_.first.push_back(perhaps_.runs.size());
  join_runs(certain_);
  join_runs(perhaps_);
  find_regions_around();
}

// The next column's runs are the gaps between closed intervals, but for the shortest. Takes the intervals.
void FloodFill::append_gaps(std::vector<Interval> &closed, int64_t shortest, Layer &layer) const {
  layer.first.push_back(layer.runs.size());
  std::sort(closed.begin(), closed.end(), [](const Interval &a, const Interval &b) { return a.low < b.low; });
  int64_t free_from = box_.low[2];
  for (const Interval &interval : closed) {
    const int64_t to = std::min(interval.low, box_.high[2]);
    if (to - free_from >= shortest) layer.runs.push_back({free_from, to, 0});
    free_from = std::max(free_from, interval.high);
  }
  if (box_.high[2] - free_from >= shortest) layer.runs.push_back({free_from, box_.high[2], 0});
  closed.clear();
}

void FloodFill::join_runs(Layer &layer) const {
  DisjointSets sets(layer.runs.size());
  const auto join_columns = [&](size_t a, size_t b) {
    size_t k = layer.first[a];
    size_t m = layer.first[b];
    while (k < layer.first[a + 1] && m < layer.first[b + 1]) {
      const Run &p = layer.runs[k];
      const Run &q = layer.runs[m];
      if (std::max(p.low, q.low) < std::min(p.high, q.high)) sets.join(k, m);
      if (p.high < q.high)
        ++k;
      else
        ++m;
    }
  };
  for (size_t i = 0; i < columns_x_; ++i)
    for (size_t j = 0; j < columns_y_; ++j) {
      if (i > 0) join_columns(i * columns_y_ + j, (i - 1) * columns_y_ + j);
      if (j > 0) join_columns(i * columns_y_ + j, i * columns_y_ + j - 1);
    }

  const std::vector<uint32_t> numbers = sets.numbers();
  for (size_t column = 0; column + 1 < layer.first.size(); ++column) {
    const size_t i = column / columns_y_;
    const size_t j = column % columns_y_;
    const bool at_side = i == 0 || i + 1 == columns_x_ || j == 0 || j + 1 == columns_y_;
    const LatticePoint corner = {box_.low[0] + static_cast<int64_t>(i) * side_,
                                 box_.low[1] + static_cast<int64_t>(j) * side_, 0};
    for (size_t k = layer.first[column]; k < layer.first[column + 1]; ++k) {
      Run &run = layer.runs[k];
      run.region = numbers[k];
      const LatticePoint low = {corner[0], corner[1], run.low};
      const LatticePoint high = {corner[0] + side_, corner[1] + side_, run.high};
      if (run.region == layer.regions.size()) {
        layer.regions.emplace_back();
        layer.regions.back().extent = {low, high};
      }
      Region &region = layer.regions[run.region];
      include(region.extent, low, high);
      region.reaches_border = region.reaches_border || at_side || run.low == box_.low[2] || run.high == box_.high[2];
      region.volume += static_cast<long double>(side_) * static_cast<long double>(side_) *
                       static_cast<long double>(run.high - run.low);
      if (run.high - run.low > region.longest) {
        region.longest = run.high - run.low;
        region.point = middle(column, run);
      }
    }
  }
}

void FloodFill::find_regions_around() {
  for (Region &region : certain_.regions) {
    region.perhaps = perhaps_at(region.point).value();
    ++perhaps_.regions[region.perhaps].certain;
  }
}

LatticePoint FloodFill::middle(size_t column, const Run &run) const {
  return {box_.low[0] + static_cast<int64_t>(column / columns_y_) * side_ + side_ / 2,
          box_.low[1] + static_cast<int64_t>(column % columns_y_) * side_ + side_ / 2,
          run.low + (run.high - run.low) / 2};
}

std::optional<uint32_t> FloodFill::region_at(const Layer &layer, const LatticePoint &point) const {
  if (point[0] < box_.low[0] || point[1] < box_.low[1]) return std::nullopt;
  const auto i = static_cast<size_t>((point[0] - box_.low[0]) / side_);
  const auto j = static_cast<size_t>((point[1] - box_.low[1]) / side_);
  if (i >= columns_x_ || j >= columns_y_) return std::nullopt;
  const size_t column = i * columns_y_ + j;
  for (size_t k = layer.first[column]; k < layer.first[column + 1]; ++k)
    if (layer.runs[k].low < point[2] && point[2] < layer.runs[k].high) return layer.runs[k].region;
  return std::nullopt;
}

std::vector<FloodFill::Sample> FloodFill::certain_samples() const {
  std::vector<Sample> samples;
  for (size_t column = 0; column + 1 < certain_.first.size(); ++column)
    for (size_t k = certain_.first[column]; k < certain_.first[column + 1]; ++k)
      samples.push_back({middle(column, certain_.runs[k]), certain_.runs[k].region});
  return samples;
}

}  // namespace oracle
