// The axes of a view: directions rounded to integers, what is up, and the middle of the balls.
#pragma once

#include <limits>

#include "small_union.hpp"
#include "view/view_frame.hpp"

namespace cases {

constexpr double longest_vector = std::numeric_limits<double>::max();
constexpr double shortest_vector = std::numeric_limits<double>::denorm_min();
constexpr int64_t unit_step = int64_t{1} << 28;

inline bool equals(const hsp::Vec3 &a, const double (&b)[3]) {
  return a.x == b[0] && a.y == b[1] && a.z == b[2];
}

struct Axes {
  hsp::ViewDirection asked;
  hsp::exact::Vector direction;
  double right[3], up[3], towards[3];
};
constexpr Axes axes[] = {{{{0, 0, 3}, {0, 2, 0}}, {0, 0, unit_step}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                         {{{-1e-300, 0, 0}, {0, 0, 1e300}}, {-unit_step, 0, 0}, {0, -1, 0}, {0, 0, 1}, {-1, 0, 0}},
                         // Zero means the default.
                         {{{0, 0, 0}, {0, 0, 0}}, {0, 0, unit_step}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                         // An up vector parallel to the view is replaced.
                         {{{0, 5, 0}, {0, 1, 0}}, {0, unit_step, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                         {{{0, -5, 0}, {0, 0, 0}}, {0, -unit_step, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                         {{{1, 0, 0}, {-2, 0, 0}}, {unit_step, 0, 0}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}}};

inline uint32_t axes_are_exact() {
  return first_failing(axes, [](const Axes &c) {
    hsp::ViewFrame frame;
    return hsp::look_from(c.asked, frame) == hsp::Status::ok && frame.direction.x == c.direction.x &&
           frame.direction.y == c.direction.y && frame.direction.z == c.direction.z && equals(frame.right, c.right) &&
           equals(frame.up, c.up) && equals(frame.towards, c.towards);
  });
}

struct Rounded28 {
  double towards[3];
  hsp::exact::Vector direction;
};
constexpr Rounded28 directions_of_any_length[] = {
    {{shortest_vector, shortest_vector, shortest_vector}, {unit_step, unit_step, unit_step}},
    {{longest_vector, -longest_vector, 0}, {unit_step, -unit_step, 0}},
    {{longest_vector, longest_vector / 2, 1e-300}, {unit_step, unit_step / 2, 0}}};

inline uint32_t directions_are_rounded() {
  return first_failing(directions_of_any_length, [](const Rounded28 &c) {
    hsp::ViewFrame frame;
    return hsp::look_from({{c.towards[0], c.towards[1], c.towards[2]}, {0, 0, longest_vector}}, frame) ==
               hsp::Status::ok &&
           frame.direction.x == c.direction.x && frame.direction.y == c.direction.y &&
           frame.direction.z == c.direction.z;
  });
}

constexpr double not_finite[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};

inline uint32_t what_is_not_finite_is_refused() {
  return first_failing(not_finite, [](double value) {
    for (int k = 0; k < 6; ++k) {
      hsp::ViewDirection direction{{0, 0, 1}, {0, 1, 0}};
      (k < 3 ? direction.towards[k] : direction.up[k - 3]) = value;
      hsp::ViewFrame frame;
      if (hsp::look_from(direction, frame) != hsp::Status::not_finite) return false;
    }
    return true;
  });
}

struct Middle {
  uint32_t n;
  SmallBall ball[3];
  double origin[3];
};
constexpr Middle middles[] = {{0, {}, {0, 0, 0}},
                              {1, {{7, -8, 9, 1}}, {7, -8, 9}},
                              {3, {{-10, 0, 5, 1}, {30, 2, 5, 3}, {0, -100, 5, 1}}, {10, -49, 5}}};

inline uint32_t the_origin_is_the_middle_of_the_centres() {
  return first_failing(middles, [](const Middle &c) {
    hsp::ViewFrame frame;
    if (!small_union().build(c.ball, c.n)) return false;
    hsp::centre_on(small_union().balls(), frame);
    return equals(frame.origin, c.origin);
  });
}

inline constexpr Check view_view_frame[] = {
    {"axes_are_exact", axes_are_exact},
    {"directions_are_rounded", directions_are_rounded},
    {"what_is_not_finite_is_refused", what_is_not_finite_is_refused},
    {"the_origin_is_the_middle_of_the_centres", the_origin_is_the_middle_of_the_centres}};

}  // namespace cases
