// The rows of a depth buffer under discs of random places, sizes and heights: what is hidden and how far floors are
// raised, by the kernels of each target, against the definition.
#include "view/depth_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "runnable_targets.hpp"

namespace {

constexpr uint32_t columns = 18, rows = 14, coarse_columns = 5, coarse_rows = 4;

struct Floor {
  std::array<float, columns * rows + 3> floor;
  std::array<uint8_t, coarse_columns * coarse_rows> stale;

  hsp::FloorCells cells() { return {floor.data(), columns, stale.data(), coarse_columns}; }
  bool operator==(const Floor &) const = default;
};

struct Case {
  Floor before;
  hsp::DiscCells disc;
  double base;
};

class Cases {
 public:
  Case next() {
    Case c{};
    const double radius = 1.0 + 5.0 * unit();
    const double x = columns * unit(), y = rows * unit();
    c.base = 8.0 * unit() - 4.0;
    c.disc = disc(x, y, radius);
    for (float &height : c.before.floor) height = static_cast<float>(c.base + 12.0 * unit() - 4.0);
    // Hidden for the most part, by now and then one cell is not; one that the disc does not meet may be below its base.
    if (unit() < 0.5) {
      for (float &height : c.before.floor) height = static_cast<float>(c.base + 1.01 * radius);
      c.before.floor[static_cast<size_t>(unit() * columns * rows)] =
          static_cast<float>(c.base + radius * (2.0 * unit() - 1.0));
    }
    return c;
  }

 private:
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  static hsp::DiscCells disc(double x, double y, double radius) {
    hsp::DiscCells cells{};
    const auto first = [](double low) { return static_cast<uint32_t>(std::max(0.0, low)); };
    const auto count = [&](double low, double high, uint32_t all) {
      return std::min(static_cast<uint32_t>(high) + 1, all) - first(low);
    };
    const auto nearest = [](double at, uint32_t cell) { return std::max({cell - at, at - (cell + 1.0), 0.0}); };
    cells.first_column = first(x - radius);
    cells.columns = count(x - radius, x + radius, columns);
    cells.first_row = first(y - radius);
    cells.rows = count(y - radius, y + radius, rows);
    for (uint32_t k = 0; k < cells.columns; ++k) {
      const double dx = nearest(x, cells.first_column + k);
      cells.squared[k] = dx * dx;
    }
    for (uint32_t k = cells.columns; k < hsp::DiscCells::most; ++k) {
      cells.squared[k] = std::numeric_limits<double>::infinity();
    }
    for (uint32_t k = 0; k < cells.rows; ++k) {
      const double dy = nearest(y, cells.first_row + k);
      cells.in_row[k] = radius * radius - dy * dy;
    }
    return cells;
  }

  std::mt19937_64 random_{5};
};

// Calls visit(column, row, height of the front above its centre) for the cells that the disc meets.
template <class Visit>
void visit_cells(const hsp::DiscCells &disc, Visit visit) {
  for (uint32_t r = 0; r < disc.rows; ++r) {
    for (uint32_t k = 0; k < disc.columns; ++k) {
      const double left_over = disc.in_row[r] - disc.squared[k];
      if (left_over > 0.0) visit(disc.first_column + k, disc.first_row + r, std::sqrt(left_over));
    }
  }
}

class DepthRows : public testing::TestWithParam<hsp::Target> {};

TEST_P(DepthRows, Hide) {
  Cases cases;
  int hidden = 0, seen = 0;
  for (int n = 0; n < 4000; ++n) {
    Case c = cases.next();
    bool expected = true;
    visit_cells(c.disc, [&](uint32_t column, uint32_t row, double height) {
      expected = expected && static_cast<double>(c.before.floor[row * columns + column]) > c.base + height;
    });
    ASSERT_EQ(hsp::hides(GetParam(), c.before.cells(), c.disc, c.base), expected) << n;
    ++(expected ? hidden : seen);
  }
  EXPECT_GT(hidden, 300);
  EXPECT_GT(seen, 300);
}

TEST_P(DepthRows, Raise) {
  constexpr double margin = 1e-9;
  Cases cases;
  for (int n = 0; n < 4000; ++n) {
    Case c = cases.next();
    Floor expected = c.before;
    visit_cells(c.disc, [&](uint32_t column, uint32_t row, double above) {
      const double height = c.base + above;
      const float lowered = static_cast<float>(height - 0x1p-22 * std::fabs(height) - margin);
      float &floor = expected.floor[row * columns + column];
      if (lowered <= floor) return;
      floor = lowered;
      expected.stale[row / hsp::coarse_side * coarse_columns + column / hsp::coarse_side] = 1;
    });
    hsp::raise(GetParam(), c.before.cells(), c.disc, c.base, margin);
    ASSERT_EQ(c.before.floor, expected.floor) << n;
    ASSERT_EQ(c.before.stale, expected.stale) << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, DepthRows, testing::ValuesIn(runnable_targets()));

}  // namespace
