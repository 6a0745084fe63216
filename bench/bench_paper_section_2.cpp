// Section 2: the table of k, rho, and how many balls meet a ball, for the paper's molecules and radii; and Figure 4,
// how large vertical decompositions are beside the library's cells. Free space: its cells by turns with Steps 1 and 2,
// in which of them points lie, and paths between some of these; and how many times cells are cut for a widest probe.
#include <algorithm>

#include "alternation.hpp"
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

hsp_cells_counts cells_of(const Model &model) {
  hsp_cells_limits limits{};
  expect_ok(hsp_cells_limits_init(&limits, sizeof limits, model.size()), "hsp_cells_limits_init");
  support::OwnedHandle<support::CellsKind> cells;
  cells.take(limits);
  cells.compute(
      [&](hsp_cells *handle, hsp_cells_limits *asked) { return hsp_cells_compute(handle, model.get(), asked); });
  hsp_cells_counts counts{};
  expect_ok(hsp_cells_get_counts(cells.get(), &counts), "hsp_cells_get_counts");
  return counts;
}

// Counted once: what matters are the counts.
void register_decompositions(const std::string &name, const SubjectRecipe &recipe, Spheres kind) {
  register_case(name, recipe,
                [kind](benchmark::State &state, Subject &subject) {
                  const std::vector<Sphere> spheres = spheres_of(subject.balls);
                  DecompositionSize space, cubes;
                  for (auto iteration : state) {
                    static_cast<void>(iteration);
                    space = decomposition_of_space(spheres, kind);
                    cubes = decomposition_in_cubes(spheres, kind);
                  }
                  const hsp_cells_counts cells = cells_of(*subject.model);
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

struct FreeSpace {
  explicit FreeSpace(const Model &of) : model(of) {
    hsp_cells_limits cell_limits{};
    hsp_paths_limits path_limits{};
    expect_ok(hsp_cells_limits_init(&cell_limits, sizeof cell_limits, model.size()), "hsp_cells_limits_init");
    expect_ok(hsp_paths_limits_init(&path_limits, sizeof path_limits, model.size()), "hsp_paths_limits_init");
    path_limits.points = 100000;
    cells.take(cell_limits);
    compute();
    paths.take(path_limits);
    paths.compute(
        [&](hsp_paths *made, hsp_paths_limits *asked) { return hsp_paths_compute(made, model.get(), asked); });
  }
  void compute() {
    cells.compute(
        [&](hsp_cells *made, hsp_cells_limits *asked) { return hsp_cells_compute(made, model.get(), asked); });
  }
  uint32_t cell_at(const double *xyz) const {
    uint32_t cell = HSP_NONE;
    expect_ok(hsp_cells_locate(cells.get(), xyz, &cell), "hsp_cells_locate");
    return cell;
  }

  const Model &model;
  support::OwnedHandle<support::CellsKind> cells;
  support::OwnedHandle<support::PathsKind> paths;
};

// How often cells were cut for the widest probe from a point to the outside.
uint32_t gate_builds(const Model &model, const double *from) {
  hsp_gate_limits limits{};
  expect_ok(hsp_gate_limits_init(&limits, sizeof limits, model.size()), "hsp_gate_limits_init");
  support::OwnedHandle<support::GateKind> gate;
  gate.take(limits);
  gate.compute([&](hsp_gate *made, hsp_gate_limits *asked) {
    return hsp_gate_compute(made, model.get(), from, nullptr, asked);
  });
  hsp_widest_probe widest{};
  expect_ok(hsp_gate_get(gate.get(), &widest), "hsp_gate_get");
  return widest.builds;
}

void free_space(benchmark::State &state, Subject &subject) {
  constexpr size_t points = 10000, ways = 20;
  constexpr uint32_t few = 1000;  // balls, so that a gate does not take seconds
  const Model &model = *subject.model;
  FreeSpace space(model);
  const std::vector<double> box = random_points_in_box(model, points);
  const std::vector<double> ends = random_points_near_surface(model, 2 * ways);
  uint64_t sum = 0;
  alternate(state, model.size(),
            {{"boundary", [&] { subject.boundary->compute(); }},
             {"cells", [&] { space.compute(); }},
             {"locate",
              [&] {
                for (size_t k = 0; k < points; ++k) sum += space.cell_at(&box[3 * k]);
              }},
             {"paths", [&] {
                for (size_t k = 0; k < ways; ++k) {
                  hsp_path path{};
                  expect_ok(hsp_paths_find(space.paths.get(), &ends[6 * k], &ends[6 * k + 3], &path, nullptr),
                            "hsp_paths_find");
                  sum += path.points;
                }
              }}});
  benchmark::DoNotOptimize(sum);
  state.counters["locate_each"] = state.counters["locate_seconds"] / static_cast<double>(points);
  state.counters["path_each"] = state.counters["paths_seconds"] / static_cast<double>(ways);
  uint32_t builds = 0;
  if (model.size() < few) {
    for (size_t k = 0; k < 4; ++k) builds = std::max(builds, gate_builds(model, &ends[3 * k]));
  }
  state.counters["gate_builds"] = builds;
}

}  // namespace

void register_suite() {
  for (const Molecule &molecule : paper_molecules()) {
    const SubjectRecipe recipe{molecule.name, [molecule] { return with_radii(molecule, Radii::paper); }};
    register_case("section_2/figures/" + molecule.name, recipe, [](benchmark::State &state, Subject &subject) {
      hsp_packing figures{};
      for (auto iteration : state) {
        static_cast<void>(iteration);
        expect_ok(hsp_model_get_packing(subject.model->get(), &figures), "hsp_model_get_packing");
      }
      state.counters["k"] = figures.k;
      state.counters["rho"] = figures.rho;
      state.counters["max"] = figures.max_overlaps;
      state.counters["mean"] = figures.mean_overlaps;
      state.counters["bound"] = figures.neighbour_bound;
    })->Unit(benchmark::kMicrosecond);
  }
  for (const Surface &surface : surfaces) {
    const std::string group = std::string("section_2/free_space/") + surface.name + '/';
    for (const Molecule &molecule : paper_molecules()) {
      const SubjectRecipe recipe{group + molecule.name,
                                 [molecule] { return with_radii(molecule, Radii::van_der_waals); }, surface.probe,
                                 Stage::boundary};
      register_case(group + molecule.name, recipe, free_space)->Unit(benchmark::kMillisecond);
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
