#include "maps/region_loops.hpp"

#include "core/sorting.hpp"
#include "maps/sight_behind.hpp"

namespace hsp {
namespace {

bool is_behind_contour(const StickRegions &regions, uint32_t half_edge) {
  return half_edge % 2 == 1 && regions.edges[half_edge / 2].is_silhouette();
}

}  // namespace

void RegionLoops::carve(Workspace &workspace, const StickLimits &limits) {
  const uint64_t edges = limits.edges;
  traced_ = workspace.take<uint8_t>(2 * edges);
  seen_ = workspace.take<uint8_t>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks));
  parent_ = workspace.take<uint32_t>(edges);
}

// Areas are taken about the loop's first point, so that nothing large cancels.
bool RegionLoops::trace(uint32_t first, StickRegions &regions) {
  MapLoop loop{first, no_id, no_id, no_id, 0.0};
  const MapVertex origin = regions.vertices[regions.origin(first)];
  double twice = 0.0;
  uint32_t h = first;
  do {
    const uint32_t next = regions.half_edges[h].next;
    if (next == no_id || traced_[h] != 0 || regions.origin(next) != regions.origin(h ^ 1U)) return false;
    traced_[h] = 1;
    const uint32_t owner = regions.left_of(h);
    if (owner != no_id) {
      if (loop.owner != no_id && loop.owner != owner) return false;
      loop.owner = owner;
    }
    const double swept = swept_twice(regions, h / 2, origin.x, origin.y);
    twice += h % 2 == 0 ? swept : -swept;
    h = next;
  } while (h != first);
  loop.area = 0.5 * twice;
  regions.loops.push(loop);
  return true;
}

// By what is highest behind the longest edge on a contour, at a point of it where that is certain.
bool RegionLoops::name_owner(const BodySight &sight, const StickRegions &regions, MapLoop &loop) const {
  uint32_t best = no_id;
  double longest = -1.0;
  uint32_t h = loop.first_half_edge;
  do {
    if (is_behind_contour(regions, h)) {
      const MapEdge &edge = regions.edges[h / 2];
      const bool of_ball = regions.scene.is_ball(edge.ball);
      const double length = (edge.to - edge.from) *
                            (of_ball ? regions.scene.balls[edge.ball].r : regions.scene.stick_at(edge.ball).length);
      if (length > longest) {
        longest = length;
        best = h;
      }
    }
    h = regions.half_edges[h].next;
  } while (h != loop.first_half_edge);
  if (best == no_id) return true;
  const SightBehind behind = sight_behind(regions, regions.edges[best / 2], sight);
  if (!behind.certain) return loop.owner != no_id;
  if (loop.owner != no_id && loop.owner != behind.body) return false;
  loop.owner = behind.body;
  return true;
}

bool RegionLoops::fits_euler(StickRegions &regions) {
  const uint32_t vertices = regions.vertices.size();
  DisjointSets parts(parent_.part(0, vertices));
  parts.reset();
  regions.components = vertices;
  for (const MapEdge &edge : regions.edges.items()) {
    if (parts.join(edge.vertex[0], edge.vertex[1])) --regions.components;
  }
  return static_cast<uint64_t>(vertices) + regions.loops.size() ==
         regions.edges.size() + 2 * static_cast<uint64_t>(regions.components);
}

// Curves that coincide may all be lost.
bool RegionLoops::middles_have_loops(const BodySight &sight, const StickRegions &regions) {
  const StickScene &scene = regions.scene;
  const auto is_lost = [&](uint32_t body, double x, double y) {
    if (seen_[body] != 0) return false;
    const BodySight::Highest highest = sight.highest_at(x, y, no_id);
    return highest.certain && highest.body == body;
  };
  for (uint32_t i = 0; i < scene.balls.size(); ++i) {
    if (is_lost(i, scene.balls[i].x, scene.balls[i].y)) return false;
  }
  for (uint32_t k = 0; k < scene.sticks.size(); ++k) {
    const Stick &stick = scene.sticks[k];
    for (uint32_t part = 0; part < stick.parts; ++part) {
      const Vec3 middle = stick.on_axis(0.5 * (stick.begin_of(part) + stick.end_of(part)));
      const double back = stick.radius * stick.axis.z;
      if (is_lost(scene.body_of(k, part), middle.x - back * stick.e[0], middle.y - back * stick.e[1])) return false;
    }
  }
  return true;
}

void RegionLoops::number_loops(StickRegions &regions) {
  for (uint32_t l = 0; l < regions.loops.size(); ++l) {
    uint32_t h = regions.loops[l].first_half_edge;
    do {
      regions.half_edges[h].loop = l;
      h = regions.half_edges[h].next;
    } while (h != regions.loops[l].first_half_edge);
  }
}

bool RegionLoops::find(const BodySight &sight, Span<const double> depth, StickRegions &regions) {
  regions.loops.clear();
  const uint32_t half_edges = regions.half_edges.size();
  for (uint32_t h = 0; h < half_edges; ++h) traced_[h] = 0;
  for (uint32_t h = 0; h < half_edges; ++h) {
    if (traced_[h] == 0 && !trace(h, regions)) return false;
  }
  for (uint8_t &seen : seen_) seen = 0;
  for (MapLoop &loop : regions.loops.items()) {
    if (!name_owner(sight, regions, loop)) return false;
    if (loop.owner != no_id) seen_[loop.owner] = 1;
  }
  if (!fits_euler(regions) || !middles_have_loops(sight, regions)) return false;
  sort_in_place(regions.loops.items(), [depth](const MapLoop &a, const MapLoop &b) {
    if (a.owner != b.owner) {
      if (a.owner == no_id || b.owner == no_id) return b.owner == no_id;
      return depth[a.owner] != depth[b.owner] ? depth[a.owner] < depth[b.owner] : a.owner < b.owner;
    }
    return a.first_half_edge < b.first_half_edge;
  });
  number_loops(regions);
  if (!fits_beside_short_edges(regions, sight) || !fits_behind_contours(regions, sight)) return false;
  double area = 0.0;
  for (uint32_t l = 0; l < regions.loops.size(); ++l) {
    const MapLoop &loop = regions.loops[l];
    area += loop.area;
    const bool last = l + 1 == regions.loops.size() || regions.loops[l + 1].owner != loop.owner;
    if (!last) continue;
    if (loop.owner != no_id && !(area > 0.0)) return false;
    area = 0.0;
  }
  return find_faces(regions);
}

}  // namespace hsp
