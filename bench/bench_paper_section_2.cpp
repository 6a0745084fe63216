// Section 2: the table of k, rho, and how many balls meet a ball, for the paper's molecules and radii; and Figure 4,
// how large vertical decompositions are beside the library's cells.
#include "section_2/vertical_decomposition.hpp"
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
