// View directions from angles: quarter turns exactly, others as the matrices say.
#pragma once

#include <cmath>
#include <limits>

#include "cases.hpp"
#include "view/view_rotation.hpp"

namespace cases {

inline uint32_t quarter_turns_are_exact() {
  constexpr double cosine[4] = {1, 0, -1, 0}, sine[4] = {0, 1, 0, -1};
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    const hsp::SinCos direction = hsp::direction_of_degrees(90.0 * quarter);
    if (direction.cosine != cosine[quarter & 3] || direction.sine != sine[quarter & 3]) {
      return static_cast<uint32_t>(quarter + 4000);
    }
  }
  return all_hold;
}

inline uint32_t other_angles_are_those_of_the_c_library() {
  for (int k = -7000; k <= 7000; ++k) {
    const double degrees = 0.37 * k;
    const double angle = std::remainder(degrees, 360.0) * (hsp::pi / 180);
    const hsp::SinCos direction = hsp::direction_of_degrees(degrees);
    if (!near(direction.cosine, std::cos(angle), 1e-14) || !near(direction.sine, std::sin(angle), 1e-14)) {
      return static_cast<uint32_t>(k + 7000);
    }
  }
  return all_hold;
}

struct Rotated {
  double angle[3];
  double towards[3], up[3];
};
constexpr Rotated quarter_rotations[] = {{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                         // About x: what was above comes to the front.
                                         {{90, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                                         // About y: what was on the left comes to the front.
                                         {{0, 90, 0}, {-1, 0, 0}, {0, 1, 0}},
                                         // About z: what was on the right comes to the top.
                                         {{0, 0, 90}, {0, 0, 1}, {1, 0, 0}},
                                         // First about x, then about y.
                                         {{90, 90, 0}, {-1, 0, 0}, {0, 0, -1}}};

inline uint32_t quarter_turns_about_each_axis() {
  return first_failing(quarter_rotations, [](const Rotated &c) {
    hsp::ViewDirection seen{};
    if (hsp::direction_of_rotation(c.angle[0], c.angle[1], c.angle[2], seen) != hsp::Status::ok) return false;
    for (int k = 0; k < 3; ++k) {
      if (seen.towards[k] != c.towards[k] || seen.up[k] != c.up[k]) return false;
    }
    return true;
  });
}

// Rows of R_z R_y R_x, multiplied out here from the three matrices.
constexpr double rotations[][3] = {{20, -50, 110}, {-170, 35, 3}, {400, 89, -91}, {0, 0.1, -720.5}};

inline uint32_t rows_of_the_product() {
  return first_failing(rotations, [](const double(&angles)[3]) {
    double R[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int axis = 0; axis < 3; ++axis) {
      const double t = angles[axis] * hsp::pi / 180;
      const int p = (axis + 1) % 3, q = (axis + 2) % 3;
      for (int column = 0; column < 3; ++column) {
        const double a = R[p][column], b = R[q][column];
        R[p][column] = std::cos(t) * a - std::sin(t) * b;
        R[q][column] = std::sin(t) * a + std::cos(t) * b;
      }
    }
    hsp::ViewDirection seen{};
    if (hsp::direction_of_rotation(angles[0], angles[1], angles[2], seen) != hsp::Status::ok) return false;
    for (int k = 0; k < 3; ++k) {
      if (!near(seen.towards[k], R[2][k], 1e-14) || !near(seen.up[k], R[1][k], 1e-14)) return false;
    }
    return true;
  });
}

struct AskedAngle {
  double angle;
  hsp::Status status;
};
constexpr double infinite_angle = std::numeric_limits<double>::infinity();
constexpr double beyond_largest = hsp::largest_rotation * (1 + 0x1p-52);
constexpr AskedAngle asked_angles[] = {{std::numeric_limits<double>::quiet_NaN(), hsp::Status::not_finite},
                                       {infinite_angle, hsp::Status::not_finite},
                                       {-infinite_angle, hsp::Status::not_finite},
                                       {beyond_largest, hsp::Status::range},
                                       {-beyond_largest, hsp::Status::range},
                                       {hsp::largest_rotation, hsp::Status::ok},
                                       {-hsp::largest_rotation, hsp::Status::ok}};

inline uint32_t angles_that_are_none_or_too_large() {
  return first_failing(asked_angles, [](const AskedAngle &c) {
    for (int axis = 0; axis < 3; ++axis) {
      double angle[3] = {0, 0, 0};
      angle[axis] = c.angle;
      hsp::ViewDirection direction{};
      if (hsp::direction_of_rotation(angle[0], angle[1], angle[2], direction) != c.status) return false;
    }
    return true;
  });
}

inline constexpr Check view_view_rotation[] = {
    {"quarter_turns_are_exact", quarter_turns_are_exact},
    {"other_angles_are_those_of_the_c_library", other_angles_are_those_of_the_c_library},
    {"quarter_turns_about_each_axis", quarter_turns_about_each_axis},
    {"rows_of_the_product", rows_of_the_product},
    {"angles_that_are_none_or_too_large", angles_that_are_none_or_too_large}};

}  // namespace cases
