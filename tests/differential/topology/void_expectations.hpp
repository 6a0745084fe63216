// Expectations of the voids of a molecule.
#pragma once

#include <gtest/gtest.h>

#include <iostream>

#include "brute_queries.hpp"
#include "molecule_balls.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"
#include "void_comparison.hpp"

inline oracle::Balls bench_atoms(const std::string &file) {
  return read_molecule(support::own_molecule(file));
}

// A part of the volume, but for 0.01 cubic angstrom, must lie between bounds proved by flood fill, and those of voids
// larger than 0.1 cubic angstrom must be close. All else must agree always.
inline void expect_voids(const std::string &name, const oracle::Balls &atoms, int64_t probe, long double part,
                         const VoidSettings &settings = {}) {
  const VoidFindings found = compare_voids(grown(atoms, probe), settings);
  std::cout << name << ": " << found.voids << " voids of " << static_cast<double>(found.volume) / 1e9
            << " cubic angstrom; bounds for " << found.bounded << " of them (" << found.told_apart
            << " one by one) and for " << static_cast<double>(found.bounded_volume) / 1e9 << ", at most "
            << static_cast<double>(found.widest) << " wide; " << found.regions << " regions of the filling\n";
  EXPECT_EQ(found.wrong, "") << name;
  EXPECT_GE(found.bounded_volume, part * found.volume - 1e7L) << name;
  EXPECT_LE(found.widest, settings.width) << name;
}

// Random points in the box around a molecule: the balls that contain them by brute force, and the cells of certain
// regions.
inline void expect_locations(const oracle::Balls &atoms, int64_t probe, int points) {
  const oracle::Balls balls = grown(atoms, probe);
  const LibraryTopology topology(balls);
  const oracle::Box box = oracle::box_around(balls, 200);
  const oracle::FloodFill fill(balls, box, 100);
  oracle::RandomSource random(71);
  int in_balls = 0;
  int in_regions = 0;
  for (int k = 0; k < points; ++k) {
    oracle::LatticePoint point{};
    for (size_t axis = 0; axis < 3; ++axis) point[axis] = random.in(box.low[axis], box.high[axis] - 1);
    const uint32_t cell = topology.cell_of(point);
    const bool in_ball = !oracle::balls_meeting(balls, {point[0], point[1], point[2], 0}).empty();
    ASSERT_EQ(cell == HSP_NONE, in_ball);
    in_balls += in_ball ? 1 : 0;
    const auto region = fill.certain_at(point);
    if (!region) continue;
    ++in_regions;
    const oracle::LatticePoint &known = fill.certain()[*region].point;
    ASSERT_EQ(cell, topology.cell_of(known));
    ASSERT_TRUE(cell == 0 || !fill.certain()[*region].reaches_border);
  }
  EXPECT_GT(in_balls, points / 10);
  EXPECT_GT(in_regions, points / 10);
}
