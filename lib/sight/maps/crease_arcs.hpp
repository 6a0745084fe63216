// The visible arcs of the crease of two balls.
#pragma once

#include "maps/hidden_intervals.hpp"

namespace hsp {

inline constexpr uint32_t most_hidden_per_occluder = 6;

// near: as DiscGrid::gather finds them for ball `far`, `nearer` among them. Uses `hidden` [6 near].
// False if the crease coincides with a front or silhouette, so that roundings decide what is seen.
bool find_crease_arcs(SeenBalls &seen, uint32_t far, uint32_t nearer, Span<const uint32_t> near,
                      FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs);

}  // namespace hsp
