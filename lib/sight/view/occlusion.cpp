#include "view/occlusion.hpp"

#include <limits>

#include "core/ahead.hpp"
#include "core/extremes.hpp"
#include "core/rows.hpp"

namespace hsp {
namespace {

constexpr uint32_t most_buckets = 256;
constexpr uint8_t raised = 2;  // in visible[]: a ball that has raised the floor
constexpr double infinite = std::numeric_limits<double>::infinity();

// The number as a float that is no larger; and, below, as one that is no smaller.
float rounded_down(double a) {
  return static_cast<float>(a - 0x1p-23 * std::fabs(a));
}
float rounded_up(double a) {
  return static_cast<float>(a + 0x1p-23 * std::fabs(a));
}

// The box of some balls in the space of a view.
struct Extent {
  BoundingBox box{infinite, -infinite, infinite, -infinite};
  double lowest_top = infinite, highest_top = -infinite;

  void widen(const Extent &other) {
    box.left = smaller_of(box.left, other.box.left);
    box.right = larger_of(box.right, other.box.right);
    box.bottom = smaller_of(box.bottom, other.box.bottom);
    box.top = larger_of(box.top, other.box.top);
    lowest_top = smaller_of(lowest_top, other.lowest_top);
    highest_top = larger_of(highest_top, other.highest_top);
  }
  bool empty() const { return highest_top < lowest_top; }
};

ProjectedBall placed(const BallSet &balls, const ViewFrame &frame, uint32_t i) {
  const Vec3 centre = frame.centre_of(balls, i);
  return {centre.x, centre.y, centre.z, balls.r[i]};
}

}  // namespace

void OcclusionCuller::carve(Workspace &workspace, uint32_t balls) {
  floor_.carve(workspace, balls);
  extent_ = workspace.take<CubeExtent>(balls);
  bucket_ = workspace.take<uint32_t>(most_buckets + 1);
  order_ = workspace.take<uint32_t>(balls);
}

// One pass over all balls. False if there is nothing that could hide anything.
bool OcclusionCuller::prepare(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible, Patience &patience) {
  constexpr CubeExtent nothing{0.0F, 0.0F, 0.0F, 0.0F, -std::numeric_limits<float>::infinity()};
  const BallSet &balls = grid.balls();
  Extent all;
  double extent = 0.0;
  double largest = 0.0, squares = 0.0;
  uint32_t seen = 0;
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const BallRange own = grid.balls_in(cube);
    if (!patience.allows(100 + 50 * uint64_t{own.last - own.first})) return false;
    Extent here;
    for (uint32_t i = own.first; i < own.last; ++i) {
      if (visible[i] == 0) continue;
      const ProjectedBall disc = placed(balls, frame, i);
      const double top = disc.z + disc.r;
      here.widen({{disc.x - disc.r, disc.x + disc.r, disc.y - disc.r, disc.y + disc.r}, top, top});
      extent = larger_of(extent, std::fabs(disc.x) + std::fabs(disc.y) + std::fabs(disc.z) + disc.r);
      largest = larger_of(largest, disc.r);
      squares += disc.r * disc.r;
      ++seen;
    }
    all.widen(here);
    extent_[cube] = here.empty() ? nothing
                                 : CubeExtent{rounded_down(here.box.left), rounded_up(here.box.right),
                                              rounded_down(here.box.bottom), rounded_up(here.box.top),
                                              rounded_up(here.highest_top)};
  }
  if (largest == 0.0) return false;
  lowest_top_ = all.lowest_top;
  highest_top_ = all.highest_top;
  // Cells that suit most balls where few are far larger; all discs together meet O(n) cells.
  floor_.lay_out(all.box, extent, smaller_of(largest, 2 * std::sqrt(squares / seen)));
  return true;
}

// Sorts the cubes that hold balls not left out, the highest first.
void OcclusionCuller::order_cubes(uint32_t cubes) {
  const double spread = highest_top_ - lowest_top_;
  const double scale = spread > 0.0 ? static_cast<double>(most_buckets) / spread : 0.0;
  // The cube's bucket; most_buckets if all its balls are left out. Heights are rounded upwards.
  const auto bucket_of = [&](uint32_t cube) {
    const double top = static_cast<double>(extent_[cube].height);
    if (top < lowest_top_) return most_buckets;
    const double bucket = (highest_top_ - top) * scale;
    if (bucket >= most_buckets - 1) return most_buckets - 1;
    return bucket > 0.0 ? static_cast<uint32_t>(bucket) : 0U;
  };
  ordered_ =
      sort_to_rows(bucket_, most_buckets, cubes, bucket_of, [this](uint32_t at, uint32_t cube) { order_[at] = cube; });
}

bool OcclusionCuller::hide(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible, Patience &patience) {
  const BallSet &balls = grid.balls();
  if (!patience.allows(0)) return false;
  if (!prepare(grid, frame, visible, patience)) return patience.allows(0);
  order_cubes(grid.cubes());
  for (uint32_t k = 0; k < ordered_; ++k) {
    if (k + ahead::extents < ordered_) __builtin_prefetch(&extent_[order_[k + ahead::extents]]);
    const CubeExtent &extent = extent_[order_[k]];
    const BoundingBox box{extent.left, extent.right, extent.bottom, extent.top};
    if (floor_.is_above(box, extent.height)) continue;
    const BallRange own = grid.balls_in(order_[k]);
    for (uint32_t i = own.first; i < own.last; ++i) {
      if (visible[i] == 0) continue;
      if (!patience.allows(1000)) return false;
      const ProjectedBall disc = placed(balls, frame, i);
      if (floor_.hides(disc)) continue;
      floor_.raise(disc);
      visible[i] = raised;
    }
  }
  // Each ball is compared once more, with the whole floor: in the first round the floor was not complete.
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (visible[i] == raised && !patience.allows(500)) return false;
    visible[i] = visible[i] == raised && !floor_.hides(placed(balls, frame, i)) ? 1 : 0;
  }
  return true;
}

}  // namespace hsp
