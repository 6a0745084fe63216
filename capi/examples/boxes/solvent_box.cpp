// The work of solvent_box.c by hardsphere.hpp: waters around a molecule in a periodic box.
//   solvent_box FILE.xyzr AX BY CZ
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <hardsphere.hpp>

#include "../read_balls.hpp"

namespace {

constexpr double water = 1.4, spacing = 2.9;
constexpr double first_shell = 0.5;  // balls at most twice that apart are neighbours

// Waters at the points of a grid that are in no ball of the box: the molecule's, larger by a water's radius.
void add_waters(hardsphere::box &box, const double (&length)[3], Balls &balls) {
  int many[3];
  for (int axis = 0; axis < 3; ++axis) many[axis] = static_cast<int>(length[axis] / spacing);
  for (int k = 0; k < many[0] * many[1] * many[2]; ++k) {
    const int at[3] = {k % many[0], k / many[0] % many[1], k / many[0] / many[1]};
    double point[3];
    for (int axis = 0; axis < 3; ++axis) point[axis] = (at[axis] + 0.5) * length[axis] / many[axis];
    if (!hardsphere::all(hsp_periodic_query_point, box.periodic(), &point[0]).empty()) continue;
    balls.xyz.insert(balls.xyz.end(), point, point + 3);
    balls.radius.push_back(water);
  }
}

void print_volumes(hardsphere::box &box, const char *what) {
  const hsp_periodic_totals total = box.measure().total;
  std::printf("%s: volume %.6f, area %.6f, free %.6f of %.6f\n", what, total.volume, total.area, total.free_volume,
              total.box_volume);
}

}  // namespace

int main(int count, char **arguments) try {
  double length[3];
  bool good = count == 5;
  for (int axis = 0; axis < 3 && good; ++axis) {
    length[axis] = std::strtod(arguments[2 + axis], nullptr);
    good = length[axis] >= spacing && length[axis] <= 1000 * spacing;
  }
  if (!good) {
    std::fprintf(stderr, "usage: solvent_box FILE.xyzr AX BY CZ      lengths from %g to %g\n", spacing, 1000 * spacing);
    return 2;
  }
  Balls balls;
  add_balls(balls, arguments[1]);
  const auto solute = static_cast<uint32_t>(balls.radius.size());
  hardsphere::box box(balls.xyz, balls.radius, length);
  print_volumes(box, "molecule");
  add_waters(box.set(balls.xyz, balls.radius, length, {.probe = water}), length, balls);
  std::printf("%zu waters\n", balls.radius.size() - solute);
  print_volumes(box.set(balls.xyz, balls.radius, length), "with waters");
  box.set(balls.xyz, balls.radius, length, {.probe = first_shell});
  std::vector<bool> mark(box.size());
  for (uint32_t i = 0; i < solute; ++i) {
    for (const hsp_image &near : hardsphere::all(hsp_periodic_query_neighbours, box.periodic(), i))
      if (near.ball >= solute) mark[near.ball] = true;
  }
  std::printf("%u waters no more than %g from the molecule\n",
              static_cast<unsigned>(std::count(mark.begin(), mark.end(), true)), 2 * first_shell);
  const auto windings = hardsphere::all(hsp_periodic_get_windings, box.periodic());
  uint32_t most = 0, largest = 0;
  for (const hsp_winding &winding : windings) {
    most = std::max(most, winding.directions);
    largest = std::max(largest, winding.balls);
  }
  std::printf("%zu components, the largest of %u balls, endless in %u directions at most\n", windings.size(), largest,
              most);
  return 0;
} catch (const std::exception &failure) {
  std::fprintf(stderr, "solvent_box: %s\n", failure.what());
  return 1;
}
