// The table of the paper's Section 4.2: the times of Steps 1 to 3 for the paper's molecules and radii.
//
// Step 1, finding the neighbours of every ball, is timed through hsp_query_neighbours. Step 2 cannot be called on its
// own: hsp_boundary_compute, starting from the model, does Steps 1 and 2 and also finds faces and shells. Step 3 is
// hsp_topology_compute, starting from this boundary.
#include "suite.hpp"

namespace bench {
namespace {

void step_1(benchmark::State &state, Subject &subject) {
  size_t neighbours = 0;
  iterate(state, [&] { neighbours = query_all_neighbours(*subject.model); });
  state.counters["neighbours_per_atom"] = static_cast<double>(neighbours) / subject.model->size();
}

void boundary(benchmark::State &state, Subject &subject) {
  iterate(state, [&] { subject.boundary->compute(); });
  const hsp_boundary_counts counts = subject.boundary->counts();
  state.counters["vertices"] = counts.vertices;
  state.counters["arcs"] = counts.arcs;
  state.counters["circles"] = counts.circles;
  state.counters["faces"] = counts.faces;
  state.counters["shells"] = counts.shells;
}

void step_3(benchmark::State &state, Subject &subject) {
  iterate(state, [&] { subject.topology->compute(); });
}

void boundary_and_measure(benchmark::State &state, Subject &subject) {
  hsp_totals totals{};
  iterate(state, [&] {
    subject.boundary->compute();
    totals = subject.boundary->measure();
  });
  state.counters["area"] = totals.area;
  state.counters["volume"] = totals.volume;
}

}  // namespace

void register_suite() {
  for (const Molecule &molecule : paper_molecules()) {
    const SubjectRecipe recipe{molecule.name, [molecule] { return with_radii(molecule, Radii::paper); }, 0,
                               Stage::topology};
    register_case("section_4_2/step_1/" + molecule.name, recipe, step_1)->Unit(benchmark::kMicrosecond);
    register_case("section_4_2/boundary/" + molecule.name, recipe, boundary)->Unit(benchmark::kMicrosecond);
    register_case("section_4_2/step_3/" + molecule.name, recipe, step_3)->Unit(benchmark::kMicrosecond);
    register_case("section_4_2/boundary_and_measure/" + molecule.name, recipe, boundary_and_measure)
        ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace bench
