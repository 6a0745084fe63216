// The table of Section 2: k, rho, and how many balls meet a ball, for the paper's molecules and radii.
#include "suite.hpp"

namespace bench {

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
}

}  // namespace bench
