// The paper's Section 2: the table of k, rho and the number of balls that meet a ball, for the paper's molecules and
// radii; and for Figure 4 the sizes of vertical decompositions beside the library's cells. Also times for free space:
// its cells by turns with Steps 1 and 2, locating points in cells, and for molecules paths between some of these
// points.
#include <cstddef>
#include <optional>

#include "alternation.hpp"
#include "free_space.hpp"
#include "section_2/vertical_decomposition.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

std::vector<Sphere> spheres_of(const Balls &balls) {
  std::vector<Sphere> spheres;
  for (uint32_t i = 0; i < balls.size(); ++i) {
    const double *const centre = &balls.xyz[3 * size_t{i}];
    spheres.push_back({centre[0], centre[1], centre[2], balls.radius[i]});
  }
  return spheres;
}

Balls balls_of_figure_4(uint32_t n) {
  Balls balls;
  balls.name = "figure_4";
  for (const Sphere &s : figure_4(n)) balls.add(s.x, s.y, s.z, s.r);
  return balls;
}

// Run once: the counts matter, not the time.
void register_decompositions(const std::string &name, const SubjectRecipe &recipe, Spheres kind) {
  register_case(name, recipe,
                [kind](benchmark::State &state, Subject &subject) {
                  const std::vector<Sphere> spheres = spheres_of(subject.balls);
                  DecompositionSize space, cubes;
                  iterate(state, [&] {
                    space = decomposition_of_space(spheres, kind);
                    cubes = decomposition_in_cubes(spheres, kind);
                  });
                  const hsp_cells_counts cells = FreeSpace(*subject.model).counts();
                  state.counters["space"] = static_cast<double>(space.cells);
                  state.counters["cubes"] = static_cast<double>(cubes.cells);
                  state.counters["doubtful"] = static_cast<double>(space.doubtful + cubes.doubtful);
                  state.counters["cells"] = cells.cells;
                  state.counters["adjacencies"] = cells.adjacencies;
                })
      ->Iterations(1)
      ->Repetitions(1)
      ->Unit(benchmark::kMillisecond);
}

// Room for long paths.
struct Paths {
  explicit Paths(const Model &model) {
    hsp_paths_limits limits{};
    expect_ok(hsp_paths_limits_init(&limits, sizeof limits, model.size()), "hsp_paths_limits_init");
    limits.points = 100000;
    paths.take(limits);
    paths.compute(
        [&](hsp_paths *made, hsp_paths_limits *asked) { return hsp_paths_compute(made, model.get(), asked); });
  }
  support::OwnedHandle<support::PathsKind> paths;
};

void free_space(benchmark::State &state, Subject &subject) {
  constexpr size_t points = 10000, ways = 20;
  constexpr uint32_t many = 5000;  // balls: paths are asked for in smaller sets only
  const Model &model = *subject.model;
  FreeSpace space(model);
  const std::vector<double> box = random_points_in_box(model, points);
  uint64_t sum = 0;
  std::vector<Part> turns = {{"boundary", [&] { subject.boundary->compute(); }},
                             {"cells", [&] { space.compute(); }},
                             {"locate", [&] { sum += space.locate(box); }}};
  std::optional<Paths> paths;
  std::vector<double> ends;
  if (model.size() < many) {
    paths.emplace(model);
    ends = random_points_near_surface(model, 2 * ways);
    turns.push_back({"paths", [&] {
                       for (size_t k = 0; k < ways; ++k) {
                         hsp_path path{};
                         expect_ok(hsp_paths_find(paths->paths.get(), &ends[6 * k], &ends[6 * k + 3], &path, nullptr),
                                   "hsp_paths_find");
                         sum += path.points;
                       }
                     }});
  }
  alternate(state, model.size(), turns);
  benchmark::DoNotOptimize(sum);
  state.counters["locate_each"] = state.counters["locate_seconds"] / static_cast<double>(points);
  state.counters["path_each"] = paths ? state.counters["paths_seconds"] / static_cast<double>(ways) : 0;
}

}  // namespace

void register_suite() {
  for (const Molecule &molecule : paper_molecules()) {
    const SubjectRecipe recipe{molecule.name, [molecule] { return with_radii(molecule, Radii::paper); }};
    register_case("section_2/figures/" + molecule.name, recipe, [](benchmark::State &state, Subject &subject) {
      hsp_packing figures{};
      iterate(state,
              [&] { expect_ok(hsp_model_get_packing(subject.model->get(), &figures), "hsp_model_get_packing"); });
      state.counters["k"] = figures.k;
      state.counters["rho"] = figures.rho;
      state.counters["max"] = figures.max_overlaps;
      state.counters["mean"] = figures.mean_overlaps;
      state.counters["bound"] = figures.neighbour_bound;
    })->Unit(benchmark::kMicrosecond);
  }
  for (const Surface &surface : surfaces) {
    const std::string group = std::string("section_2/free_space/") + surface.name + '/';
    for (const Size &size : all_sizes()) {
      if (size.name.ends_with("_x216")) continue;  // gigabytes
      const SubjectRecipe recipe{group + size.name, size.balls, surface.probe, Stage::boundary};
      register_case(group + size.name, recipe, free_space)->Unit(benchmark::kMillisecond);
    }
  }
  for (const uint32_t n : {10U, 20U, 40U, 60U, 80U, 100U, 140U, 200U}) {
    const std::string size = std::to_string(n);
    const SubjectRecipe recipe{"figure_4_" + size, [n] { return balls_of_figure_4(n); }};
    register_decompositions("section_2/figure_4/" + size, recipe, Spheres::disjoint);
  }
  for (const Molecule &molecule : paper_molecules()) {
    if (molecule.atoms.size() > 100) continue;  // minutes
    const SubjectRecipe recipe{molecule.name + "_vdw",
                               [molecule] { return with_radii(molecule, Radii::van_der_waals); }};
    register_decompositions("section_2/decompositions/" + molecule.name, recipe, Spheres::any);
  }
}

}  // namespace bench
