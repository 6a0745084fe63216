// The work of cavities.c by hardsphere.hpp: cavities of a molecule, and whether something inside can get out.
//   cavities                               six balls that close a cage, and a seventh inside
//   cavities FILE.xyzr [PROBE [X Y Z]]     where the point lies, and whether it is shut in
#include <cstdio>
#include <cstdlib>
#include <hardsphere.hpp>

#include "read_balls.hpp"

namespace {

Balls cage() {
  return {{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0.05, 0, 0}, {0.9, 0.9, 0.9, 0.9, 0.9, 0.9, 0.02}};
}

void print_cavities(hardsphere::workspace &work) {
  const auto regions = hardsphere::all(hsp_topology_get_regions, work.topology());
  std::printf("cavities: %zu\n", regions.size() - 1);
  for (uint32_t k = 1; k < regions.size(); ++k) {  // region 0 is the outside
    std::printf("cavity %u: volume %.6f, area %.6f, pieces inside %u, balls around:", k, regions[k].volume,
                regions[k].area, regions[k].components);
    for (uint32_t ball : hardsphere::all(hsp_topology_get_region_balls, work.topology(), k)) std::printf(" %u", ball);
    std::printf("\n");
  }
}

void print_way_out(hardsphere::workspace &work, const double *point) {
  uint32_t region = HSP_NONE;
  hardsphere::check(hsp_topology_locate(work.topology(), point, &region));
  std::printf("the point %g %g %g lies ", point[0], point[1], point[2]);
  if (region == HSP_NONE) {
    std::printf("in a ball\n");
  } else if (region == 0) {  // a point, and a probe's centre, moves freely within its region
    std::printf("outside\n");
  } else {
    std::printf("in cavity %u and cannot get out\n", region);
  }
}

}  // namespace

int main(int count, char **arguments) try {
  double point[3] = {-0.05, 0, 0};
  Balls balls = count == 1 ? cage() : Balls{};
  if (count > 1) add_balls(balls, arguments[1]);
  const double probe = count > 2 ? std::strtod(arguments[2], nullptr) : 0;
  for (int axis = 0; axis < 3 && axis + 3 < count; ++axis) point[axis] = std::strtod(arguments[axis + 3], nullptr);
  hardsphere::workspace work(balls.xyz, balls.radius, {.probe = probe});
  print_cavities(work);
  if (count == 1 || count > 5) print_way_out(work, point);
  return 0;
} catch (const std::exception &failure) {
  std::fprintf(stderr, "cavities: %s\n", failure.what());
  return 1;
}
