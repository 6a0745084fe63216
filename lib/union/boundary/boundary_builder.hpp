// Steps 1 and 2 of Section 4.2 over all balls, and what follows from them: loops, faces, shells, components. The work
// is done in stages and can be split among workers, each with a share of the cubes. All workers end a stage before one
// of them begins the next. The results do not depend on the split.
#pragma once

#include "boundary/boundary_worker.hpp"
#include "boundary/components.hpp"
#include "core/executor.hpp"
#include "core/shared_disjoint_sets.hpp"

namespace hsp {

class BoundaryBuilder : public Limited<BoundaryLimits> {
 public:
  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // Builds all of it; if the executor has more than one worker, with as many as the limits allow for. Status::capacity
  // if a limit is too small or the executor has more workers than the limits allow for; needed() then reports what
  // suffices. Status::executor if the executor fails, Status::stopped if it stops the work.
  // selected: null, or for each ball in the caller's order 0 if it is left out. A ball that is left out covers parts of
  // others, but its own part of the boundary is missing, and there are no twins, shells and components.
  Status build(const CubeGrid &grid, const Executor &executor = {}, const uint8_t *selected = nullptr) {
    return build(grid, executor, selected, selected == nullptr, selected == nullptr);
  }
  // Builds the boundary of the own balls of a grid with images, ball by ball as in the boundary of the whole. Shells
  // are left to the caller. joins: whether balls are joined for joined_balls().
  Status build_in_box(const CubeGrid &grid, const Executor &executor, bool joins) {
    return build(grid, executor, nullptr, joins, false);
  }
  // Gives an image the state of its ball: it is contained if its ball is.
  void take_state(uint32_t image, uint32_t ball) { arrays().ball_state[image] = arrays().ball_state[ball]; }
  // Disjoint sets of balls and images, as parents: the parent of each is the representative of its set. Each ball is
  // joined to all that meet it. A contained ball is joined to one that contains it, as all that meet the one meet the
  // other, too.
  Span<const uint32_t> joined_balls() {
    const Span<uint32_t> parent = arrays().component_origin.part(0, needed_.balls);
    DisjointSets(parent).flatten();
    return parent;
  }
  // Numbers the shells. shells: the faces, joined by the caller.
  void take_shells(DisjointSets shells) { number_shells(shells, arrays()); }

  const Boundary &boundary() const { return boundary_; }

  // The arrays behind the boundary, for tests that break them.
  BoundaryArrays &arrays() { return boundary_.a_; }
  // Scratch memory for checks; [loops + balls].
  Span<uint32_t> scratch() { return scratch_; }

  // For tests: the kernels of another target, and the search without lanes or with less of its stages.
  LaneSearch &lanes() { return workers_[0].lanes; }
  void use(Target target, bool use_lanes) {
    arrays().target = target;
    for (BoundaryWorker &worker : workers_) {
      worker.lanes.use(target, use_lanes);
      worker.caps.lanes = use_lanes;
      worker.caps.target = target;
    }
  }

 private:
  Status build(const CubeGrid &grid, const Executor &executor, const uint8_t *selected, bool joins, bool whole);
  Span<BoundaryWorker> at_work() const { return workers_.part(0, count_); }
  // The totals of all workers.
  struct Found {
    uint32_t neighbours = 0;
    uint64_t vertices = 0, circles = 0;
  };
  Found found() const;
  void assemble(uint32_t stage, uint32_t worker);
  void place(uint32_t worker);
  void join_components();
  void leave_out_components();
  void distribute(uint32_t worker);
  void link(uint32_t worker);
  void close_gaps(uint32_t worker);
  // Whether all workers join faces to shells; else one of them does.
  bool shares_shells() const { return count_ > 1 && SharedDisjointSets::available; }

  Boundary boundary_;
  Span<BoundaryWorker> workers_;
  Span<uint32_t> scratch_;          // [loops + balls]
  Span<uint32_t> selected_;         // [balls] in grid order: 0 if the ball is left out
  const CubeGrid *grid_ = nullptr;  // the grid while the boundary is built
  uint32_t count_ = 0;              // number of workers that build it
  bool joins_ = false;              // whether balls that meet are joined
  bool whole_ = false;              // whether there are shells and components
};

}  // namespace hsp
