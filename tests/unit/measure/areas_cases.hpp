// Areas, volumes and angles in closed form: caps, and spheres that planes through their centre cut into halves,
// quarters and octants.
#pragma once

#include "measure/areas.hpp"
#include "small_scenes.hpp"

namespace cases {

// In multiples of pi.
struct MeasuredUnion {
  uint32_t n;
  SmallBall ball[3];
  double area[3];  // by ball
  double volume;   // of the union
};
constexpr MeasuredUnion measured_unions[] = {
    {0, {}, {}, 0},
    {1, {{7, 7, 7, 0}}, {0}, 0},
    {1, {{7, -7, 7, 3}}, {36}, 36},
    {2, {{0, 0, 0, 3}, {900000, 0, 0, 6}}, {36, 144}, 36 + 288},
    {2, {{0, 0, 0, 5}, {8, 0, 0, 5}}, {90, 90}, 324},                            // caps of height 1
    {2, {{1, 2, 0, 5}, {1, 2, -6, 5}}, {80, 80}, 2 * 500.0 / 3 - 2 * 52.0 / 3},  // of height 2
    {2, {{0, 4, 0, 5}, {0, 0, 0, 3}}, {90, 18}, 180},                            // half of the small one
    {2, {{0, 0, 0, 5}, {0, 0, 0, 5}}, {100, 0}, 500.0 / 3},
    {2, {{0, 0, 0, 5}, {1, 1, 1, 2}}, {100, 0}, 500.0 / 3},
    {2, {{0, 0, 0, 5}, {10, 0, 0, 5}}, {100, 100}, 1000.0 / 3},  // touching, from outside and from inside
    {2, {{0, 0, 0, 5}, {-3, 0, 0, 2}}, {100, 0}, 500.0 / 3},
    {3, {{0, 0, 0, 5}, {8, 0, 0, 5}, {16, 0, 0, 5}}, {90, 80, 90}, 3 * 500.0 / 3 - 4 * 14.0 / 3},
    {3, {{0, 0, 0, 3}, {4, 0, 0, 5}, {-4, 0, 0, 5}}, {0, 90, 90}, 2 * 500.0 / 3 - 2 * 14.0 / 3}};

inline uint32_t areas_and_volumes() {
  return first_failing(measured_unions, [](const MeasuredUnion &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    double volume = 0.0;
    for (uint32_t i = 0; i < c.n; ++i) {
      const uint32_t ball = small_union().grid().grid_index(i);
      const hsp::BallMeasure found = hsp::measure_ball(small_union().balls(), small_union().boundary(), ball);
      if (!near(found.area, c.area[i] * hsp::pi, 1e-11) || found.area < 0.0) return false;
      volume += found.volume;
    }
    return near(volume, c.volume * hsp::pi, 1e-10);
  });
}

// A ball that pokes out of a larger one by a single step, with a cap of height ((s + d)^2 - R^2) / (2 d).
inline uint32_t faces_of_nearly_no_area() {
  for (int32_t k = 1; k < 100; ++k) {
    constexpr int32_t scale = 10000000;
    const SmallBall balls[] = {{0, 0, 0, scale * (7 + k)}, {-6 * scale, -3 * scale, -2 * scale, scale * k + 1}};
    if (!small_union().build(balls, 2)) return 0;
    const uint32_t small = small_union().grid().grid_index(1);
    const hsp::BallMeasure found = hsp::measure_ball(small_union().balls(), small_union().boundary(), small);
    const double height = (2.0 * balls[0].r + 1) / (14.0 * scale);
    if (!near(found.area / (2 * hsp::pi * balls[1].r * height), 1.0, 1e-6)) return static_cast<uint32_t>(k);
  }
  return all_hold;
}

// A ball of radius 3 at the origin and balls of radius 5 at distance 4 on the axes, each of which covers half of it.
// About the ball of lowest rank, whose x is smallest, then y, then z, the volume is (3 area + offset . N) / 3 with the
// vector area N: 9 pi for half a sphere, and for smaller parts what planes through the axes leave of that.
struct Octant {
  uint32_t n;
  SmallBall other[3];
  double area, volume;  // in multiples of pi
  double arc;           // the angle of each arc, likewise
};
constexpr Octant octants[] = {{0, {}, 36, 36, 0},
                              {1, {{4, 0, 0, 5}}, 18, 18, 0},
                              {1, {{-4, 0, 0, 5}}, 18, 30, 0},
                              {1, {{0, -4, 0, 5}}, 18, 30, 0},
                              {2, {{4, 0, 0, 5}, {0, 4, 0, 5}}, 9, 9, 1},
                              {2, {{-4, 0, 0, 5}, {0, 4, 0, 5}}, 9, 15, 1},
                              {2, {{0, -4, 0, 5}, {0, 0, -4, 5}}, 9, 15, 1},
                              {2, {{0, 0, -4, 5}, {0, 0, 4, 5}}, 0, 0, 0},
                              {3, {{4, 0, 0, 5}, {0, 4, 0, 5}, {0, 0, 4, 5}}, 4.5, 4.5, 0.5},
                              {3, {{-4, 0, 0, 5}, {0, 4, 0, 5}, {0, 0, 4, 5}}, 4.5, 7.5, 0.5},
                              {3, {{4, 0, 0, 5}, {0, -4, 0, 5}, {0, 0, 4, 5}}, 4.5, 7.5, 0.5},
                              {3, {{-4, 0, 0, 5}, {0, -4, 0, 5}, {0, 0, -4, 5}}, 4.5, 7.5, 0.5}};

inline uint32_t octants_of_a_sphere() {
  return first_failing(octants, [](const Octant &c) {
    const SmallBall balls[] = {{0, 0, 0, 3}, c.other[0], c.other[1], c.other[2]};
    if (!small_union().build(balls, c.n + 1)) return false;
    const hsp::BallSet &set = small_union().balls();
    const hsp::Boundary &boundary = small_union().boundary();
    const uint32_t own = small_union().grid().grid_index(0);
    const hsp::BallMeasure found = hsp::measure_ball(set, boundary, own);
    if (!near(found.area, c.area * hsp::pi, 1e-13) || !near(found.volume, c.volume * hsp::pi, 1e-13)) return false;
    for (const uint32_t e : boundary.half_edges(own)) {
      const uint32_t twin = boundary.twin(e);
      if (!near(hsp::angle_of(set, boundary, own, e), c.arc * hsp::pi, 1e-14) ||
          !near(hsp::angle_of(set, boundary, boundary.ball_of(twin), twin), c.arc * hsp::pi, 1e-14)) {
        return false;
      }
    }
    return boundary.half_edges(own).size() == (c.arc > 0.0 ? c.n : 0U);
  });
}

// The faces of a ball, ascending, have its area and volume together.
inline uint32_t faces_add_up() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::BallSet &set = small_union().balls();
    const hsp::Boundary &boundary = small_union().boundary();
    uint32_t visited = 0;
    for (uint32_t ball = 0; ball < c.n; ++ball) {
      const hsp::BallMeasure whole = hsp::measure_ball(set, boundary, ball);
      hsp::BallMeasure sum;
      bool positive = true;
      hsp::measure_faces(set, boundary, ball, [&](uint32_t face, const hsp::BallMeasure &part) {
        positive = positive && face == visited++ && part.area >= 0.0;
        sum.area += part.area;
        sum.volume += part.volume;
      });
      const double scale = set.r[ball] * set.r[ball];
      if (!positive || !near(sum.area, whole.area, 1e-12 * scale)) return false;
      if (!near(sum.volume, whole.volume, 1e-12 * scale * (set.r[ball] + 2000))) return false;
    }
    return visited == boundary.face_count();
  });
}

inline constexpr Check measure_areas[] = {{"areas_and_volumes", areas_and_volumes},
                                          {"faces_of_nearly_no_area", faces_of_nearly_no_area},
                                          {"octants_of_a_sphere", octants_of_a_sphere},
                                          {"faces_add_up", faces_add_up}};

}  // namespace cases
