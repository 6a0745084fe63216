#include "cells/power_polytope.hpp"

namespace hsp {

void PowerPolytope::carve(Workspace &workspace, uint32_t balls) {
  vertices_ = workspace.take<PolytopeVertex>(2 * most_vertices(balls));
  beyond_ = workspace.take<uint8_t>(2 * most_vertices(balls));
  holes_ = workspace.take<uint32_t>(2 * most_vertices(balls));
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
  uint32_t holes = 0;
  for (uint32_t v = 0; v < old; ++v) {
    holes_[holes] = v;
    holes += beyond_[v];
  }
  // New vertices take the places of those that go, as far as these suffice. The marks stay as they are meanwhile.
  uint32_t made = 0;
  PolytopeVertex *const vertices = vertices_.data();
  for (uint32_t v = 0; v < old; ++v) {
    if (beyond_[v] != 0) continue;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t w = vertices[v].neighbour[k];
      if (w >= old || beyond_[w] == 0) continue;
      const uint32_t place = made < holes ? holes_[made] : old + made - holes;
      ++made;
      PolytopeVertex &vertex = vertices_[place];
      const uint32_t a = vertices[v].plane[k == 0 ? 1 : 0];
      const uint32_t b = vertices[v].plane[k == 2 ? 1 : 2];
      vertex.plane[0] = a;
      vertex.plane[1] = b;
      vertex.plane[2] = plane;
      vertex.neighbour[2] = v;
      vertex.at = frame.common_point(planes[a], planes[b], planes[plane]);
      vertices[v].neighbour[k] = place;
      link(place, 0, a);
      link(place, 1, b);
    }
  }
  count_ = made > holes ? old + made - holes : old;
  // The last vertices take the places that are left, from the last one on.
  for (; holes > made; --holes) move(--count_, holes_[holes - 1]);
}

// Moves a vertex, unless it is there, and tells its neighbours.
void PowerPolytope::move(uint32_t from, uint32_t to) {
  if (from == to) return;
  vertices_[to] = vertices_[from];
  for (const uint32_t w : vertices_[to].neighbour) {
    for (uint32_t &back : vertices_[w].neighbour) {
      if (back == from) back = to;
    }
  }
}

}  // namespace hsp
