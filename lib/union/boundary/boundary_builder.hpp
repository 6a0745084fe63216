// Steps 1 and 2 of Section 4.2 over all balls, and what follows from them: loops, faces, shells, components. The work
// can be split among workers, each with a share of the cubes, in stages; the results do not depend on the split. All
// workers end a stage before one begins the next.
#pragma once

#include "boundary/boundary_worker.hpp"
#include "boundary/shells.hpp"
#include "core/executor.hpp"
#include "core/shared_disjoint_sets.hpp"

namespace hsp {

class BoundaryBuilder : public Limited<BoundaryLimits> {
 public:
  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // All of it; by all workers that the limits allow for, if the executor has more than one. Status::capacity if a limit
  // is too small, or allows for fewer than it has; needed() then reports what suffices. Status::executor if it fails,
  // Status::stopped if it says so.
  // selected: null, or in the caller's order whether a ball is not left out. Those left out only block: nothing of them
  // is there, nor are twins, shells and components.
  Status build(const CubeGrid &grid, const Executor &executor = {}, const uint8_t *selected = nullptr) {
    return build(grid, executor, selected, selected == nullptr, selected == nullptr);
  }
  // Of the balls of a grid with images alone, ball by ball as in the boundary of the whole; shells are left to the
  // caller. joins: whether joined_balls() are there.
  Status build_in_box(const CubeGrid &grid, const Executor &executor, bool joins) {
    return build(grid, executor, nullptr, joins, false);
  }
  // An image is inside others if its ball is.
  void take_state(uint32_t image, uint32_t ball) { arrays().ball_state[image] = arrays().ball_state[ball]; }
  // Balls and images, where each ball is joined to all that meet it. One inside others is joined to one of these, which
  // whatever meets it meets, too. Each has its representative as parent.
  Span<const uint32_t> joined_balls() {
    const Span<uint32_t> parent = arrays().component_origin.part(0, needed_.balls);
    DisjointSets(parent).flatten();
    return parent;
  }
  // Numbers the shells, from the faces that have been joined.
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
  Span<uint32_t> selected_;         // [balls] those that are not left out, in the grid's order
  const CubeGrid *grid_ = nullptr;  // while it is built
  uint32_t count_ = 0;              // of workers that build it
  bool joins_ = false;              // whether components are looked for
  bool whole_ = false;              // whether shells are, too
};

}  // namespace hsp
