// Sets whose components lie in voids of others, and sets that are awkward for cutting faces, with what is known of
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lattice_ball.hpp"
#include "named_balls.hpp"
#include "random_balls.hpp"

// One component as it was built.
struct BuiltComponent {
  oracle::Balls balls;
  uint32_t genus = 0;  // summed over its shells
  uint32_t voids = 0;
  std::optional<size_t> around = std::nullopt;  // the component in whose void it lies
};

struct BuiltSet {
  std::string name;
  std::vector<BuiltComponent> components;
  [[nodiscard]] oracle::Balls balls() const;
};

// Hollow shells in hollow shells, rings, cages.
std::vector<BuiltSet> built_sets();

// Sets made for faces with many loops, for cut arcs through the poles, level and
// upright neighbours, and upright planes that coincide on both sides of a circle.
std::vector<oracle::NamedBalls> awkward_sets();

// Shells of 6, 8, 26 or 30 balls in the voids of others, with loose balls and touching ones, along random axes; some
// walls are closed by single points only; often with copies and with balls inside others. Mostly below 100 balls.
oracle::Balls nested_balls(oracle::RandomSource &random);
