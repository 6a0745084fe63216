// Labels beside discs and at the ends of lines, among discs at random: that none touches another one, its line or a box
// is seen from points of all of them, and that no two lines cross from the signs of areas; the grid in front is looked
// at cell by cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

extern "C" {
#include "draw/label_places.h"
#include "draw/text_width.h"
}

namespace {

using Point = std::array<double, 2>;

constexpr double side = 600, letters = 14, apart = 0.3;

// Balls of a page that is looked at along z, y down.
struct Discs {
  std::vector<double> xyz, radius;
  molecule of{};
  front_grid grid{};
  std::vector<bond> bonds;
  shown_bodies bodies{};

  Discs(std::mt19937 &random, size_t count, double largest, size_t sticks, double from_edge = 60) {
    std::uniform_real_distribution<double> across(from_edge, side - from_edge), size(largest / 2, largest);
    for (size_t k = 0; k < count; ++k) {
      for (int axis = 0; axis < 3; ++axis) xyz.push_back(across(random));
      radius.push_back(size(random));
    }
    for (size_t k = 0; k + 1 < count && k < sticks; ++k) {
      bond own{};
      own.atom[0] = static_cast<uint32_t>(k);
      own.atom[1] = static_cast<uint32_t>(k + 1);
      bonds.push_back(own);
    }
    of.xyz = xyz.data();
    of.radius = radius.data();
    of.atoms = static_cast<uint32_t>(count);
    bodies.molecule = &of;
    bodies.share = 1;
    bodies.bond = bonds.data();
    bodies.bonds = static_cast<uint32_t>(bonds.size());
    bodies.stick = 3;
    const double low[2] = {0, 0}, high[2] = {side, side};
    EXPECT_TRUE(front_grid_make(&grid, low, high, 1.5));
    page_axes axes{};
    for (int k = 0; k < 3; ++k) axes.row[k][k] = 1;
    front_grid_show(&grid, &bodies, &axes, 1);
  }
  ~Discs() { front_grid_free(&grid); }
  Discs(const Discs &) = delete;
  Discs &operator=(const Discs &) = delete;

