// The visible arcs of one ball's silhouette.
#pragma once

#include "maps/hidden_intervals.hpp"

namespace hsp {

// near: as DiscGrid::gather finds them. Uses `hidden` [2 near]. False if where one ball ceases to hide it another one
// begins to, so that roundings decide whether something is seen between them.
bool find_silhouette_arcs(SeenBalls &seen, uint32_t ball, Span<const uint32_t> near,
                          FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs);

}  // namespace hsp
