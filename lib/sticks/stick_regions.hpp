// What is seen of balls and sticks that have no drawing order, or balls of which meet: for each body the loops around
// what is seen of it. Edges and half-edges are those of a visibility map, with the curves of stick_scene.hpp.
#pragma once

#include "sticks/stick_scene.hpp"
#include "visibility/visibility_map.hpp"

namespace hsp {

struct RegionVertex {
  double x, y;
};

struct RegionLoop {
  uint32_t first_half_edge;
  uint32_t owner;  // the body that is seen on the left, no_id for the background
  double area;     // negative around holes
};

struct StickRegions {
  bool exist = false;
  double perturbation = 0.0;  // no centre was moved farther, in lattice steps
  ViewFrame frame;
  StickScene scene;
  uint32_t paths = 0;
  FixedVector<RegionVertex> vertices;  // [edges]
  FixedVector<MapEdge> edges;
  FixedVector<uint32_t> next;     // [2 edges] the half-edge that follows around the region on the left
  FixedVector<RegionLoop> loops;  // [2 edges] those of a body follow each other; background last
  Span<uint32_t> first_loop;      // [paths] of each body that is seen, farthest first

  // The body that a path is of.
  uint32_t owner_of(uint32_t path) const { return loops[first_loop[path]].owner; }
  uint32_t origin(uint32_t half_edge) const { return edges[half_edge / 2].vertex[half_edge % 2]; }
  // The body on the left, no_id where that is known from other edges only.
  uint32_t left_of(uint32_t half_edge) const {
    const MapEdge &edge = edges[half_edge / 2];
    if (edge.is_silhouette()) return half_edge % 2 == 0 ? edge.ball : no_id;
    return half_edge % 2 == 0 ? edge.nearer : edge.ball;
  }
  void carve(Workspace &workspace, const StickLimits &limits) {
    const uint64_t most = limits.edges;
    vertices = FixedVector<RegionVertex>(workspace.take<RegionVertex>(most));
    edges = FixedVector<MapEdge>(workspace.take<MapEdge>(most));
    next = FixedVector<uint32_t>(workspace.take<uint32_t>(2 * most));
    loops = FixedVector<RegionLoop>(workspace.take<RegionLoop>(2 * most));
    first_loop = workspace.take<uint32_t>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks));
  }
  void clear() {
    exist = false;
    perturbation = 0.0;
    paths = 0;
    vertices.clear();
    edges.clear();
    next.clear();
    loops.clear();
  }
};

}  // namespace hsp
