// Which parts of a curve are hidden, occluder by occluder, and the visible arcs between the hidden parts.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/sorting.hpp"
#include "lanes/floating_point.hpp"
#include "maps/scene_map.hpp"

namespace hsp {

// A curve that crosses a surface at both ends of an interval longer than long_interval is in its middle deeper behind
// the surface than shallow_depth, or as far before it. Else the curve coincides with the surface. Depths are relative
// to the radius, squared depths to its square.
inline constexpr double long_interval = 0x1p-10;
inline constexpr double shallow_depth = 0x1p-36;
// If a crease enters a ball as close as this to the height of the ball's centre, relative to the radius, rounding may
// let it miss both the sphere and the cylinder below the silhouette.
inline constexpr double level_height = 0x1p-36;

// The label of an arc's end. Plain: nothing happens there. Else `body` begins to hide the curve there; it is no_id at
// the natural end of a crease, a tangency.
struct ArcEnd {
  MapVertexKind kind = MapVertexKind::plain;
  uint32_t body = no_id;
};

// A visible part of a silhouette or crease, named as in MapEdge.
struct MapArc {
  double from, to;
  uint32_t body;
  uint32_t nearer;
  ArcEnd end[2];
  bool closed;  // the whole curve, without ends
};

struct HiddenInterval {
  double from, to;
  ArcEnd end[2];
};

// A parameter at which a curve may begin or cease to be hidden, and the label of the arc that ends there if it does.
struct Breakpoint {
  double t;
  ArcEnd end;
};

inline void sort_breakpoints(Span<Breakpoint> at) {
  sort_in_place(at, [](const Breakpoint &a, const Breakpoint &b) { return a.t < b.t; });
}

// Calls hide(part) for each part of [from, to] that an occluder hides. at: the breakpoints, ascending. They only cut
// [from, to] into intervals. Whether the interval from a to b is hidden is decided by depth(a, b): how deep the curve
// is behind the occluder in the middle of it, negative if it is not behind. Returns false if a depth is nearer to 0
// than `shallow` in a long interval, so that rounding decides.
template <class Depth, class Hide>
bool visit_hidden(Span<const Breakpoint> at, double from, double to, double shallow, Depth depth, Hide hide) {
  bool certain = true, hides = false;
  double since = from;
  ArcEnd begins;
  for (uint32_t k = 0; k <= at.size(); ++k) {
    const double begin = k == 0 ? from : at[k - 1].t;
    const double end = k == at.size() ? to : at[k].t;
    const double behind = depth(begin, end);
    if (end - begin > long_interval && std::fabs(behind) < shallow) certain = false;
    if ((behind > 0.0) == hides) continue;
    if (hides) {
      hide(HiddenInterval{since, begin, {begins, at[k - 1].end}});
    } else {
      since = begin;
      begins = k == 0 ? ArcEnd{} : at[k - 1].end;
    }
    hides = !hides;
  }
  if (hides) hide(HiddenInterval{since, to, {begins, {}}});
  return certain;
}

// Hides the part of a silhouette between the angles middle - half and middle + half. end: the label at its ends.
inline void hide_angles(FixedVector<HiddenInterval> &hidden, double middle, double half, const ArcEnd &end) {
  const double from = middle - half;
  const double to = middle + half;
  if (from < -pi) {
    hidden.push({from + 2 * pi, pi, {end, {}}});
    hidden.push({-pi, to, {{}, end}});
  } else if (to > pi) {
    hidden.push({from, pi, {end, {}}});
    hidden.push({-pi, to - 2 * pi, {{}, end}});
  } else {
    hidden.push({from, to, {end, end}});
  }
}

// Hidden parts that only touch may overlap by that much of the parameter, by rounding.
inline constexpr double overlap_tolerance = 0x1p-24;

// Pushes the visible arcs that the hidden intervals leave of a curve. natural: the label of the ends of the curve. A
// closed curve begins and ends at the same point: if the first and the last arc both reach that point, they are one
// arc. Returns false if one interval ends where another one begins, so that rounding decides that nothing is visible
// between them.
inline bool push_visible(Span<HiddenInterval> hidden, double from, double to, const ArcEnd &natural, uint32_t body,
                         uint32_t nearer, FixedVector<MapArc> &arcs) {
  const bool closes = natural.kind == MapVertexKind::plain;
  const uint64_t first = arcs.required();
  MapArc waiting{};
  bool waits = false;
  MapArc opening{};
  bool opens = false;
  double begin = from;
  ArcEnd begins = natural;
  const auto push = [&](double end, const ArcEnd &ends) {
    const MapArc arc{begin, end, body, nearer, {begins, ends}, false};
    const bool at_first = closes && begins.kind == MapVertexKind::plain;
    const bool at_last = closes && ends.kind == MapVertexKind::plain;
    if (at_first && at_last) {
      arcs.push({from, to, body, nearer, {{}, {}}, true});
    } else if (at_first) {
      opening = arc;
      opens = true;
      arcs.push(arc);  // takes its slot; is replaced if the last arc is joined to it
    } else if (at_last) {
      waiting = arc;
      waits = true;
    } else {
      arcs.push(arc);
    }
  };
  bool certain = true;
  sort_in_place(hidden, [](const HiddenInterval &a, const HiddenInterval &b) { return a.from < b.from; });
  for (const HiddenInterval &interval : hidden) {
    if (interval.from > begin) push(interval.from, interval.end[0]);
    if (!(interval.to > begin)) continue;
    if (interval.from <= begin && interval.from > begin - overlap_tolerance &&
        interval.end[0].kind != MapVertexKind::plain) {
      certain = false;
    }
    begin = interval.to;
    begins = interval.end[1];
  }
  if (begin < to) push(to, natural);
  if (opens && waits) {
    opening.from = waiting.from - 2 * pi;
    opening.end[0] = waiting.end[0];
    if (first < arcs.capacity()) arcs[static_cast<uint32_t>(first)] = opening;
  } else if (waits) {
    arcs.push(waiting);
  }
  return certain;
}

// An upper bound of the number of edges of a map of these arcs: one for each arc, and one for each end that is a T. An
// arc that was not stored, or not found for lack of room, counts as if both its ends were T vertices.
inline uint32_t most_edges_of(const FixedVector<MapArc> &arcs, uint64_t not_found) {
  uint64_t edges = arcs.required() + 2 * (arcs.required() - arcs.size()) + 3 * not_found;
  for (const MapArc &arc : arcs.items()) {
    for (const ArcEnd &end : arc.end) edges += end.kind == MapVertexKind::t ? 1 : 0;
  }
  return clamped_count(edges);
}

}  // namespace hsp
