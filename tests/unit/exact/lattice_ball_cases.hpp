// Two balls: tangent, equal, far apart, and all pairs of small ones.
#pragma once

#include "cases.hpp"
#include "exact/lattice_ball.hpp"

namespace cases {

using hsp::exact::PairRelation;

inline constexpr int64_t largest_radius = (INT64_C(1) << 30) - 1, farthest = INT64_C(1) << 50;

struct RelatedPair {
  hsp::exact::LatticeBall a, b;
  PairRelation relation;
};
constexpr RelatedPair related_pairs[] = {
    // Tangent from outside: the closed balls meet in an infinitesimal circle, whichever ranks first.
    {{{0, 0, 0}, 2, 0}, {{5, 0, 0}, 3, 1}, PairRelation::circle},
    {{{5, 0, 0}, 3, 0}, {{0, 0, 0}, 2, 1}, PairRelation::circle},
    {{{0, 0, 0}, 2, 0}, {{6, 0, 0}, 3, 1}, PairRelation::disjoint},
    // From inside: the small ball is inside, whichever ranks first.
    {{{-1, 0, 0}, 2, 0}, {{0, 0, 0}, 3, 1}, PairRelation::first_in_second},
    {{{1, 0, 0}, 2, 0}, {{0, 0, 0}, 3, 1}, PairRelation::first_in_second},
    // Equal balls: the lower index contains the other.
    {{{1, 2, 3}, 4, 0}, {{1, 2, 3}, 4, 1}, PairRelation::second_in_first},
    {{{1, 2, 3}, 4, 7}, {{1, 2, 3}, 4, 1}, PairRelation::first_in_second},
    // Points.
    {{{1, 2, 3}, 0, 0}, {{1, 2, 3}, 0, 1}, PairRelation::second_in_first},
    {{{1, 2, 3}, 0, 0}, {{1, 2, 4}, 0, 1}, PairRelation::disjoint},
    {{{-5, 0, 0}, 0, 0}, {{0, 0, 0}, 5, 1}, PairRelation::first_in_second},
    {{{5, 0, 0}, 0, 0}, {{0, 0, 0}, 5, 1}, PairRelation::first_in_second},
    // The largest values.
    {{{farthest, farthest, farthest}, largest_radius, 0},
     {{-farthest, -farthest, -farthest}, largest_radius, 1},
     PairRelation::disjoint},
    {{{0, 0, 0}, largest_radius, 0}, {{2 * largest_radius, 0, 0}, largest_radius, 1}, PairRelation::circle},
    {{{0, 0, 0}, largest_radius, 0},
     {{2 * largest_radius, 2 * largest_radius, 2 * largest_radius}, largest_radius, 1},
     PairRelation::disjoint}};

inline uint32_t relations_of_two_balls() {
  return first_failing(related_pairs, [](const RelatedPair &c) { return pair_relation(c.a, c.b) == c.relation; });
}

inline uint32_t largest_planes_do_not_overflow() {
  const hsp::exact::Plane plane =
      hsp::exact::plane_of({{0, 0, 0}, largest_radius, 0}, {{2 * largest_radius, 0, 0}, largest_radius, 1});
  const bool conditions[] = {plane.h == 4 * largest_radius * largest_radius, plane.v.x == 2 * largest_radius};
  return first_false(conditions);
}

// All pairs of balls with coordinates and radii up to 3: exchanged, they contain each other the other way round. Two
// of different radii are what their distance says, touching or not.
inline uint32_t relations_are_exchanged_with_the_balls() {
  for (uint32_t pair = 0; pair < 1U << 16; ++pair) {
    const auto number = [&](uint32_t k) { return static_cast<int64_t>(pair >> 2 * k & 3U); };
    const hsp::exact::LatticeBall a{{number(0), number(1), number(2)}, number(3), 0};
    const hsp::exact::LatticeBall b{{number(4), number(5), number(6)}, number(7), 1};
    const PairRelation forward = pair_relation(a, b), backward = pair_relation(b, a);
    const PairRelation exchanged = forward == PairRelation::first_in_second   ? PairRelation::second_in_first
                                   : forward == PairRelation::second_in_first ? PairRelation::first_in_second
                                                                              : forward;
    const int64_t dx = a.centre.x - b.centre.x, dy = a.centre.y - b.centre.y, dz = a.centre.z - b.centre.z;
    const int64_t square = dx * dx + dy * dy + dz * dz, sum = a.radius + b.radius, less = a.radius - b.radius;
    if (backward != exchanged || (forward == PairRelation::disjoint) != (square > sum * sum)) return pair;
    const PairRelation nested = less > 0 ? PairRelation::second_in_first : PairRelation::first_in_second;
    if (square <= less * less && less != 0 && forward != nested) return pair;
    if (square > less * less && square <= sum * sum && forward != PairRelation::circle) return pair;
  }
  return all_hold;
}

inline constexpr Check exact_lattice_ball[] = {
    {"relations_of_two_balls", relations_of_two_balls},
    {"largest_planes_do_not_overflow", largest_planes_do_not_overflow},
    {"relations_are_exchanged_with_the_balls", relations_are_exchanged_with_the_balls}};

}  // namespace cases
