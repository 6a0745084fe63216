// The smooth surface over size (hsp_surface_compute, hsp_surface_measure and hsp_surface_get_gradient) by turns with
// the solvent-accessible boundary that it is made from; and triangles of this boundary. Also the area and volume of the
// smooth surface of the two molecules for which results of other programs are known.
#include <filesystem>
#include <string>

#include "alternation.hpp"
#include "molecule_file.hpp"
#include "sizes.hpp"
#include "smooth_surface.hpp"
#include "suite.hpp"

namespace bench {
namespace {

constexpr double probe = 1.4;  // Angstrom

void boundary_and_surface(benchmark::State &state, Subject &subject) {
  SmoothSurface surface(*subject.boundary);
  // The surface is made anew from the boundary: computing the boundary again has made the earlier surface invalid.
  alternate(state, subject.model->size(),
            {{"boundary", [&] { subject.boundary->compute(); }},
             {"surface", [&] { surface.compute(); }},
             {"measure", [&] { benchmark::DoNotOptimize(surface.measure()); }},
             {"gradient", [&] { benchmark::DoNotOptimize(surface.gradient()); }}});
  const double atoms = subject.model->size();
  const hsp_surface_counts counts = surface.counts();
  state.counters["bytes"] = static_cast<double>(surface.bytes());
  state.counters["concave_per_atom"] = counts.concave_patches / atoms;
  state.counters["cut_share"] = static_cast<double>(counts.cut_patches) / counts.concave_patches;
}

void triangles(benchmark::State &state, Subject &subject) {
  Triangles mesh(*subject.boundary);
  iterate(state, [&] { mesh.compute(); });
  state.counters["triangles"] = mesh.count();
  state.counters["bytes"] = static_cast<double>(mesh.bytes());
}

// Area and volume of a surface, which the report compares with known values.
void area_and_volume(benchmark::State &state, Subject &subject) {
  SmoothSurface surface(*subject.boundary);
  hsp_surface_totals totals{};
  iterate(state, [&] { totals = surface.measure(); });
  state.counters["area"] = totals.area;
  state.counters["volume"] = totals.volume;
}

void register_accuracy(const std::string &entry, const std::filesystem::path &file, support::Records records) {
  const Molecule molecule{entry, support::read_atoms(file, records)};
  const SubjectRecipe recipe{"surface/accuracy/" + entry,
                             [molecule] { return with_radii(molecule, Radii::metals_as_sulfur); }, probe,
                             Stage::boundary};
  register_case(recipe.key, recipe, area_and_volume)->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_suite() {
  for (const Size &size : all_sizes()) {
    const SubjectRecipe recipe{"surface/" + size.name, size.balls, probe, Stage::boundary};
    register_case("surface/compute/" + size.name, recipe, boundary_and_surface)->Unit(benchmark::kMicrosecond);
  }
  for (const Size &size : molecule_sizes()) {
    const SubjectRecipe recipe{"surface/mesh/" + size.name, size.balls, probe, Stage::boundary};
    register_case("surface/mesh/" + size.name, recipe, triangles)->Unit(benchmark::kMicrosecond);
  }
  register_accuracy("1CRN", support::own_molecule("crambin.pdb"), support::Records::all);
  if (const auto path = support::further_molecule("4hhb.pdb.gz")) {
    register_accuracy("4HHB", *path, support::Records::protein);
  } else {
    register_skipped("surface/accuracy/4HHB", "no 4hhb.pdb.gz in HSP_MOLECULES");
  }
}

}  // namespace bench
