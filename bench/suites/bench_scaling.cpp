// Time over size: van der Waals and solvent-accessible balls (probe 1.4) from caffeine to a million balls.
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

void build(benchmark::State &state, Subject &subject) {
  iterate(state, [&] { subject.model->set(); });
}

void lists(benchmark::State &state, Subject &subject) {
  size_t neighbours = 0;
  iterate(state, [&] { neighbours = query_all_neighbours(*subject.model); });
  state.counters["neighbours_per_atom"] = static_cast<double>(neighbours) / subject.model->size();
}

void pairs(benchmark::State &state, Subject &subject) {
  std::vector<uint32_t> first, ids;
  size_t neighbours = query_all_pairs(*subject.model, first, ids);
  iterate(state, [&] { neighbours = query_all_pairs(*subject.model, first, ids); });
  state.counters["neighbours_per_atom"] = static_cast<double>(neighbours) / subject.model->size();
}

void boundary(benchmark::State &state, Subject &subject) {
  iterate(state, [&] { subject.boundary->compute(); });
  const hsp_boundary_counts counts = subject.boundary->counts();
  state.counters["vertices_per_atom"] = static_cast<double>(counts.vertices) / subject.model->size();
  state.counters["exposed_share"] = static_cast<double>(counts.exposed_balls) / subject.model->size();
  state.counters["bytes_per_atom"] = static_cast<double>(subject.boundary->bytes()) / subject.model->size();
}

void measure(benchmark::State &state, Subject &subject) {
  // An earlier benchmark of this subject may have set its model anew, which makes the boundary invalid.
  subject.boundary->compute();
  hsp_totals totals{};
  iterate(state, [&] { totals = subject.boundary->measure(); });
  state.counters["area"] = totals.area;
  state.counters["volume"] = totals.volume;
}

void everything(benchmark::State &state, Subject &subject) {
  iterate(state, [&] {
    subject.model->set();
    subject.boundary->compute();
    benchmark::DoNotOptimize(subject.boundary->measure());
  });
}

void register_subject(const std::string &name, const Surface &surface, std::function<Balls()> balls) {
  const SubjectRecipe recipe{std::string(surface.name) + '/' + name, std::move(balls), surface.probe, Stage::boundary};
  const std::string group = std::string("scaling/") + surface.name + '/';
  register_case(group + "build/" + name, recipe, build)->Unit(benchmark::kMicrosecond);
  register_case(group + "lists/" + name, recipe, lists)->Unit(benchmark::kMicrosecond);
  register_case(group + "pairs/" + name, recipe, pairs)->Unit(benchmark::kMicrosecond);
  register_case(group + "boundary/" + name, recipe, boundary)->Unit(benchmark::kMicrosecond);
  register_case(group + "measure/" + name, recipe, measure)->Unit(benchmark::kMicrosecond);
  register_case(group + "everything/" + name, recipe, everything)->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_suite() {
  const std::pair<const char *, const char *> further[] = {{"1ubq.pdb", "ubiquitin_1ubq"},
                                                           {"sod_model_4392.pdb", "sod_model"}};
  for (const Surface &surface : surfaces) {
    for (const Size &size : all_sizes()) register_subject(size.name, surface, size.balls);
    for (const auto &[file, name] : further) {
      const auto path = support::further_molecule(file);
      if (!path) {
        register_skipped(std::string("scaling/") + surface.name + "/everything/" + name,
                         std::string("no ") + file + " in HSP_MOLECULES");
        continue;
      }
      const Molecule molecule{name, support::read_atoms(*path)};
      register_subject(name, surface, [molecule] { return with_radii(molecule, Radii::van_der_waals); });
    }
  }
}

}  // namespace bench
