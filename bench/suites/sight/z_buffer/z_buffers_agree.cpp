// z_buffers_agree: a test that the two z-buffers, which share nothing but where the balls are placed, see the same
// balls, and that the analytic one sees what a search through all balls finds. On crambin, from several directions.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "paper_molecules.hpp"
#include "z_buffer/analytic_z_buffer.hpp"
#include "z_buffer/placement.hpp"
#include "z_buffer/triangle_z_buffer.hpp"

namespace {

int failures = 0;

void expect(bool holds, const char *what, double figure) {
  if (!holds) ++failures;
  std::printf("%-60s %10.5f %s\n", what, figure, holds ? "" : "FAILED");
}

// How high ball i is over the centre of pixel (x, y); NaN beside its disc.
double height(const bench::PlacedBalls &balls, size_t i, int x, int y) {
  const double dx = x + 0.5 - static_cast<double>(balls.x[i]);
  const double dy = y + 0.5 - static_cast<double>(balls.y[i]);
  const double radius = static_cast<double>(balls.radius[i]);
  return static_cast<double>(balls.z[i]) + std::sqrt(radius * radius - dx * dx - dy * dy);
}

// The share of wrong owners among some 20,000 pixels. An owner is wrong if trying all balls finds one that is higher
// there by more than a hundredth of a pixel, or if its stored depth is off by as much. At a rim rounding decides
// whether a pixel belongs to the disc at all.
double wrong_part(const bench::PlacedBalls &balls, const bench::AnalyticZBuffer &image) {
  int wrong = 0;
  int tried = 0;
  for (int y = 3; y < bench::image_side; y += 7) {
    for (int x = 5; x < bench::image_side; x += 7) {
      double best = -INFINITY;
      for (size_t i = 0; i < balls.radius.size(); ++i) best = std::fmax(best, height(balls, i, x, y));
      const uint32_t owner = image.owner(x, y);
      const double seen = owner == bench::no_owner ? -INFINITY : height(balls, owner, x, y);
      ++tried;
      const bool stored = owner == bench::no_owner || std::fabs(static_cast<double>(image.depth(x, y)) - seen) < 0.01;
      if (!stored || !(seen == best || seen > best - 0.01)) ++wrong;
    }
  }
  return static_cast<double>(wrong) / tried;
}

struct Agreement {
  double owners = 0;  // part of the pixels that either of them covers with the same owner in both
  double worst_light = 0;
};

Agreement compare(const bench::PlacedBalls &balls, const bench::AnalyticZBuffer &a, const bench::TriangleZBuffer &b) {
  int covered = 0;
  int same = 0;
  Agreement agreement;
  for (int y = 0; y < bench::image_side; ++y) {
    for (int x = 0; x < bench::image_side; ++x) {
      const uint32_t owner = a.owner(x, y);
      if (owner == bench::no_owner && b.owner(x, y) == bench::no_owner) continue;
      ++covered;
      if (owner != b.owner(x, y)) continue;
      ++same;
      // The lamp is where the viewer is: light goes with the height over the ball's centre.
      const double steepness = static_cast<double>((a.depth(x, y) - balls.z[owner]) / balls.radius[owner]);
      agreement.worst_light = std::max(agreement.worst_light, std::fabs(b.light(x, y) - 40 - 215 * steepness));
    }
  }
  agreement.owners = static_cast<double>(same) / covered;
  return agreement;
}

void test() {
  const bench::Molecule crambin = bench::paper_molecules().at(2);
  const bench::Balls balls = bench::with_radii(crambin, bench::Radii::paper);
  bench::Placement placement(balls.xyz, balls.radius);
  bench::AnalyticZBuffer analytic;
  bench::TriangleZBuffer coarse(10, 6);
  bench::TriangleZBuffer fine(240, 144);
  expect(coarse.triangles() == 100, "triangles of a ball", static_cast<double>(coarse.triangles()));
  for (const std::array<double, 3> &direction : bench::spread_directions(3)) {
    const bench::Axes axes = bench::axes_towards(direction);
    const bench::PlacedBalls &placed = placement.place(axes);
    analytic.draw(placed);
    coarse.draw(placed, axes);
    fine.draw(placed, axes);
    const double wrong = wrong_part(placed, analytic);
    expect(wrong < 0.0002, "analytic: wrong owners", wrong);
    const Agreement far = compare(placed, analytic, coarse);
    const Agreement near = compare(placed, analytic, fine);
    expect(far.owners > 0.9, "100 triangles: same owners", far.owners);
    expect(near.owners > 0.999, "fine mesh: same owners", near.owners);
    expect(near.worst_light < 5, "fine mesh: largest difference of light", near.worst_light);
  }
}

}  // namespace

int main() {
  test();
  return failures == 0 ? 0 : 1;
}
