// Sets of balls with names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

struct NamedBalls {
  std::string name;
  Balls balls;
};

// With the topology that they have by construction.
struct KnownBalls {
  std::string name;
  Balls balls;
  uint32_t components = 1;
  uint32_t voids = 0;
  std::optional<int64_t> euler = std::nullopt;  // 2 (components + voids - tunnels), where the tunnels are obvious
};

// Sets that have made trouble for somebody, of at most about 60 balls each.
std::vector<KnownBalls> known_balls();

}  // namespace oracle
