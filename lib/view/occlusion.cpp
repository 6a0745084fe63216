#include "view/occlusion.hpp"

namespace hsp {

// The balls in question of a cube together.
struct OcclusionCuller::CubeExtent {
  BoundingBox box;
  double top = 0.0;
  bool empty = true;

  CubeExtent(Span<ProjectedBall> discs, const BallRange &own, Span<uint8_t> visible) {
    for (uint32_t i = own.first; i < own.last; ++i) {
      if (visible[i] == 0) continue;
      const ProjectedBall &disc = discs[i];
      box.widen(disc, empty);
      top = empty || disc.z + disc.r > top ? disc.z + disc.r : top;
      empty = false;
    }
  }
};

void OcclusionCuller::carve(Workspace &workspace, uint32_t balls) {
  floor_.carve(workspace, balls);
  disc_ = workspace.take<ProjectedBall>(balls);
  bucket_ = workspace.take<uint32_t>(static_cast<uint64_t>(balls) + 1);
  order_ = workspace.take<uint32_t>(balls);
}

// False if there is nothing that could hide anything.
bool OcclusionCuller::prepare(const BallSet &balls, const ViewFrame &frame, Span<uint8_t> visible) {
  bool any = false;
  BoundingBox box;
  double extent = 0.0;
  double largest = 0.0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (visible[i] == 0) continue;
    const Vec3 centre = frame.centre_of(balls, i);
    const ProjectedBall disc{centre.x, centre.y, centre.z, balls.r[i]};
    disc_[i] = disc;
    box.widen(disc, !any);
    const double top = disc.z + disc.r;
    lowest_top_ = !any || top < lowest_top_ ? top : lowest_top_;
    highest_top_ = !any || top > highest_top_ ? top : highest_top_;
    const double distance = std::fabs(disc.x) + std::fabs(disc.y) + std::fabs(disc.z) + disc.r;
    extent = distance > extent ? distance : extent;
    largest = disc.r > largest ? disc.r : largest;
    any = true;
  }
  if (largest == 0.0) return false;
  floor_.lay_out(box, extent, largest);
  return true;
}

// A counting sort of the cubes that hold balls in question. Whatever hides a ball's highest point has a higher top, so
// that most of it has been there before; the order has no other effect than on what is found.
void OcclusionCuller::order_cubes(const CubeGrid &grid, Span<uint8_t> visible) {
  const uint32_t buckets = grid.balls().n;
  const double spread = highest_top_ - lowest_top_;
  const double scale = spread > 0.0 ? static_cast<double>(buckets) / spread : 0.0;
  // The cube's bucket, or `buckets` if nothing of it is in question.
  const auto bucket_of = [&](uint32_t cube) {
    const CubeExtent extent(disc_, grid.balls_in(cube), visible);
    if (extent.empty) return buckets;
    const double place = (highest_top_ - extent.top) * scale;
    return place < static_cast<double>(buckets - 1) ? static_cast<uint32_t>(place) : buckets - 1;
  };
  for (uint32_t b = 0; b <= buckets; ++b) bucket_[b] = 0;
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const uint32_t bucket = bucket_of(cube);
    if (bucket < buckets) ++bucket_[bucket + 1];
  }
  for (uint32_t b = 0; b < buckets; ++b) bucket_[b + 1] += bucket_[b];
  ordered_ = bucket_[buckets];
  for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
    const uint32_t bucket = bucket_of(cube);
    if (bucket < buckets) order_[bucket_[bucket]++] = cube;
  }
}

void OcclusionCuller::ask_about_cube(const BallRange &own, Span<uint8_t> visible) {
  const CubeExtent extent(disc_, own, visible);
  const bool all_hidden = floor_.is_above(extent.box, extent.top);
  for (uint32_t i = own.first; i < own.last; ++i) {
    if (visible[i] != 0 && (all_hidden || floor_.hides(disc_[i]))) visible[i] = 0;
  }
}

// All cubes of a bucket are tested before any of them raises the depth buffer: their order depends on ids.
void OcclusionCuller::hide(const CubeGrid &grid, const ViewFrame &frame, Span<uint8_t> visible) {
  const BallSet &balls = grid.balls();
  if (!prepare(balls, frame, visible)) return;
  order_cubes(grid, visible);
  uint32_t first = 0;
  for (uint32_t b = 0; first < ordered_; ++b) {
    const uint32_t last = bucket_[b];
    for (uint32_t k = first; k < last; ++k) ask_about_cube(grid.balls_in(order_[k]), visible);
    for (uint32_t k = first; k < last; ++k) {
      const BallRange own = grid.balls_in(order_[k]);
      for (uint32_t i = own.first; i < own.last; ++i) {
        if (visible[i] != 0) floor_.raise(disc_[i]);
      }
    }
    first = last;
  }
  // Once more against the whole floor: in the first round a ball did not know of all that lies above it.
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (visible[i] != 0 && floor_.hides(disc_[i])) visible[i] = 0;
  }
}

}  // namespace hsp
