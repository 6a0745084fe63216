#include "section_3/range_tree.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

// Where a range of points is cut in two.
uint32_t middle(uint32_t first, uint32_t last) {
  return first + (last - first) / 2;
}

}  // namespace

void RangeTree::build(const support::BallList &balls) {
  if (balls.size() > INT32_MAX) throw std::length_error("too many balls for a range tree");
  balls_ = balls;
  largest_radius_ = 0;
  for (const double radius : balls.radius) largest_radius_ = std::max(largest_radius_, radius);
  nodes_.clear();
  y_.clear();
  entries_.clear();
  const auto sorted_by = [&](size_t axis) {
    Points points(balls.size());
    std::iota(points.begin(), points.end(), 0U);
    std::sort(points.begin(), points.end(), [&](uint32_t a, uint32_t b) { return centre(a)[axis] < centre(b)[axis]; });
    return points;
  };
  by_x_ = sorted_by(0);
  x_.clear();
  for (const uint32_t point : by_x_) x_.push_back(centre(point)[0]);
  rank_.resize(balls.size());
  if (balls.size() > 0) build_node({0, balls.size()}, sorted_by(1), sorted_by(2));
}

uint32_t RangeTree::build_node(Interval points, Points by_y, Points by_z) {
  const uint32_t number = static_cast<uint32_t>(nodes_.size());
  nodes_.push_back({points.first, points.last, 0, 0, y_.size(), entries_.size()});
  if (nodes_[number].size() <= leaf) return number;
  for (uint32_t place = 0; place < by_y.size(); ++place) {
    y_.push_back(centre(by_y[place])[1]);
    rank_[by_y[place]] = place;
  }
  build_layers(nodes_[number], by_z);

  // Both orders, of the points of each half.
  const uint32_t cut = middle(points.first, points.last);
  for (uint32_t place = points.first; place < points.last; ++place) rank_[by_x_[place]] = place;
  std::array<Points, 2> half_y, half_z;
  for (const uint32_t point : by_y) half_y[rank_[point] < cut ? 0 : 1].push_back(point);
  for (const uint32_t point : by_z) half_z[rank_[point] < cut ? 0 : 1].push_back(point);
  Points().swap(by_y);
  Points().swap(by_z);
  const uint32_t left = build_node({points.first, cut}, std::move(half_y[0]), std::move(half_z[0]));
  const uint32_t right = build_node({cut, points.last}, std::move(half_y[1]), std::move(half_z[1]));
  nodes_[number].left = left;
  nodes_[number].right = right;
  return number;
}

// Builds a tree level by level: a node's points in the order of z, parted by their rank in y, are its children's points
// in the order of z. rank_ holds the rank in y.
void RangeTree::build_layers(const Node &node, const Points &by_z) {
  std::vector<Interval> parts{{0, node.size()}};
  Points points = by_z;
  Points next(points.size());
  while (!parts.empty()) {
    std::vector<Interval> children;
    const size_t level = entries_.size();
    entries_.resize(level + node.size(), {0, 0});
    for (const Interval &part : parts) {
      const uint32_t cut = middle(part.first, part.last);
      uint32_t to_left = part.first;
      uint32_t to_right = cut;
      for (uint32_t place = part.first; place < part.last; ++place) {
        const uint32_t point = points[place];
        entries_[level + place] = {point, to_left - part.first};
        next[rank_[point] < cut ? to_left++ : to_right++] = point;
      }
      if (part.last - part.first > leaf) children.insert(children.end(), {{part.first, cut}, {cut, part.last}});
    }
    points.swap(next);
    parts = std::move(children);
  }
}

// The places of the values low .. high.
RangeTree::Interval RangeTree::find(const std::vector<double> &sorted, size_t begin, size_t size, double low,
                                    double high) const {
  const auto first = sorted.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = first + static_cast<std::ptrdiff_t>(size);
  return {static_cast<uint32_t>(std::lower_bound(first, last, low) - first),
          static_cast<uint32_t>(std::upper_bound(first, last, high) - first)};
}

