// Maps of balls that touch, or meet in more than one way at a point, against closed forms, the z-buffer and the map of
// balls and sticks without sticks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "built_map.hpp"
#include "built_sticks.hpp"
#include "maps/map_check.hpp"
#include "random_balls.hpp"

using Direction = std::array<double, 3>;

struct SeenSet {
  oracle::Balls balls;
  Direction towards{};
};

inline std::string to_text(const SeenSet &set) {
  std::string text = oracle::to_text(set.balls) + "towards";
  for (const double x : set.towards) text += " " + std::to_string(x);
  return text;
}

// Small integers.
inline Direction small_direction(oracle::RandomSource &random, int64_t largest) {
  Direction d{};
  while (d == Direction{})
    for (double &x : d) x = static_cast<double>(random.in(-largest, largest));
  return d;
}

// Two balls of which one touches the other, from outside or from inside; mostly with both centres equally deep.
inline SeenSet touching_pair(oracle::RandomSource &random) {
  const oracle::LatticeBall step = oracle::integer_length_vector(random);  // and its length
  const int64_t k = random.in(1, 4), apart = 2 * k * step.radius;
  const int64_t x = random.in(-4, 4), y = random.in(-4, 4), z = random.in(-4, 4);
  const bool inside = random.in(0, 4) == 0;
  const int64_t r = random.in(1, inside ? 6 : apart - 1);
  SeenSet set{
      {{x, y, z, inside ? apart + r : apart - r}, {x + 2 * k * step.x, y + 2 * k * step.y, z + 2 * k * step.z, r}}};
  if (random.in(0, 1) == 1) std::swap(set.balls[0], set.balls[1]);
  set.towards = small_direction(random, random.in(1, 3));
  const Direction d = {static_cast<double>(step.x), static_cast<double>(step.y), static_cast<double>(step.z)};
  const Direction &v = set.towards;
  const Direction across = {d[1] * v[2] - d[2] * v[1], d[2] * v[0] - d[0] * v[2], d[0] * v[1] - d[1] * v[0]};
  if (random.in(0, 3) != 0 && across != Direction{}) set.towards = across;
  return set;
}

// The visible part of two balls that touch: the nearer disc, and the other one without what both have in common; but of
// a ball inside the other one nothing.
inline std::array<double, 2> areas_of_pair(const SeenSet &set) {
  const oracle::LatticeBall &a = set.balls[0], &b = set.balls[1];
  const double r[2] = {static_cast<double>(a.radius), static_cast<double>(b.radius)};
  std::array<double, 2> areas = {std::numbers::pi * r[0] * r[0], std::numbers::pi * r[1] * r[1]};
  const Direction d = {static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y), static_cast<double>(b.z - a.z)};
  const Direction &v = set.towards;
  const double deep = (d[0] * v[0] + d[1] * v[1] + d[2] * v[2]) / std::hypot(v[0], v[1], v[2]);
  const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  if (squared < std::max(r[0], r[1]) * std::max(r[0], r[1])) {
    areas[r[0] < r[1] ? 0 : 1] = 0;
    return areas;
  }
  const double beside = std::sqrt(std::max(0.0, squared - deep * deep));
  double common = 0;
  if (deep != 0 && beside <= std::abs(r[0] - r[1])) {
    common = std::min(areas[0], areas[1]);
  } else if (deep != 0 && beside < r[0] + r[1]) {
    for (int k = 0; k < 2; ++k) {
      const double along = (beside * beside + r[k] * r[k] - r[1 - k] * r[1 - k]) / (2 * beside);
      const double half = std::acos(along / r[k]);
      common += r[k] * r[k] * half - along * r[k] * std::sin(half);
    }
  }
  areas[deep > 0 ? 0 : 1] -= common;
  return areas;
}

// By the numbers that the caller gave the balls.
inline std::vector<double> seen_areas(const BuiltMap &built, size_t balls) {
  std::vector<double> areas(balls, 0.0);
  for (const hsp::MapFace &face : built.map().faces.items())
    if (face.owner != hsp::no_id) areas[built.caller(face.owner)] += face.area;
  return areas;
}
inline std::vector<double> seen_areas(const BuiltSticks &built, size_t balls) {
  std::vector<double> areas(balls, 0.0);
  for (const hsp::MapFace &face : built.builder().map().faces.items())
    if (face.owner != hsp::no_id) areas[built.balls().caller[face.owner]] += face.area;
  return areas;
}

inline double largest_radius(const oracle::Balls &balls) {
  double largest = 0;
  for (const oracle::LatticeBall &ball : balls) largest = std::max(largest, static_cast<double>(ball.radius));
  return largest;
}

inline std::string violation_of(BuiltMap &built) {
  if (built.status() != hsp::Status::ok) return "no map";
  const hsp::MapViolation violation = hsp::check_map(built.map(), built.builder().scratch());
  if (violation.invariant == hsp::MapInvariant::none) return "";
  return "invariant " + std::to_string(static_cast<int>(violation.invariant)) + " at " + std::to_string(violation.id);
}

// Roundings move points by less than 1e-7 radii where curves touch.
template <class Areas>
std::string areas_differ(const std::vector<double> &areas, const Areas &expected, double moved, double radius) {
  for (size_t i = 0; i < areas.size(); ++i)
    if (!(std::abs(areas[i] - expected[i]) <= radius * (1e-6 * radius + 20 * moved)))
      return "area " + std::to_string(areas[i]) + " of ball " + std::to_string(i) + " for " +
             std::to_string(expected[i]);
  return "";
}

// Empty, or what is wrong with the maps of two balls that touch, as balls alone and as balls and no sticks.
inline std::string pair_complaint(const SeenSet &set) {
  BuiltMap built(set.balls, set.towards);
  const std::string violation = violation_of(built);
  if (!violation.empty()) return violation;
  const auto areas = areas_of_pair(set);
  const std::string complaint =
      areas_differ(seen_areas(built, 2), areas, built.map().perturbation, largest_radius(set.balls));
  const BuiltSticks sticks(set.balls, {}, 0.25, set.towards, false, true);
  if (!complaint.empty() || sticks.status() != hsp::Status::ok) return complaint;
  return areas_differ(seen_areas(sticks, 2), areas, sticks.builder().map().perturbation, largest_radius(set.balls));
}

// Empty, or what is wrong with the map of some balls, against that of sticks and the z-buffer.
inline std::string set_complaint(const SeenSet &set, size_t pixels) {
  BuiltMap built(set.balls, set.towards);
  std::string complaint = violation_of(built);
  if (complaint.empty() && pixels > 0) complaint = map_disagrees(built, pixels);
  const BuiltSticks sticks(set.balls, {}, 0.25, set.towards, false, true);
  if (!complaint.empty() || sticks.status() != hsp::Status::ok) return complaint;
  const double moved = built.map().perturbation + sticks.builder().map().perturbation;
  return areas_differ(seen_areas(built, set.balls.size()), seen_areas(sticks, set.balls.size()), moved,
                      largest_radius(set.balls));
}

// Two to six balls that touch and meet in many ways.
inline SeenSet touching_set(oracle::RandomSource &random) {
  const auto n = static_cast<size_t>(random.in(2, 6));
  SeenSet set;
  switch (random.in(0, 3)) {
    case 0:
      set.balls = oracle::grid_balls(random, n);
      break;
    case 1:
      set.balls = oracle::tangent_balls(random, n);
      break;
    case 2:
      set.balls = oracle::coplanar_balls(random, n);
      break;
    default:
      set.balls = oracle::collinear_balls(random, n);
      break;
  }
  set.towards = small_direction(random, random.in(1, 3));
  return set;
}
