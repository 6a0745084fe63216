// Step 3 over size: hsp_topology_compute by turns with hsp_boundary_compute, the memory it takes, and which region of
// the complement a point lies in (hsp_topology_locate). "box": uniform in the surrounding box; "surface": outside all
// balls, within 1 Angstrom of them.
#include <stdexcept>

#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

constexpr size_t queries = 100000;

// Requires that the topology has the boundary's Euler characteristic, so that the times are those of a right result.
void require_euler(const hsp_topology_counts &topology, const hsp_boundary_counts &boundary) {
  const int64_t euler = int64_t{topology.vertices} - int64_t{topology.edges} + topology.simple_faces;
  if (euler != boundary.euler) throw std::runtime_error("vertices - edges + simple faces is not the Euler number");
}

void boundary_and_topology(benchmark::State &state, Subject &subject) {
  alternate(state, subject.model->size(),
            {{"boundary", [&] { subject.boundary->compute(); }}, {"topology", [&] { subject.topology->compute(); }}});
  const double atoms = subject.model->size();
  const hsp_boundary_counts boundary = subject.boundary->counts();
  const hsp_topology_counts topology = subject.topology->counts();
  require_euler(topology, boundary);
  state.counters["faces_per_atom"] = boundary.faces / atoms;
  state.counters["simple_faces_per_atom"] = topology.simple_faces / atoms;
  state.counters["edges_per_atom"] = topology.edges / atoms;
  state.counters["cut_edges_per_atom"] = topology.cut_edges / atoms;
  state.counters["components"] = topology.components;
  state.counters["voids"] = topology.regions - 1;
  state.counters["bytes"] = static_cast<double>(subject.topology->bytes());
  state.counters["bytes_by_default"] = static_cast<double>(subject.topology->bytes_by_default());
}

void locate(benchmark::State &state, Subject &subject, const std::vector<double> &points) {
  Located located;
  iterate(state, [&] { located = locate_points(*subject.topology, points); });
  const double count = static_cast<double>(points.size()) / 3;
  state.counters["queries"] = count;
  state.counters["inside_share"] = static_cast<double>(located.inside) / count;
  state.counters["void_share"] = static_cast<double>(located.in_voids) / count;
}

}  // namespace

void register_suite() {
  for (const Surface &surface : surfaces) {
    const std::string group = std::string("topology/") + surface.name + '/';
    for (const Size &size : all_sizes()) {
      const SubjectRecipe recipe{group + size.name, size.balls, surface.probe, Stage::topology};
      register_case(group + "compute/" + size.name, recipe, boundary_and_topology)->Unit(benchmark::kMicrosecond);
      register_case(group + "locate_box/" + size.name, recipe, [](benchmark::State &state, Subject &subject) {
        locate(state, subject, random_points_in_box(*subject.model, queries));
      })->Unit(benchmark::kMicrosecond);
      register_case(group + "locate_surface/" + size.name, recipe, [](benchmark::State &state, Subject &subject) {
        locate(state, subject, random_points_near_surface(*subject.model, queries));
      })->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench
