#include "built_boundary.hpp"

#include "lattice_lengths.hpp"

BuiltBoundary::BuiltBoundary(const oracle::Balls &balls, bool with_levels)
    : built_(oracle::in_lengths(balls, 1)), status_(built_.status()) {
  if (status_ != hsp::Status::ok) return;
  if (!with_levels) built_.grid().use_no_levels();
  const uint32_t n = static_cast<uint32_t>(balls.size());
  const uint32_t pairs = n < 100 ? n * n : 100 * n;  // of many balls not all meet
  memory_.carve(builder_, hsp::BoundaryLimits{n, n, 8 * pairs, pairs});
  status_ = builder_.build(grid());
}
