// Pores, free space for every probe at once, over size: all maxima, gates and classes above the floor 0, also where all
// balls tie, by the library's room lib/space/pores itself. And from these pores the regions beside the balls, pockets,
// plugs in their mouths, and sizes of pockets.
#include <stdexcept>
#include <vector>

#include "free_space.hpp"
#include "pores/pores_builder.hpp"
#include "sizes.hpp"
#include "suite.hpp"
#include "tiling.hpp"

namespace bench {
namespace {

// Memory of one object that a workspace is carved for.
template <class Carved, class... Limits>
size_t carve(std::vector<unsigned char> &memory, Carved &carved, const Limits &...limits) {
  hsp::Workspace measured;
  carved.carve(measured, limits...);
  memory.resize(measured.bytes());
  hsp::Workspace workspace(memory.data(), memory.size());
  carved.carve(workspace, limits...);
  return memory.size();
}

void count_time_per_atom(benchmark::State &state, const Subject &subject) {
  state.counters["time_per_atom"] = benchmark::Counter(
      subject.balls.size(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void pores(benchmark::State &state, Subject &subject) {
  const uint32_t n = subject.balls.size();
  std::vector<unsigned char> grid_memory, memory;
  hsp::CubeGrid grid;
  carve(grid_memory, grid, n);
  uint32_t first_bad = 0;
  if (grid.build({n, subject.balls.xyz.data(), subject.balls.radius.data()}, first_bad) != hsp::Status::ok) {
    throw std::runtime_error("no grid");
  }
  hsp::PoreLimits limits;
  if (hsp::default_limits(n, limits) != hsp::Status::ok) throw std::runtime_error("no limits");
  hsp::PoresBuilder builder;
  size_t bytes = carve(memory, builder, limits);
  while (builder.build(grid, 0) == hsp::Status::capacity) {
    limits = builder.retry_limits();
    bytes = carve(memory, builder, limits);
  }
  for (auto iteration : state) {
    static_cast<void>(iteration);
    if (builder.build(grid, 0) != hsp::Status::ok) throw std::runtime_error("no pores");
  }
  const double atoms = n;
  state.counters["maxima_per_atom"] = builder.maxima().size() / atoms;
  state.counters["gates_per_atom"] = builder.gates().size() / atoms;
  state.counters["sets_per_atom"] = static_cast<double>(builder.work().triples + builder.work().quadruples) / atoms;
  state.counters["steps_per_gate"] = static_cast<double>(builder.steps()) / builder.gates().size();
  state.counters["bytes"] = static_cast<double>(bytes);
  count_time_per_atom(state, subject);
}

void regions(benchmark::State &state, Subject &subject) {
  Pores pores(*subject.model);
  pores.compute();
  hsp_pore_access access{};
  iterate(state, [&] { access = pores.find_regions(*subject.boundary); });
  state.counters["blocked"] = access.blocked;
  count_time_per_atom(state, subject);
}

// Times one stage of pockets. counted: the name of the counter for the number that the stage returns.
void pockets(benchmark::State &state, Subject &subject, const char *counted, uint32_t (Pockets::*stage)()) {
  Pockets pockets(*subject.model);
  uint32_t count = 0;
  iterate(state, [&] { count = (pockets.*stage)(); });
  state.counters[counted] = count;
  count_time_per_atom(state, subject);
}

}  // namespace

void register_suite() {
  for (const Size &size : all_sizes()) {
    register_case("pores/" + size.name, {"pores/" + size.name, size.balls, 0.0, Stage::model}, pores)
        ->Unit(benchmark::kMillisecond);
  }
  register_case("pores/tied", {"pores/tied", [] { return tied_lattice(16); }, 0.0, Stage::model}, pores)
      ->Unit(benchmark::kMillisecond);
  for (const Size &size : molecule_sizes()) {
    register_case("regions/" + size.name, {"regions/" + size.name, size.balls, 0.0, Stage::boundary}, regions)
        ->Unit(benchmark::kMicrosecond);
    const auto register_stage = [&](const std::string &stage, const char *counted, uint32_t (Pockets::*run)()) {
      const std::string name = stage + "/" + size.name;
      register_case(
          name, {name, size.balls, 0.0, Stage::model},
          [counted, run](benchmark::State &state, Subject &subject) { pockets(state, subject, counted, run); })
          ->Unit(benchmark::kMicrosecond);
    };
    register_stage("pockets", "pockets", &Pockets::find);
    register_stage("plugs", "plugs", &Pockets::list_plugs);
    register_stage("pocket_sizes", "closed", &Pockets::measure);
  }
}

}  // namespace bench
