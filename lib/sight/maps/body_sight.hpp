// Which ball or stick is seen at a point of the view plane, from the boxes around them.
#pragma once

#include "maps/stick_scene.hpp"
#include "maps/stick_sweep.hpp"

namespace hsp {

class BodySight {
 public:
  // items: sorted by their left sides. Balls inside others do not count.
  BodySight(const StickScene &scene, Span<const SweptBox> items);

  // The body with the highest front besides `except` and, if that is a part of a stick, the other part; no_id if there
  // is none. Certain unless the point is close to a contour, or two fronts are close to each other.
  struct Highest {
    uint32_t body;
    bool certain;
  };
  Highest highest_at(double x, double y, uint32_t except) const;

 private:
  // The height of a body's front, if it is there.
  struct Front {
    bool exists, certain;
    double z;
  };
  Front front_at(uint32_t body, double x, double y) const;

  const StickScene &scene_;
  Span<const SweptBox> items_;
  double widest_ = 0.0;
  double largest_ = 0.0;  // radius
};

}  // namespace hsp
