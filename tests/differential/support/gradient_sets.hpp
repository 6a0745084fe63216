// Sets of balls in general position on a fine lattice: areas and volumes are smooth functions of small moves of the
// balls.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "named_balls.hpp"
#include "random_balls.hpp"

// The same set on a lattice 2^22 times as fine, every number moved by up to half an old step: radii of about 100 steps
// come close to the lattice's limit, and no tie is left.
oracle::Balls in_general_position(const oracle::Balls &balls, oracle::RandomSource &random);

// Isolated and overlapping balls, free circles, faces with holes, voids, a component in a void: 3 to 70 balls each.
// Builds that repeat tests have only some of these sets (sweep_length.hpp).
std::vector<oracle::NamedBalls> sets_of_every_kind(uint64_t seed);

// Caffeine and crambin, probe 0 and 1.4 angstrom, in units of 2^-28 angstrom.
std::vector<oracle::NamedBalls> molecules_of_gradient_tests();

// The n balls whose centres lie nearest to the centre of the first, unchanged.
oracle::Balls nearest_to_first(const oracle::Balls &balls, size_t n);
