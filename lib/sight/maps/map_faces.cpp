#include "maps/map_faces.hpp"

#include "maps/face_nesting.hpp"
#include "maps/sight_behind.hpp"

namespace hsp {

void MapFaceFinder::carve(Workspace &workspace, const MapLimits &limits) {
  const uint64_t edges = limits.edges;
  parent_ = workspace.take<uint32_t>(edges);
  first_face_ = workspace.take<uint32_t>(limits.balls);
  scratch_ = workspace.take<uint32_t>(2 * edges + 1);
}

// Areas are taken about the loop's first point, so that nothing large cancels.
bool MapFaceFinder::trace_loop(uint32_t first, VisibilityMap &map) {
  const uint32_t id = map.loops.size();
  MapLoop loop{first, no_id, no_id, no_id, 0.0};
  const MapVertex &origin = map.vertices[map.origin(first)];
  double twice = 0.0;
  uint32_t h = first;
  do {
    MapHalfEdge &half_edge = map.half_edges[h];
    if (half_edge.next == no_id || half_edge.loop != no_id) return false;
    half_edge.loop = id;
    const MapEdge &edge = map.edges[h / 2];
    const bool forward = h % 2 == 0;
    if (map.origin(half_edge.next) != edge.vertex[forward ? 1 : 0]) return false;
    const uint32_t owner = edge.is_silhouette() ? (forward ? edge.ball : no_id) : (forward ? edge.nearer : edge.ball);
    if (owner != no_id) {
      if (loop.owner != no_id && loop.owner != owner) return false;
      loop.owner = owner;
    }
    const double swept = swept_twice(map, h / 2, origin.x, origin.y);
    twice += forward ? swept : -swept;
    h = half_edge.next;
  } while (h != first);
  loop.area = 0.5 * twice;
  map.loops.push(loop);
  return true;
}

// Along a loop that sees only the far sides of silhouettes: what is highest behind the longest of its edges, at a point
// of it where that is certain.
bool MapFaceFinder::name_owner(const DiscGrid &grid, MapLoop &loop, const VisibilityMap &map) const {
  uint32_t best = loop.first_half_edge;
  double longest = -1.0;
  uint32_t h = loop.first_half_edge;
  do {
    const MapEdge &edge = map.edges[h / 2];
    const double length = (edge.to - edge.from) * map.balls[edge.ball].r;
    if (length > longest) {
      longest = length;
      best = h;
    }
    h = map.half_edges[h].next;
  } while (h != loop.first_half_edge);
  const SightBehind behind = sight_behind(map, map.edges[best / 2], grid);
  loop.owner = behind.body;
  return behind.certain;
}

bool MapFaceFinder::trace_loops(const DiscGrid &grid, VisibilityMap &map) {
  for (uint32_t h = 0; h < map.half_edges.size(); ++h) {
    if (map.half_edges[h].loop != no_id) continue;
    if (!trace_loop(h, map)) return false;
    MapLoop &loop = map.loops[map.loops.size() - 1];
    if (loop.owner == no_id && !name_owner(grid, loop, map)) return false;
  }
  return true;
}

void MapFaceFinder::count_components(VisibilityMap &map) {
  DisjointSets parts(parent_.part(0, map.vertices.size()));
  parts.reset();
  map.components = map.vertices.size();
  for (const MapEdge &edge : map.edges.items()) {
    if (parts.join(edge.vertex[0], edge.vertex[1])) --map.components;
  }
}

// Counts the outer loops of each owner, then gives them the numbers of faces from the last loop to the first, so that
// first_face_ ends where each owner begins.
void MapFaceFinder::add_outer_loops(VisibilityMap &map) {
  for (uint32_t &first : first_face_) first = no_id;
  map.first_face = first_face_;
  uint32_t background = 1;
  for (const MapLoop &loop : map.loops.items()) {
    if (loop.area <= 0.0) continue;
    if (loop.owner == no_id) {
      ++background;
    } else {
      uint32_t &count = first_face_[map.balls[loop.owner].ball];
      count = count == no_id ? 1 : count + 1;
    }
  }
  uint32_t faces = background;
  for (const SeenBall &ball : map.balls) {
    uint32_t &count = first_face_[ball.ball];
    if (count == no_id) continue;
    ++map.owners;
    faces += count;
    count = faces;
  }
  map.faces.set_count(faces);
  map.faces[0] = {no_id, no_id, 0.0};
  for (uint32_t l = map.loops.size(); l-- > 0;) {
    MapLoop &loop = map.loops[l];
    if (loop.area <= 0.0) continue;
    loop.face = --(loop.owner == no_id ? background : first_face_[map.balls[loop.owner].ball]);
    map.faces[loop.face] = {loop.owner, l, loop.area};
  }
}

// Curves that coincide may all be lost.
bool MapFaceFinder::tops_have_faces(const DiscGrid &grid, const VisibilityMap &map) const {
  for (uint32_t k = 0; k < map.balls.size(); ++k) {
    const SeenBall &ball = map.balls[k];
    if (ball.inside != 0 || first_face_[ball.ball] != no_id) continue;
    const DiscGrid::Highest top = grid.highest_at(ball.x, ball.y, no_id);
    if (top.body == k && top.certain) return false;
  }
  return true;
}

bool MapFaceFinder::find(const DiscGrid &grid, bool complete, VisibilityMap &map) {
  if (!trace_loops(grid, map) || !fits_beside_short_edges(map, grid)) return false;
  if (!complete && !fits_behind_contours(map, grid)) return false;
  count_components(map);
  const uint64_t sum = static_cast<uint64_t>(map.vertices.size()) + map.loops.size();
  if (sum != static_cast<uint64_t>(map.edges.size()) + 2 * static_cast<uint64_t>(map.components)) return false;
  add_outer_loops(map);
  return add_holes(map) && tops_have_faces(grid, map);
}

}  // namespace hsp
