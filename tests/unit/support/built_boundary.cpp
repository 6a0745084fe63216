#include "built_boundary.hpp"

#include "lattice_lengths.hpp"

BuiltBoundary::BuiltBoundary(const oracle::Balls &balls)
    : built_(oracle::in_lengths(balls, 1)), status_(built_.status()) {
  if (status_ != hsp::Status::ok) return;
  const uint32_t n = static_cast<uint32_t>(balls.size());
  memory_.carve(builder_, hsp::BoundaryLimits{n, n, 8 * n * n, n * n});
  status_ = builder_.build(grid());
}
