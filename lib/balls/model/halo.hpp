// The cubes of a set's last balls if these only surround the others, like images in a periodic box. They lie in layers
// of their own above those of the others: what is found once, at the first of its balls, is found at one of the others.
#pragma once

#include "model/cube_list.hpp"

namespace hsp {

class Halo {
 public:
  // The cubes of the own balls, if there are any. z_low: of the lowest cube around them.
  void begin(const CubeList &own, int64_t z_low);
  // All cubes, those around them from number `first` on.
  void end(const CubeList &all, uint32_t first);

  // The number that is added to z of a cube around the own ones.
  int64_t lift() const { return lift_; }
  // z of the own cubes is at most this.
  int64_t last_own_layer() const { return last_own_layer_; }
  // Whether none of the 27 cubes around this one is among those around the own ones; false does not say that one is.
  bool is_far_from(const CubeCoordinates &centre) const {
    return centre.x > inner_low_.x && centre.x < inner_high_.x && centre.y > inner_low_.y && centre.y < inner_high_.y &&
           centre.z > inner_low_.z && centre.z < inner_high_.z;
  }

 private:
  int64_t lift_ = 0, last_own_layer_ = 0;
  CubeCoordinates inner_low_{}, inner_high_{};  // a box of cubes that are own ones or empty
};

}  // namespace hsp