void RangeTree::meeting(const double *centre_of_query, double radius, Hits &hits) const {
  if (nodes_.empty()) return;
  const double x = centre_of_query[0], y = centre_of_query[1], z = centre_of_query[2];
  // Padded, so that rounding loses no ball.
  const double reach = (radius + largest_radius_) * (1 + 1e-9) + 1e-9 * largest_radius_;
  const Box box{{x - reach, y - reach, z - reach}, {x + reach, y + reach, z + reach}};
  auto test = [&](uint32_t point) {
    const double *c = centre(point);
    const double dx = c[0] - x, dy = c[1] - y, dz = c[2] - z, sum = balls_.radius[point] + radius;
    hits.ids[std::min(hits.count, hits.capacity - 1)] = point;
    hits.count += dx * dx + dy * dy + dz * dz <= sum * sum ? 1 : 0;
  };
  const Interval wanted = find(x_, 0, x_.size(), box.low[0], box.high[0]);
  if (!wanted.empty()) visit_node(nodes_.front(), wanted, box, test);
}

template <class Visit>
void RangeTree::visit_node(const Node &node, const Interval &wanted, const Box &box, Visit &visit) const {
  if (wanted.first >= node.last || wanted.last <= node.first) return;
  if (node.size() <= leaf) {
    const uint32_t last = std::min(node.last, wanted.last);
    for (uint32_t place = std::max(node.first, wanted.first); place < last; ++place) visit(by_x_[place]);
  } else if (wanted.first <= node.first && node.last <= wanted.last) {
    const Interval in_y = find(y_, node.by_y, node.size(), box.low[1], box.high[1]);
    if (in_y.empty()) return;
    const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(node.layers);
    const auto last = first + static_cast<std::ptrdiff_t>(node.size());
    const auto low = std::lower_bound(first, last, box.low[2],
                                      [&](const Entry &entry, double z) { return centre(entry.point)[2] < z; });
    const auto high = std::upper_bound(low, last, box.high[2],
                                       [&](double z, const Entry &entry) { return z < centre(entry.point)[2]; });
    visit_layers(node, node.layers, {0, node.size()}, in_y,
                 {static_cast<uint32_t>(low - first), static_cast<uint32_t>(high - first)}, visit);
  } else {
    visit_node(nodes_[node.left], wanted, box, visit);
    visit_node(nodes_[node.right], wanted, box, visit);
  }
}

// The points of `part`, a node of the tree over y, that are among `wanted` by y and have the places by_z of the part.
template <class Visit>
void RangeTree::visit_layers(const Node &node, size_t level, Interval part, const Interval &wanted, Interval by_z,
                             Visit &visit) const {
  if (by_z.empty() || wanted.first >= part.last || wanted.last <= part.first) return;
  const Entry *const entries = entries_.data() + level + part.first;
  const uint32_t size = part.last - part.first;
  if (size <= leaf || (wanted.first <= part.first && part.last <= wanted.last)) {
    // A leaf's points may lie beside the box in y: they are no hits then.
    for (uint32_t place = by_z.first; place < by_z.last; ++place) visit(entries[place].point);
    return;
  }
  const uint32_t cut = middle(part.first, part.last);
  const auto to_left = [&](uint32_t place) { return place == size ? cut - part.first : entries[place].to_left; };
  const Interval left{to_left(by_z.first), to_left(by_z.last)};
  const Interval right{by_z.first - left.first, by_z.last - left.last};
  visit_layers(node, level + node.size(), {part.first, cut}, wanted, left, visit);
  visit_layers(node, level + node.size(), {cut, part.last}, wanted, right, visit);
}

size_t RangeTree::bytes() const {
  return bytes_of(balls_.xyz) + bytes_of(balls_.radius) + bytes_of(by_x_) + bytes_of(x_) + bytes_of(nodes_) +
         bytes_of(y_) + bytes_of(entries_);
}

}  // namespace bench