  [[nodiscard]] placed_label label(uint32_t atom, bool needs_line) const {
    placed_label label{};
    label.text = "ABC12";
    label.atom = atom;
    for (size_t k = 0; k < 2; ++k) label.at[k] = label.centre[k] = xyz[3 * atom + k];
    label.radius = radius[atom];
    label.seen = radius[atom];
    label.needs_line = needs_line;
    return label;
  }
};

// The body that lies highest over a point, of all in turn.
uint32_t highest_at(const Discs &discs, const Point &at) {
  uint32_t owner = FRONT_GRID_NOTHING;
  double height = -1e300;
  const auto offer = [&](double z, uint32_t body) {
    if (z > height) height = z, owner = body;
  };
  for (uint32_t k = 0; k < discs.of.atoms; ++k) {
    const double *const centre = discs.of.xyz + 3 * size_t{k};
    const double from = std::hypot(at[0] - centre[0], at[1] - centre[1]);
    if (from < discs.radius[k]) offer(centre[2] + std::sqrt(discs.radius[k] * discs.radius[k] - from * from), k);
  }
  for (const bond &own : discs.bonds) {
    const double *const a = discs.of.xyz + 3 * size_t{own.atom[0]}, *const b = discs.of.xyz + 3 * size_t{own.atom[1]};
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const Point along{(b[0] - a[0]) / length, (b[1] - a[1]) / length};
    const double so_far = (at[0] - a[0]) * along[0] + (at[1] - a[1]) * along[1];
    const double aside = (at[0] - a[0]) * along[1] - (at[1] - a[1]) * along[0];
    if (so_far < 0 || so_far > length || std::fabs(aside) > 3) continue;
    const uint32_t half = own.atom[so_far < length / 2 ? 0 : 1];
    offer(a[2] + so_far / length * (b[2] - a[2]) + 3, half | FRONT_GRID_STICK);
  }
  return owner;
}

TEST(FrontGrid, HasWhatIsHighestInEachCell) {
  for (unsigned seed = 0; seed < 2; ++seed) {
    std::mt19937 random(seed);
    const Discs discs(random, 25, 50, seed % 2 == 0 ? 0 : 24);
    size_t different = 0;
    for (int32_t row = 0; row < discs.grid.rows; ++row) {
      for (int32_t column = 0; column < discs.grid.columns; ++column) {
        const Point at{(column + 0.5) * discs.grid.cell, (row + 0.5) * discs.grid.cell};
        if (front_grid_body(&discs.grid, at[0], at[1]) != highest_at(discs, at)) ++different;
      }
    }
    EXPECT_LE(different, 2U);  // borders that rounding decides
  }
}

double side_of(const Point &a, const Point &b, const Point &c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
bool cross(const Point &a, const Point &b, const Point &c, const Point &d) {
  return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}
bool lies_in(const Point &at, const double box[4]) {
  return at[0] > box[0] && at[0] < box[2] && at[1] > box[1] && at[1] < box[3];
}

// The two parts of a label's line, or nothing.
std::vector<std::array<Point, 2>> line_of(const placed_label &label) {
  if (!label.has_line) return {};
  const Point from{label.from[0], label.from[1]}, knee{label.knee[0], label.knee[1]}, at{label.at[0], label.at[1]};
  return {{from, knee}, {knee, at}};
}
std::vector<Point> points_of(const placed_label &label) {
  std::vector<Point> points;
  for (const auto &[from, to] : line_of(label)) {
    for (int k = 0; k <= 200; ++k) {
      points.push_back({from[0] + k / 200.0 * (to[0] - from[0]), from[1] + k / 200.0 * (to[1] - from[1])});
    }
  }
  return points;
}
bool apart_from(const double a[4], const double b[4]) {
  return a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
}
// Level, upright or at 45 degrees.
bool is_plain(const Point &from, const Point &to) {
  const double x = std::fabs(to[0] - from[0]), y = std::fabs(to[1] - from[1]);
  return x < 1e-9 || y < 1e-9 || std::fabs(x - y) < 1e-9;
}

class LabelPlaces : public testing::TestWithParam<unsigned> {};

TEST_P(LabelPlaces, TouchNothing) {
  std::mt19937 random(GetParam());
  const size_t count = std::array<size_t, 3>{8, 25, 60}[GetParam() % 3];
  const Discs discs(random, count, 30, GetParam() % 2 == 0 ? 0 : count);
  std::vector<placed_label> labels;
  for (uint32_t k = 0; k < count; ++k) labels.push_back(discs.label(k, (k + GetParam()) % 2 == 0));
  const double boxes[2][4] = {{0, 0, 150, 60}, {side - 200, side - 40, side, side}};
  selection everything = SELECTION_EVERYTHING;
  const label_page page{&discs.grid, &discs.of, &everything, {0, 0}, {side, side}, letters, apart};
  size_t placed = 0;
  ASSERT_TRUE(label_places_find(&page, boxes, 2, labels.data(), count, &placed));
  EXPECT_EQ(placed, static_cast<size_t>(std::count_if(labels.begin(), labels.end(),
                                                      [](const placed_label &one) { return label_is_placed(&one); })));
  EXPECT_GE(placed, count / 2);
  for (const placed_label &one : labels) {
    if (!label_is_placed(&one)) continue;
    EXPECT_NEAR(one.box[2] - one.box[0], text_width("ABC12", letters), 1e-9);
    EXPECT_TRUE(one.box[0] >= 0 && one.box[1] >= 0 && one.box[2] <= side && one.box[3] <= side);
    EXPECT_TRUE(one.has_line || !one.needs_line);
    for (const double *const box : {boxes[0], boxes[1]}) EXPECT_TRUE(apart_from(one.box, box));
    for (const auto &[from, to] : line_of(one)) EXPECT_TRUE(is_plain(from, to));
    for (const Point &at : points_of(one)) {
      for (const double *const box : {boxes[0], boxes[1], one.box}) EXPECT_FALSE(lies_in(at, box));
    }
    // Beside a disc no other body is under the letters.
    for (double x = one.box[0]; !one.has_line && x <= one.box[2]; x += 1) {
      for (double y = one.box[1]; y <= one.box[3]; y += 1) {
        const uint32_t owner = front_grid_owner(&discs.grid, x, y);
        EXPECT_TRUE(owner == FRONT_GRID_NOTHING || owner == one.atom) << "label of " << one.atom;
      }
    }
  }
  for (size_t i = 0; i < count; ++i) {
    for (size_t j = 0; j < count; ++j) {
      const placed_label &one = labels[i], &other = labels[j];
      if (i == j || !label_is_placed(&one) || !label_is_placed(&other)) continue;
      EXPECT_TRUE(apart_from(one.box, other.box)) << i << " and " << j;
      for (const Point &at : points_of(one)) ASSERT_FALSE(lies_in(at, other.box)) << i << " over " << j;
      for (const auto &[a, b] : line_of(one)) {
        for (const auto &[c, d] : line_of(other)) EXPECT_FALSE(cross(a, b, c, d)) << i << " and " << j;
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Pages, LabelPlaces, testing::Range(0U, 12U));

// One disc alone has its label beside it, to the right, and at the end of the shortest line if it needs one.
TEST(LabelPlaces, OneAloneHasTheFirstPlace) {
  std::mt19937 random(1);
  const Discs discs(random, 1, 20, 0, 250);
  selection everything = SELECTION_EVERYTHING;
  const label_page page{&discs.grid, &discs.of, &everything, {0, 0}, {side, side}, letters, apart};
  for (const bool needs_line : {false, true}) {
    placed_label label = discs.label(0, needs_line);
    size_t placed = 0;
    ASSERT_TRUE(label_places_find(&page, nullptr, 0, &label, 1, &placed));
    ASSERT_EQ(placed, 1U);
    EXPECT_EQ(label.has_line, needs_line);
    if (needs_line) {
      const double length = std::hypot(label.from[0] - label.at[0], label.from[1] - label.at[1]);
      EXPECT_GT(length, label.radius - 6);
      EXPECT_LT(length, label.radius + 12);
    } else {
      EXPECT_GT(label.box[0], label.centre[0] + label.radius);
      EXPECT_LT(label.box[0], label.centre[0] + label.radius + letters);
      EXPECT_NEAR((label.box[1] + label.box[3]) / 2, label.centre[1], 1);
    }
  }
}

// Where a box leaves no room for letters there is no label.
TEST(LabelPlaces, NoRoomNoLabel) {
  std::mt19937 random(2);
  const Discs discs(random, 1, 20, 0);
  selection everything = SELECTION_EVERYTHING;
  const label_page page{&discs.grid, &discs.of, &everything, {0, 0}, {side, side}, letters, apart};
  placed_label label = discs.label(0, false);
  const double all[1][4] = {{0, 0, side, side}};
  size_t placed = 7;
  ASSERT_TRUE(label_places_find(&page, all, 1, &label, 1, &placed));
  EXPECT_EQ(placed, 0U);
  EXPECT_FALSE(label_is_placed(&label));
}

}  // namespace
