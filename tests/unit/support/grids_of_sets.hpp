// Sets of balls and their grids, for queries along rays.
#pragma once

#include <cstddef>
#include <cstdint>

#include "built_grid.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

// Calls check(balls, grid, random) for a number of random sets of one to `most` balls.
template <class Check>
void for_random_sets(uint64_t seed, int sets, oracle::Balls (*make)(oracle::RandomSource &, std::size_t),
                     std::size_t most, Check check) {
  oracle::RandomSource random(seed);
  for (int k = 0; k < sets; ++k) {
    const oracle::Balls balls = make(random, static_cast<std::size_t>(random.in(1, static_cast<std::int64_t>(most))));
    check(balls, BuiltGrid(oracle::in_lengths(balls, 1)), random);
  }
}

// Two to six balls that a ray along the z axis enters in one point, (0, 0, 100), tangent to some of them, and a ball
// behind, in any order: check(k, balls, grid, z) for the k-th order and five heights below.
template <class Check>
void for_balls_entered_in_one_point(int orders, Check check) {
  const oracle::Balls balls = {{0, 0, 105, 5},  {3, 0, 104, 5}, {-3, 4, 100, 5},
                               {0, -5, 100, 5}, {0, 3, 104, 5}, {-5, 0, 100, 5}};
  oracle::RandomSource random(5);
  for (int k = 0; k < orders; ++k) {
    oracle::Balls some = oracle::permuted(balls, random.permutation(balls.size()));
    some.resize(static_cast<std::size_t>(random.in(2, 6)));
    some.push_back({0, 0, 120, 6});
    const BuiltGrid grid(oracle::in_lengths(some, 1));
    for (const int64_t z : {99, 90, 0, -1000, -1000000}) check(k, some, grid, z);
  }
}
