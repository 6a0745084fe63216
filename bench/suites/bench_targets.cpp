// Steps 1 and 2 by the kernels for the widest registers that the processor has, by turns with the kernels for every
// processor: how much time the instructions that counted/ counts take, which differs from processor to processor.
#include <stdexcept>
#include <vector>

#include "alternation.hpp"
#include "boundary/boundary_builder.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

template <class Carved, class Limits>
void carve(std::vector<unsigned char> &memory, Carved &carved, const Limits &limits) {
  hsp::Workspace measured;
  carved.carve(measured, limits);
  memory.resize(measured.bytes());
  hsp::Workspace workspace(memory.data(), memory.size());
  carved.carve(workspace, limits);
}

void boundary(benchmark::State &state, Subject &subject) {
  const uint32_t n = subject.balls.size();
  std::vector<unsigned char> grid_memory, memory;
  hsp::CubeGrid grid;
  carve(grid_memory, grid, n);
  uint32_t first_bad = 0;
  const hsp::BallInput input{n, subject.balls.xyz.data(), subject.balls.radius.data(), subject.model->probe()};
  if (grid.build(input, first_bad) != hsp::Status::ok) throw std::runtime_error("no grid");
  hsp::BoundaryBuilder builder;
  carve(memory, builder, hsp::BoundaryLimits{n, 1, 1, 1});
  while (builder.build(grid) == hsp::Status::capacity) {
    const hsp::BoundaryLimits needed = builder.needed();
    carve(memory, builder, needed);
  }
  const auto by = [&](hsp::Target target) {
    return [&builder, &grid, target] {
      builder.use(target, true);
      if (builder.build(grid) != hsp::Status::ok) throw std::runtime_error("no boundary");
    };
  };
  alternate(state, n, {{"baseline", by(hsp::Target::baseline)}, {"widest", by(hsp::best_target())}});
}

}  // namespace

void register_suite() {
  if (hsp::best_target() == hsp::Target::baseline) return register_skipped("targets", "there is one alone");
  for (const Surface &surface : surfaces) {
    for (const Size &size : molecule_sizes()) {
      const std::string name = std::string("targets/") + surface.name + '/' + size.name;
      register_case(name, {name, size.balls, surface.probe}, boundary)->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench
