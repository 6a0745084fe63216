// The work of neighbour_list.c by hardsphere.hpp: all pairs of atoms at most a cutoff apart, each once.
//   neighbour_list FILE.xyzr CUTOFF [PRINT]
#include <cstdio>
#include <cstdlib>
#include <hardsphere.hpp>

#include "read_balls.hpp"

int main(int count, char **arguments) try {
  if (count < 3 || count > 4) {
    std::fprintf(stderr, "usage: neighbour_list FILE.xyzr CUTOFF [PRINT]\n");
    return 2;
  }
  Balls points;
  add_balls(points, arguments[1]);
  // Points that have half the cutoff about them meet if they are at most a cutoff apart.
  const std::vector<double> no_radius(points.radius.size());
  hardsphere::workspace work(points.xyz, no_radius, {.probe = std::strtod(arguments[2], nullptr) / 2});
  const hardsphere::neighbours list = work.pairs();
  std::printf("%zu pairs\n", list.ids.size());
  for (uint32_t i = 0; count == 4 && i < work.size(); ++i) {
    std::printf("%u:", i);
    for (uint32_t j : list.of(i)) std::printf(" %u", j);
    std::printf("\n");
  }
  return 0;
} catch (const std::exception &failure) {
  std::fprintf(stderr, "neighbour_list: %s\n", failure.what());
  return 1;
}
