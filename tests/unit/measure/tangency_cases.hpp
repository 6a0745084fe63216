// Which balls that lie in another one touch it from inside, in a point that no third ball covers.
#pragma once

#include "gridless_balls.hpp"
#include "measure/tangency.hpp"
#include "small_union.hpp"

namespace cases {

struct WideBall {
  int64_t x, y, z, r;
};
// The largest balls of the lattice; the radius is a multiple of 3.
constexpr int64_t largest_ball = (int64_t{1} << 30) - 1;
constexpr int64_t third = (largest_ball - 3) / 3;
constexpr WideBall facing{4 * largest_ball / 3, -2 * largest_ball / 3, 4 * largest_ball / 3, largest_ball};

struct InnerTouching {
  uint32_t n;
  WideBall ball[3];
  bool touches;  // ball 0 touches ball 1 freely from inside
};
constexpr InnerTouching inner_touchings[] = {
    {2, {{3, 0, 0, 2}, {0, 0, 0, 5}}, true},
    {2, {{2, 1, 2, 2}, {0, 0, 0, 5}}, true},
    {2, {{2, 1, 1, 2}, {0, 0, 0, 5}}, false},  // inside, 0.55 away
    {2, {{2, 2, 2, 2}, {0, 0, 0, 5}}, false},  // pokes out
    {2, {{0, 0, 0, 2}, {0, 0, 0, 5}}, false},  // concentric
    {2, {{3, 0, 0, 5}, {0, 0, 0, 2}}, false},  // the other way round
    {2, {{7, 0, 0, 2}, {0, 0, 0, 5}}, false},  // from outside
    {2, {{5, 0, 0, 0}, {0, 0, 0, 5}}, true},   // a point on the sphere
    {2, {{1, 2, 3, 4}, {1, 2, 3, 4}}, true},   // equal
    // The point of touching is (5, 0, 0).
    {3, {{3, 0, 0, 2}, {0, 0, 0, 5}, {6, 0, 0, 2}}, false},  // covers it
    {3, {{3, 0, 0, 2}, {0, 0, 0, 5}, {6, 0, 0, 1}}, true},   // its sphere goes through it
    {3, {{3, 0, 0, 2}, {0, 0, 0, 5}, {7, 0, 0, 1}}, true},
    {3, {{3, 0, 0, 2}, {0, 0, 0, 5}, {1, 0, 0, 4}}, true},  // a second one that touches there
    {3, {{3, 0, 0, 2}, {0, 0, 0, 5}, {5, 3, 4, 5}}, true},
    {3, {{3, 0, 0, 2}, {0, 0, 0, 5}, {5, 3, 3, 5}}, false},
    {3, {{3, 0, 0, 2}, {0, 0, 0, 5}, {1, 0, 0, 5}}, false},
    {3, {{0, 0, 0, 2}, {3, 0, 0, 5}, {-3, 0, 0, 5}}, false},  // each covers where the other is touched
    // The point has a denominator of nearly 2^30; in the end it is (2, -1, 2)/3 of the radius.
    {2, {{largest_ball - 1, 0, 0, 1}, {0, 0, 0, largest_ball}}, true},
    {3, {{largest_ball - 1, 0, 0, 1}, {0, 0, 0, largest_ball}, {2 * largest_ball, 0, 0, largest_ball}}, true},
    {3, {{largest_ball - 1, 0, 0, 1}, {0, 0, 0, largest_ball}, {2 * largest_ball - 1, 0, 0, largest_ball}}, false},
    {2, {{2 * third, -third, 2 * third, 3}, {0, 0, 0, largest_ball}}, true},
    {3, {{2 * third, -third, 2 * third, 3}, {0, 0, 0, largest_ball}, facing}, true},
    {3,
     {{2 * third, -third, 2 * third, 3}, {0, 0, 0, largest_ball}, {facing.x - 1, facing.y, facing.z, facing.r}},
     false},
    {3,
     {{2 * third, -third, 2 * third, 3}, {0, 0, 0, largest_ball}, {facing.x + 1, facing.y, facing.z, facing.r}},
     true}};

inline uint32_t balls_touch_from_inside() {
  return first_failing(inner_touchings, [](const InnerTouching &c) {
    GridlessBalls<3> balls;
    for (uint32_t i = 0; i < c.n; ++i) balls.add(c.ball[i].x, c.ball[i].y, c.ball[i].z, c.ball[i].r);
    hsp::CubeBlock all;
    all.ranges = 1;
    all.range[0] = {0, c.n};
    return hsp::InnerTouch(balls.set(), hsp::BallsThatMayMeet(all), 0).is_free_with(1) == c.touches;
  });
}

// Thousands may be in one place: third balls are not looked at, which are not even there.
inline uint32_t equal_balls_need_no_third() {
  GridlessBalls<3> balls;
  for (int k = 0; k < 2; ++k) balls.add(3, 4, 5, 100);
  hsp::CubeBlock missing;
  missing.ranges = 1;
  missing.range[0] = {1U << 30, 1U << 31};
  return hsp::InnerTouch(balls.set(), hsp::BallsThatMayMeet(missing), 0).is_free_with(1) ? all_hold : 0;
}

// Thousands may touch in one place: once it is known to be free, no third ball is looked at.
inline uint32_t one_look_at_third_balls() {
  constexpr uint32_t n = 4;
  GridlessBalls<n> balls;
  for (int64_t k = 0; k < n; ++k) balls.add(5 - k, 0, 0, 1 + k);
  hsp::CubeBlock block;
  block.ranges = 1;
  block.range[0] = {0, n};
  hsp::BallsThatMayMeet others(block);
  hsp::InnerTouch touch(balls.set(), others, 0);
  if (!touch.is_free_with(1)) return 0;
  block.range[0] = {1U << 30, 1U << 31};
  others = hsp::BallsThatMayMeet(block);
  return touch.is_free_with(2) && touch.is_free_with(3) ? all_hold : 0;
}

struct InnerContacts {
  SmallBall ball[3];
  uint32_t n, contacts;
  uint32_t inner, outer;  // of the first contact
};
constexpr InnerContacts inner_contacts[] = {{{{3, 0, 0, 2}, {0, 0, 0, 5}, {-1, 0, 0, 2}}, 3, 1, 0, 1},
                                            {{{7, 0, 0, 2}, {0, 0, 0, 5}}, 2, 0, 0, 0},
                                            // Of equal balls the one with the face is the outer one of all others.
                                            {{{0, 0, 0, 5}, {0, 0, 0, 5}, {0, 0, 0, 5}}, 3, 2, 1, 0},
                                            // None of them has a face: nothing is bared.
                                            {{{0, 0, 0, 5}, {0, 0, 0, 5}, {0, 0, 0, 9}}, 3, 0, 0, 0}};

inline uint32_t contacts_that_bare_something() {
  return first_failing(inner_contacts, [](const InnerContacts &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    uint32_t found = 0;
    bool holds = true;
    hsp::visit_free_inner_contacts(small_union().grid(), small_union().boundary(), [&](uint32_t i, uint32_t j) {
      const hsp::Span<uint32_t> caller = small_union().balls().caller;
      holds = holds && caller[j] == c.outer && (found > 0 || caller[i] == c.inner);
      ++found;
    });
    return holds && found == c.contacts;
  });
}

inline constexpr Check measure_tangency[] = {{"balls_touch_from_inside", balls_touch_from_inside},
                                             {"equal_balls_need_no_third", equal_balls_need_no_third},
                                             {"one_look_at_third_balls", one_look_at_third_balls},
                                             {"contacts_that_bare_something", contacts_that_bare_something}};

}  // namespace cases
