// A test of the paper's Figure 4 in numbers (Theorems 2.3 and 2.4): the vertical decomposition of its spheres grows
// with the square of their number in all of space, and linearly in cubes, as do the library's cells. In all of space
// the events of disjoint spheres are known in closed form, so these counts are exact.
#include <cstdint>
#include <cstdio>

#include "free_space.hpp"
#include "handles.hpp"
#include "section_2/vertical_decomposition.hpp"

namespace {

using bench::DecompositionSize;
using bench::Spheres;

struct Counted {
  uint64_t space = 0, cubes = 0, doubtful = 0, cells = 0, adjacencies = 0;
};

Counted count(uint32_t n) {
  const std::vector<bench::Sphere> spheres = bench::figure_4(n);
  const DecompositionSize space = decomposition_of_space(spheres, Spheres::disjoint);
  const DecompositionSize cubes = decomposition_in_cubes(spheres, Spheres::disjoint);
  bench::Balls balls;
  balls.name = "figure_4";
  for (const bench::Sphere &s : spheres) balls.add(s.x, s.y, s.z, s.r);
  const hsp_cells_counts cells = bench::FreeSpace(bench::Model(balls, 0)).counts();
  return {space.cells, cubes.cells, space.doubtful + cubes.doubtful, cells.cells, cells.adjacencies};
}

bool grows() {
  bool good = true;
  const auto expect = [&](bool holds, const char *what) {
    if (holds) return;
    good = false;
    std::printf("does not hold: %s\n", what);
  };
  struct Known {
    uint32_t n;
    uint64_t space, cubes;
  };
  for (const Known &known : {Known{10, 171, 553}, {20, 501, 1070}, {40, 1611, 2134}}) {
    const Counted counted = count(known.n);
    expect(counted.space == known.space && counted.cubes == known.cubes && counted.doubtful == 0, "few spheres");
  }
  const Counted half = count(100), whole = count(200);
  for (const Counted &counted : {half, whole}) {
    std::printf("%llu cells in space, %llu in cubes, %llu of the library with %llu adjacencies\n",
                static_cast<unsigned long long>(counted.space), static_cast<unsigned long long>(counted.cubes),
                static_cast<unsigned long long>(counted.cells), static_cast<unsigned long long>(counted.adjacencies));
  }
  const auto ratio = [](uint64_t a, uint64_t b) { return static_cast<double>(a) / static_cast<double>(b); };
  expect(half.doubtful == 0 && whole.doubtful == 0, "every slice comes in order");
  expect(half.space == 8539, "8539 cells of 100 spheres in space");
  expect(whole.space == 32089, "32089 cells of 200 spheres in space");
  expect(whole.cubes > 10700 && whole.cubes < 10900, "about 10800 of these in cubes");
  expect(ratio(whole.space, half.space) > 3.7, "nearly four times as many for twice the spheres");
  expect(ratio(whole.cubes, half.cubes) < 2.05, "nearly twice as many in cubes");
  expect(ratio(whole.cells, half.cells) < 2.05, "nearly twice as many cells of the library");
  expect(ratio(whole.adjacencies, half.adjacencies) < 2.05, "nearly twice as many adjacencies");
  return good;
}

}  // namespace

int main() {
  return grows() ? 0 : 1;
}
