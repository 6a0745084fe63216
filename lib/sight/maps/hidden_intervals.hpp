// Which parts of a curve are hidden, occluder by occluder, and the visible arcs that are left between them.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/sorting.hpp"
#include "lanes/floating_point.hpp"
#include "maps/scene_map.hpp"

namespace hsp {

// In the middle of an interval longer than this a curve that crosses at its ends is deeper behind than shallow_depth,
// or as far before; else it does not cross but coincide. Relative to the radius, or its square for squared depths.
inline constexpr double long_interval = 0x1p-10;
inline constexpr double shallow_depth = 0x1p-36;
// A crease that enters a ball as close as this to the height of its centre, relative to the radius, may miss both its
// sphere and the cylinder below.
inline constexpr double level_height = 0x1p-36;

// The end of an arc: nothing (plain), or the body that begins to hide the curve there. At the natural end of a crease,
// a tangency, there is no such body.
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

// Where a curve may begin or cease to be hidden, and how an arc ends if it does.
struct Breakpoint {
  double t;
  ArcEnd end;
};

inline void sort_breakpoints(Span<Breakpoint> at) {
  sort_in_place(at, [](const Breakpoint &a, const Breakpoint &b) { return a.t < b.t; });
}

// Calls hide(part) for each part of [from, to] that something hides, between breakpoints in ascending order. They only
// cut: what decides is depth(a, b), how deep the curve is behind in the middle between a and b. False if it is not
// clearly so anywhere: nearer to 0 than `shallow`.
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

// Of a silhouette, at most `half` from the angle `middle`.
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

// A parameter by which hidden parts may overlap that only touch.
inline constexpr double overlap_tolerance = 0x1p-24;

// Calls emit(from, what ends the arc there, to, what ends it there) for what the intervals leave of [from, to]. Returns
// false if roundings decide that they leave nothing somewhere: where one ends another one begins.
template <class Emit>
bool visit_visible(Span<HiddenInterval> hidden, double from, double to, const ArcEnd &natural, Emit emit) {
  sort_in_place(hidden, [](const HiddenInterval &a, const HiddenInterval &b) { return a.from < b.from; });
  double begin = from;
  ArcEnd begins = natural;
  bool certain = true;
  for (const HiddenInterval &interval : hidden) {
    if (interval.from > begin) emit(begin, begins, interval.from, interval.end[0]);
    if (interval.to > begin) {
      if (interval.from <= begin && interval.from > begin - overlap_tolerance &&
          interval.end[0].kind != MapVertexKind::plain) {
        certain = false;
      }
      begin = interval.to;
      begins = interval.end[1];
    }
  }
  if (begin < to) emit(begin, begins, to, natural);
  return certain;
}

// Pushes the visible arcs of a curve. On a closed curve, which begins and ends at the same point, the first and the
// last arc are one if both reach that point. Returns false as above.
inline bool push_visible(Span<HiddenInterval> hidden, double from, double to, const ArcEnd &natural, uint32_t body,
                         uint32_t nearer, FixedVector<MapArc> &arcs) {
  const bool closes = natural.kind == MapVertexKind::plain;
  const uint64_t first = arcs.required();
  MapArc waiting{};
  bool waits = false;
  MapArc opening{};
  bool opens = false;
  const bool certain =
      visit_visible(hidden, from, to, natural, [&](double begin, const ArcEnd &begins, double end, const ArcEnd &ends) {
        const MapArc arc{begin, end, body, nearer, {begins, ends}, false};
        const bool at_first = closes && begins.kind == MapVertexKind::plain;
        const bool at_last = closes && ends.kind == MapVertexKind::plain;
        if (at_first && at_last) {
          arcs.push({from, to, body, nearer, {{}, {}}, true});
        } else if (at_first) {
          opening = arc;
          opens = true;
          arcs.push(arc);  // its slot; the last arc may be put before it
        } else if (at_last) {
          waiting = arc;
          waits = true;
        } else {
          arcs.push(arc);
        }
      });
  if (opens && waits) {
    opening.from = waiting.from - 2 * pi;
    opening.end[0] = waiting.end[0];
    if (first < arcs.capacity()) arcs[static_cast<uint32_t>(first)] = opening;
  } else if (waits) {
    arcs.push(waiting);
  }
  return certain;
}

// No map of these arcs has more edges: besides the arcs themselves one for each of their ends that is a T. An arc that
// was not stored, or not found for want of room, counts as if both its ends were on contours.
inline uint32_t most_edges_of(const FixedVector<MapArc> &arcs, uint64_t not_found) {
  uint64_t edges = arcs.required() + 2 * (arcs.required() - arcs.size()) + 3 * not_found;
  for (const MapArc &arc : arcs.items()) {
    for (const ArcEnd &end : arc.end) edges += end.kind == MapVertexKind::t ? 1 : 0;
  }
  return clamped_count(edges);
}

}  // namespace hsp
