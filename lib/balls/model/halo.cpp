#include "model/halo.hpp"

namespace hsp {

void Halo::begin(const CubeList &own, int64_t z_low) {
  last_own_layer_ = own.count() > 0 ? own.high().z : 0;
  lift_ = last_own_layer_ + 1 - z_low;
  inner_low_ = own.low();
  inner_high_ = own.high();
}

// Begins with the box around all own cubes. Each cube of images in the box cuts off layers up to its own, at the side
// where these are fewest.
void Halo::end(const CubeList &all, uint32_t first) {
  for (uint32_t cube = first; cube < all.count(); ++cube) {
    CubeCoordinates at = all.coordinates(cube);
    at.z -= lift_;
    const int64_t behind[6] = {at.x - inner_low_.x,  at.y - inner_low_.y,  at.z - inner_low_.z,
                               inner_high_.x - at.x, inner_high_.y - at.y, inner_high_.z - at.z};
    uint32_t least = 0;
    for (uint32_t face = 1; face < 6; ++face) least = behind[face] < behind[least] ? face : least;
    if (behind[least] < 0) continue;  // it is outside
    if (least == 0) inner_low_.x = at.x + 1;
    if (least == 1) inner_low_.y = at.y + 1;
    if (least == 2) inner_low_.z = at.z + 1;
    if (least == 3) inner_high_.x = at.x - 1;
    if (least == 4) inner_high_.y = at.y - 1;
    if (least == 5) inner_high_.z = at.z - 1;
  }
}

}  // namespace hsp
