// The cubes of images, a set's last balls, which only surround its own balls, as in a periodic box. These cubes get
// layers of their own, behind those of the own balls, so that images come behind all own balls in grid order. So
// whatever is found at the first of its balls is found at an own ball.
#pragma once

#include "model/cube_list.hpp"

namespace hsp {

class Halo {
 public:
  // own: the cubes of the own balls, if there are any. z_low: z of the lowest cube of images.
  void begin(const CubeList &own, int64_t z_low);
  // all: all cubes; those from number `first` on are of images.
  void end(const CubeList &all, uint32_t first);

  // The number that is added to z of a cube of images.
  int64_t lift() const { return lift_; }
  // z of the own cubes is at most this.
  int64_t last_own_layer() const { return last_own_layer_; }
  // True only if none of the 27 cubes around this one holds images. False says nothing.
  bool is_far_from(const CubeCoordinates &centre) const {
    return centre.x > inner_low_.x && centre.x < inner_high_.x && centre.y > inner_low_.y && centre.y < inner_high_.y &&
           centre.z > inner_low_.z && centre.z < inner_high_.z;
  }

 private:
  int64_t lift_ = 0, last_own_layer_ = 0;
  CubeCoordinates inner_low_{}, inner_high_{};  // a box of cubes that hold no images
};

}  // namespace hsp
