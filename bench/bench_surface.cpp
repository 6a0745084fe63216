// The smooth surface over size, by turns with the solvent-accessible boundary that it stands on: hsp_surface_compute,
// hsp_surface_measure and hsp_surface_gradient. And triangles of that boundary.
#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

constexpr double probe = 1.4;  // Angstrom
constexpr double edge = 0.5;   // of the triangles

void boundary_and_surface(benchmark::State &state, Subject &subject) {
  SmoothSurface surface(*subject.boundary);
  // The surface is computed anew with the boundary: what it was computed from has changed.
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
  hsp_mesh_limits limits{};
  expect_ok(hsp_mesh_limits_init(&limits, sizeof limits, subject.boundary->get(), edge), "hsp_mesh_limits_init");
  support::OwnedHandle<support::MeshKind> mesh;
  mesh.take(limits);
  const auto compute = [&] {
    mesh.compute([&](hsp_mesh *handle, hsp_mesh_limits *wanted) {
      return hsp_mesh_compute(handle, subject.boundary->get(), edge, wanted);
    });
  };
  compute();
  for (auto iteration : state) {
    static_cast<void>(iteration);
    compute();
  }
  hsp_mesh_counts counts{};
  expect_ok(hsp_mesh_get_counts(mesh.get(), &counts), "hsp_mesh_get_counts");
  state.counters["triangles"] = counts.triangles;
  state.counters["bytes"] = static_cast<double>(mesh.bytes());
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
}

}  // namespace bench
