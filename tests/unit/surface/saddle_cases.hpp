// A ball's side of a saddle patch against quadrature over all of its side, where the profile's speed is positive.
#pragma once

#include "cases.hpp"
#include "core/elementary.hpp"
#include "surface/saddle.hpp"

namespace cases {

struct SaddleCase {
  double probe, radius, other_radius, height, other_height, circle_radius;
  bool cusps;
};
// 3-4-5 and 5-12-13 triangles: height^2 + circle_radius^2 = radius^2 on both sides.
constexpr SaddleCase saddle_cases[] = {
    {2, 5, 5, 3, 3, 4, false},         {2, 5, 5, 4, 4, 3, false},         {4, 5, 5, 4, 4, 3, true},
    {4, 5, 5, 3, 3, 4, false},         {3.5, 5, 5, 4, -4, 3, false},      {1, 13, 20, 5, 16, 12, false},
    {1, 20, 13, 16, -5, 12, false},    {12.5, 13, 20, 5, 16, 12, true},   {12.5, 20, 13, 16, 5, 12, true},
    {12.5, 20, 13, 16, -5, 12, false}, {12.5, 13, 20, -5, 16, 12, false}, {13, 13, 20, 5, 16, 12, true}};

// One side of an arc, as a batch of a single slot.
struct SaddleSide {
  hsp::ArcBatch batch{};
  hsp::SaddleCircles circles{};
  double radii[2];
  hsp::RolledBall ball{};

