#include "pockets/gate_finder.hpp"

namespace hsp {

void GateFinder::carve(Workspace &workspace, const ProbeLimits &limits) {
  probes_.carve(workspace, limits);
  PoreLimits of_pores;
  static_cast<void>(default_limits(limits.balls, of_pores));
  pores_ = workspace.take<PoresBuilder>(1);
  PoresBuilder measured;
  (pores_.size() > 0 ? pores_[0] : measured).carve(workspace, of_pores);
}

// Negative without one.
double GateFinder::guess(const CubeGrid &grid, const exact::Vector &from, const exact::Vector *to) {
  PorePassage passage{};
  const bool found = pores_[0].build(grid, 0) == Status::ok &&
                     find_passage(pores_[0], grid, from, to, 0, passage) == Status::ok && passage.passes;
  return found ? passage.level : -1.0;
}

Status GateFinder::find(const CubeGrid &grid, const exact::Vector &from, const exact::Vector *to, WidestProbe &widest) {
  bool open = false;
  const Status status = probes_.begin(grid.balls(), from, to, widest, open);
  if (status != Status::ok || !open) return status;
  return probes_.narrow(grid.balls(), guess(grid, from, to), widest);
}

}  // namespace hsp
