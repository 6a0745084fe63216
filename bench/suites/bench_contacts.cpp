// Contacts with shares, and the mean curvature with its gradient, over size: hsp_contacts_compute,
// hsp_boundary_curvature and hsp_boundary_get_morphometry by turns with hsp_boundary_compute.
#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

void boundary_and_contacts(benchmark::State &state, Subject &subject) {
  Contacts contacts(*subject.boundary);
  // Contacts are made anew from the boundary: computing the boundary again has made the earlier ones invalid.
  alternate(state, subject.model->size(),
            {{"boundary", [&] { subject.boundary->compute(); }},
             {"contacts", [&] { contacts.compute(); }},
             {"curvature", [&] { benchmark::DoNotOptimize(subject.boundary->curvature()); }},
             {"curvature_gradient", [&] { benchmark::DoNotOptimize(subject.boundary->curvature_gradient()); }}});
  const double atoms = subject.model->size();
  const hsp_complex simplices = contacts.complex();
  const auto per_atom = [&](int dimension) {
    return (simplices.singular[dimension] + simplices.regular[dimension] + simplices.interior[dimension]) / atoms;
  };
  state.counters["bytes"] = static_cast<double>(contacts.bytes());
  state.counters["contacts_per_atom"] = per_atom(1);
  state.counters["triangles_per_atom"] = per_atom(2);
}

}  // namespace

void register_suite() {
  for (const Surface &surface : surfaces) {
    const std::string group = std::string("contacts/") + surface.name + '/';
    for (const Size &size : all_sizes()) {
      const SubjectRecipe recipe{group + size.name, size.balls, surface.probe, Stage::boundary};
      register_case(group + "compute/" + size.name, recipe, boundary_and_contacts)->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench
