// Sets of balls that have made trouble for somebody, with the topology that they have by construction.
#ifndef HARDSPHERE_TESTS_ORACLE_NAMED_BALLS_HPP
#define HARDSPHERE_TESTS_ORACLE_NAMED_BALLS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

struct NamedBalls {
  std::string name;
  Balls balls;
  std::uint32_t components = 1;
  std::uint32_t voids = 0;
  std::optional<std::int64_t> euler = std::nullopt;  // 2 (components + voids - tunnels), where the tunnels are obvious
};

/// At most about 60 balls each.
std::vector<NamedBalls> named_balls();

}  // namespace oracle

#endif
