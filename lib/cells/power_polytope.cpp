#include "cells/power_polytope.hpp"

namespace hsp {

void PowerPolytope::carve(Workspace &workspace, uint32_t balls) {
  vertices_ = workspace.take<PolytopeVertex>(2 * most_vertices(balls));
  beyond_ = workspace.take<uint8_t>(2 * most_vertices(balls));
  place_ = workspace.take<uint32_t>(2 * most_vertices(balls));
  open_ = workspace.take<uint32_t>(most_planes(balls));
  for (uint32_t &end : open_) end = no_id;
  count_ = 0;
}

void PowerPolytope::start(double side) {
  count_ = 8;
  for (uint32_t v = 0; v < 8; ++v) {
    PolytopeVertex &vertex = vertices_[v];
    const auto along = [&](uint32_t axis) { return (v >> axis & 1) != 0 ? side : -side; };
    vertex.at = {{along(0), along(1), along(2)}, 0.0};
    for (uint32_t axis = 0; axis < 3; ++axis) {
      vertex.plane[axis] = 2 * axis + (v >> axis & 1);
      vertex.neighbour[axis] = v ^ 1U << axis;
    }
  }
}

// The edge on the new plane and on plane[k] of a new vertex: the second of its two ends finds the first one.
void PowerPolytope::link(uint32_t vertex, uint32_t k, uint32_t plane) {
  uint32_t &open = open_[plane];
  if (open == no_id) {
    open = 2 * vertex + k;
    return;
  }
  const uint32_t other = open / 2;
  // Opposite to plane[k] of the first two planes is the edge on the other one of them.
  vertices_[vertex].neighbour[1 - k] = other;
  vertices_[other].neighbour[1 - open % 2] = vertex;
  open = no_id;
}

void PowerPolytope::cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame) {
  const uint32_t old = count_;
  uint32_t end = old;
  for (uint32_t v = 0; v < old; ++v) {
    if (beyond_[v] != 0) continue;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t w = vertices_[v].neighbour[k];
      if (beyond_[w] == 0) continue;
      PolytopeVertex &vertex = vertices_[end];
      const uint32_t a = vertices_[v].plane[k == 0 ? 1 : 0];
      const uint32_t b = vertices_[v].plane[k == 2 ? 1 : 2];
      vertex.plane[0] = a;
      vertex.plane[1] = b;
      vertex.plane[2] = plane;
      vertex.neighbour[2] = v;
      vertex.at = frame.common_point(planes[a], planes[b], planes[plane]);
      vertices_[v].neighbour[k] = end;
      beyond_[end] = 0;
      link(end, 0, a);
      link(end, 1, b);
      ++end;
    }
  }
  count_ = 0;
  for (uint32_t v = 0; v < end; ++v) {
    if (beyond_[v] != 0) continue;
    place_[v] = count_;
    vertices_[count_] = vertices_[v];
    ++count_;
  }
  for (uint32_t v = 0; v < count_; ++v) {
    for (uint32_t &neighbour : vertices_[v].neighbour) neighbour = place_[neighbour];
  }
}

}  // namespace hsp
