// A set of balls with ties, and what is known about its union.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lattice_ball.hpp"

namespace degenerate {

// Of a union of balls; shells and euler are those of its boundary.
struct Topology {
  int64_t components = 0;
  int64_t voids = 0;
  int64_t shells = 0;
  int64_t euler = 0;
  bool operator==(const Topology &) const = default;
};

struct DegenerateSet {
  std::string name;
  oracle::Balls balls;
  std::optional<Topology> expected = std::nullopt;
  std::string source;  // where `expected` is from
  double step = 1;     // length
};

// The sets of a file in the format that degenerate_sets.txt describes. Throws std::runtime_error with the line's
// number on anything else.
std::vector<DegenerateSet> read_sets(const std::filesystem::path &file);

// Sets that are made rather than listed: those of tests/oracle, lattices of many radii, cages, rings, shells, belts.
std::vector<DegenerateSet> made_sets();

}  // namespace degenerate
