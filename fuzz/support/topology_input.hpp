// Sets of balls with much topology: faces with many loops, among them circles with common and touching planes, and
// walls around walls with holes here and there.
#pragma once

#include <utility>

#include "fuzz_input.hpp"

namespace fuzz {

// A large ball and small ones in directions with integer lengths, so that many axes lie in common vertical planes,
// poles are hit exactly, and circles touch each other and those planes.
inline ScaledBalls studded_ball(Bytes &bytes) {
  constexpr int64_t tenth = 3465;  // a multiple of every length in `pythagorean`
  constexpr int64_t radius = 10 * tenth;
  // distance and radius, in tenths of the large radius: centred on the sphere, at a pythagorean triple (the circle's
  // plane at distance 8, its radius 6), touching from outside and from inside, buried, and an odd one
  static constexpr std::pair<int64_t, int64_t> places[] = {{10, 2}, {10, 1}, {8, 6},  {10, 4},
                                                           {12, 2}, {9, 1},  {10, 5}, {11, 3}};
  ScaledBalls set;
  const uint32_t n = bytes.below(25);
  const bool shaken = bytes.one_in(3);
  set.balls.push_back({0, 0, 0, radius});
  for (uint32_t k = 0; k < n; ++k) {
    const oracle::LatticeBall &direction = pythagorean[bytes.below(static_cast<uint32_t>(std::size(pythagorean)))];
    const auto &[distance, small] = places[bytes.below(static_cast<uint32_t>(std::size(places)))];
    const uint32_t turn = bytes.below(24);  // three rotations of the axes, eight reflections
    oracle::LatticePoint centre{};
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const int64_t along = centre_of(direction)[(axis + turn) % 3] * (distance * tenth / direction.radius);
      centre[axis] = (turn / 3 >> axis & 1U) != 0 ? -along : along;
      if (shaken && bytes.one_in(4)) centre[axis] += bytes.below(3) - int64_t{1};
    }
    set.balls.push_back(oracle::ball_around(centre, small * tenth));
  }
  return set;
}

// Up to three closed walls of 26 balls in each other, some balls of them left out or moved by a little, and a few
// balls anywhere.
inline ScaledBalls nested_walls(Bytes &bytes) {
  ScaledBalls set;
  const uint32_t walls = 1 + bytes.below(3);
  const uint32_t missing = bytes.below(40), moved = bytes.below(40);
  int64_t spacing = 4;
  uint32_t place = 0;
  for (uint32_t wall = 0; wall < walls; ++wall, spacing *= 8) {
    const int64_t shift = bytes.one_in(3) ? bytes.below(3) - int64_t{1} : 0;
    for (oracle::LatticeBall ball : oracle::cage_of_26(spacing, 3 * spacing / 4)) {
      if (place++ == missing) continue;
      ball.x += shift;
      if (place == moved) ball.z += bytes.below(5) - int64_t{2};
      set.balls.push_back(ball);
    }
  }
  const auto reach = static_cast<uint32_t>(spacing / 4);
  for (uint32_t more = bytes.below(6); more > 0; --more) {
    oracle::LatticePoint centre{};
    for (int64_t &coordinate : centre) coordinate = bytes.below(2 * reach + 1) - int64_t{reach};
    set.balls.push_back(oracle::ball_around(centre, bytes.below(4)));
  }
  return set;
}

inline ScaledBalls topology_set(Bytes &bytes) {
  switch (bytes.below(4)) {
    case 2:
      return studded_ball(bytes);
    case 3:
      return nested_walls(bytes);
    default:
      return ball_set(bytes, 32);
  }
}

}  // namespace fuzz