  // From the direction x counter-clockwise about z; `arm` leads from the origin to the circle's centre.
  SaddleSide(const SaddleCase &c, double angle, const hsp::Vec3 &arm) : radii{c.radius, c.other_radius} {
    batch.count = 1;
    const hsp::SinCos end = hsp::sin_cos(angle);
    const hsp::Vec3 chord{c.circle_radius * (end.cosine - 1), c.circle_radius * end.sine, 0};
    const hsp::Vec3 X = 2.0 * cross(chord, {0, 0, 1});
    for (uint32_t s = 0; s < hsp::sum_lanes; ++s) {
      batch.other[s] = 1;
      batch.uz[s] = 1;
      batch.inverse_distance[s] = 1 / (c.height + c.other_height);
      batch.twice_height[s] = 2 * c.height;
    }
    batch.angle[0] = angle;
    batch.Xx[0] = X.x;
    batch.Xy[0] = X.y;
    batch.Xz[0] = X.z;
    ball = {radii, c.radius, c.probe, {arm.x, arm.y, arm.z - c.height}};
    hsp::find_saddle_circles(hsp::Target::baseline, batch, ball, circles);
    for (double &radius : circles.radius) radius = c.circle_radius;
  }
  hsp::SaddleMeasures measure() const { return hsp::measure_saddles(hsp::Target::baseline, batch, circles, ball); }
};

inline uint32_t area_and_volume_by_quadrature() {
  return first_failing(saddle_cases, [](const SaddleCase &c) {
    constexpr double angle = 2.25;
    const hsp::Vec3 arm{1.5, -2.25, 3.5};
    const SaddleSide side(c, angle, arm);
    constexpr int steps = 1000, around = 500;
    // Angles at the profile's ends by bisection of what the contact with either ball says: tan a = -h / rho.
    const double from = -hsp::arc_tangent(c.height, c.circle_radius);
    const double other = hsp::arc_tangent(c.other_height, c.circle_radius);
    const double to = other < 0 ? other : 0;
    double area = 0, triple_volume = 0;
    for (int k = 0; k < steps && to > from; ++k) {
      const double a = from + (to - from) * (k + 0.5) / steps;
      const hsp::SinCos profile = hsp::sin_cos(a);
      const double speed = c.circle_radius - c.probe * profile.cosine;
      const bool beyond_the_axis = speed < 0 && c.height > 0 && c.other_height > 0;
      if (beyond_the_axis) continue;
      double outward = 0;
      for (int q = 0; q < around; ++q) {
        const hsp::SinCos e = hsp::sin_cos(angle * (q + 0.5) / around);
        const hsp::Vec3 normal{profile.cosine * e.cosine, profile.cosine * e.sine, -profile.sine};
        const hsp::Vec3 x = arm + hsp::Vec3{speed * e.cosine, speed * e.sine, c.probe * profile.sine};
        outward += dot(x, normal) / around;
      }
      const double piece = angle * c.probe * speed * (to - from) / steps;
      area += piece;
      triple_volume += piece * outward;
    }
    const hsp::SaddleMeasures found = side.measure();
    const double scale = c.probe * c.radius;
    return near(found.area, area, 2e-4 * scale) && near(found.triple_volume, triple_volume, 2e-3 * scale * c.radius);
  });
}

// At the probe's radius from the circle, on its axis.
inline uint32_t cusps_where_the_profile_meets_the_axis() {
  return first_failing(saddle_cases, [](const SaddleCase &c) {
    const double half_way = SaddleSide(c, 1, {0, 0, 0}).circles.half_way[0];
    const double square = c.cusps ? c.probe * c.probe - c.circle_radius * c.circle_radius : 0.0;
    return near(half_way * half_way, square, 1e-14 * c.probe * c.probe);
  });
}

// Half of a torus: the whole circle of two equal balls.
inline uint32_t half_a_torus() {
  const SaddleCase c{2, 5, 5, 3, 3, 4, false};
  const auto measured = [&](const hsp::Vec3 &arm) {
    SaddleSide side(c, 2 * hsp::pi, arm);
    side.batch.Xx[0] = side.batch.Xy[0] = side.batch.Xz[0] = 0;
    return side.measure();
  };
  const double t = hsp::arc_tangent(3, 4);
  const double area = 2 * hsp::pi * 2 * (4 * t - 2 * 0.6);
  const bool conditions[] = {near(measured({0, 0, 0}).area, area, 1e-14 * area),
                             measured({0, 0, 0}).area == measured({9, 9, 9}).area};
  return first_false(conditions);
}

// Spheres that touch, and a circle beyond the ball's own centre: nothing on this side.
inline uint32_t empty_sides() {
  const SaddleCase empty[] = {{2, 5, 5, 5, 5, 0, true}, {2, 5, 8, 5, -8, 0, false}, {2, 5, 8, -3, 6.93, 4, false}};
  return first_failing(empty, [](const SaddleCase &c) {
    const hsp::SaddleMeasures found = SaddleSide(c, 1, {1, 2, 3}).measure();
    return found.area == 0 && found.triple_volume == 0;
  });
}

// Seen from its two balls a patch has one derivative by the offset, each half of it: that of its area at fixed arc.
inline uint32_t derivative_by_the_offset() {
  return first_failing(saddle_cases, [](const SaddleCase &c) {
    // Where cusps are born the quotient is worth little, and no probe is larger than its ball.
    if (c.probe == c.circle_radius || c.probe == c.radius) return true;
    const auto area = [&](double probe) {
      SaddleCase own = c;
      own.probe = probe;
      const SaddleCase other{probe, c.other_radius, c.radius, c.other_height, c.height, c.circle_radius, c.cusps};
      return SaddleSide(own, 1, {0, 0, 0}).measure().area + SaddleSide(other, 1, {0, 0, 0}).measure().area;
    };
    constexpr double h = 1e-5;
    const SaddleSide side(c, 1, {0, 0, 0});
    const double found =
        2 * hsp::differentiate_saddles(hsp::Target::baseline, side.batch, side.circles, side.ball).area_offset;
    return near(found, (area(c.probe + h) - area(c.probe - h)) / (2 * h), 1e-6);
  });
}

inline constexpr Check surface_saddle[] = {
    {"area_and_volume_by_quadrature", area_and_volume_by_quadrature},
    {"cusps_where_the_profile_meets_the_axis", cusps_where_the_profile_meets_the_axis},
    {"half_a_torus", half_a_torus},
    {"empty_sides", empty_sides},
    {"derivative_by_the_offset", derivative_by_the_offset}};

}  // namespace cases
