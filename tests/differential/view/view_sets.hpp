// Sets and directions for tests of views.
#pragma once

#include <string>
#include <vector>

#include "named_balls.hpp"
#include "random_balls.hpp"
#include "view_run.hpp"

// Balls beside, before and in each other, small enough to be looked through.
std::vector<oracle::NamedBalls> small_views();

// Lattices of equal balls, apart, touching and overlapping.
std::vector<oracle::NamedBalls> lattice_views();

// All of small_views and lattice_views, and the degenerate sets of tests/differential/degenerate of at most so many
// balls; some of these where tests are repeated.
std::vector<oracle::NamedBalls> degenerate_views(size_t most_balls);

// Along axes and diagonals, where lattices line up.
std::vector<Direction> even_directions();

// Along nothing.
std::vector<Direction> uneven_directions();

// Random sets of which parts are hidden.
oracle::Balls sparse_balls(oracle::RandomSource &random, size_t n);  // most are seen and few meet
oracle::Balls mixed_balls(oracle::RandomSource &random, size_t n);   // radii from 1 to 30 in one heap
oracle::Balls flat_balls(oracle::RandomSource &random, size_t n);    // a heap with few different depths
