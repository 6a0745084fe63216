#include "cells/power_polytope.hpp"

#include <initializer_list>

namespace hsp {

void PowerPolytope::carve(Workspace &workspace, uint32_t balls) {
  vertices_ = workspace.take<PolytopeVertex>(2 * most_vertices(balls));
  for (Span<double> *numbers : {&x_, &y_, &z_, &value_}) {
    *numbers = workspace.take<double>(2 * most_vertices(balls));
    for (double &number : *numbers) number = 0.0;  // two are read at once, and one may not be that of a vertex
  }
  beyond_ = workspace.take<uint8_t>(2 * most_vertices(balls));
  holes_ = workspace.take<uint32_t>(2 * most_vertices(balls));
  open_ = workspace.take<uint32_t>(most_planes(balls));
  for (uint32_t &end : open_) end = no_id;
  count_ = 0;
}

void PowerPolytope::start(double side, const Vec3 &centre) {
  count_ = 8;
  centre_ = centre;
  most_doubt_ = 0.0;
  for (uint32_t v = 0; v < 8; ++v) {
    PolytopeVertex &vertex = vertices_[v];
    const auto along = [&](uint32_t axis) { return (v >> axis & 1) != 0 ? side : -side; };
    vertex.at = {{along(0), along(1), along(2)}, 0.0};
    for (uint32_t axis = 0; axis < 3; ++axis) {
      vertex.plane[axis] = 2 * axis + (v >> axis & 1);
      vertex.neighbour[axis] = v ^ 1U << axis;
    }
    vertex.squared = dot(vertex.at.y - centre, vertex.at.y - centre);
    x_[v] = vertex.at.y.x;
    y_[v] = vertex.at.y.y;
    z_[v] = vertex.at.y.z;
  }
}

// The values of v.y - h. Returns whether any is larger than a threshold.
bool PowerPolytope::find_values(const UnitPlane &S, double threshold) {
  const uint32_t count = count_;
  const double *const x = x_.data(), *const y = y_.data(), *const z = z_.data();
  double *const values = value_.data();
  const Lanes a = all_lanes(S.v.x), b = all_lanes(S.v.y), c = all_lanes(S.v.z), h = all_lanes(S.h);
  const Lanes least = all_lanes(threshold);
  LaneMask larger{};
  for (uint32_t v = 0; v < count; v += lane_count) {
    const Lanes value = a * load_lanes(x + v) + b * load_lanes(y + v) + c * load_lanes(z + v) - h;
    larger |= value > least;
    std::memcpy(values + v, &value, sizeof value);
  }
  return any(larger);
}

double PowerPolytope::reach() const {
  const uint32_t count = count_;
  const PolytopeVertex *const vertices = vertices_.data();
  double most = 0.0;
  for (uint32_t v = 0; v < count; ++v) most = vertices[v].squared > most ? vertices[v].squared : most;
  return std::sqrt(most) + most_doubt_;
}

void PowerPolytope::cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame) {
  const uint32_t old = count_, hole_count = hole_count_;
  const UnitPlane S = planes[plane];
  const EdgeCrossing crossing(frame);
  const Vec3 centre = centre_;
  PolytopeVertex *const vertices = vertices_.data();
  double *const x = x_.data(), *const y = y_.data(), *const z = z_.data();
  const double *const values = value_.data();
  const uint8_t *const marks = beyond_.data();
  const uint32_t *const holes = holes_.data();
  uint32_t *const open = open_.data();
  // The edge on the new plane and on plane[k] of a new vertex: the second of its two ends finds the first one.
  const auto link = [&](uint32_t vertex, uint32_t k, uint32_t other_plane) __attribute__((always_inline)) {
    const uint32_t first = open[other_plane];
    open[other_plane] = first == no_id ? 2 * vertex + k : no_id;
    if (first == no_id) return;
    // Opposite to plane[k] of the first two planes is the edge on the other one of them.
    vertices[vertex].neighbour[1 - k] = first / 2;
    vertices[first / 2].neighbour[1 - first % 2] = vertex;
  };
  // New vertices take the places of those that are cut off, once it is known what these were joined to, and then places
  // behind the last one. The marks stay as they are meanwhile.
  uint32_t filled = 0, end = old;
  double most_doubt = most_doubt_;
  for (uint32_t hole = 0; hole < hole_count; ++hole) {
    const uint32_t w = holes[hole];
    const PolytopeVertex gone = vertices[w];
    const double value = values[w];
    // The edge to vertex v, on planes a and b.
    const auto cross = [&](uint32_t v, uint32_t a, uint32_t b) __attribute__((always_inline)) {
      if (marks[v] != 0) return;
      const uint32_t to = filled <= hole ? holes[filled++] : end++;
      PolytopeVertex &left = vertices[v], &made = vertices[to];
      left.neighbour[left.neighbour[0] == w ? 0 : left.neighbour[1] == w ? 1 : 2] = to;
      PlacedPoint at;
      if (!crossing.find(left.at, values[v], gone.at, value, at)) {
        at = frame.common_point(planes[a], planes[b], S);
      }
      const Vec3 from_centre = at.y - centre;
      made.at = at;
      made.squared = dot(from_centre, from_centre);
      made.plane[0] = a;
      made.plane[1] = b;
      made.plane[2] = plane;
      made.neighbour[2] = v;
      x[to] = at.y.x;
      y[to] = at.y.y;
      z[to] = at.y.z;
      most_doubt = at.doubt > most_doubt ? at.doubt : most_doubt;
      link(to, 0, a);
      link(to, 1, b);
    };
    cross(gone.neighbour[0], gone.plane[1], gone.plane[2]);
    cross(gone.neighbour[1], gone.plane[0], gone.plane[2]);
    cross(gone.neighbour[2], gone.plane[0], gone.plane[1]);
  }
  count_ = end;
  most_doubt_ = most_doubt;
  // The last vertices take the places that are left, from the last one on.
  for (uint32_t hole = hole_count; hole > filled; --hole) move(--count_, holes[hole - 1]);
}

// Moves a vertex, unless it is there, and tells its neighbours.
void PowerPolytope::move(uint32_t from, uint32_t to) {
  if (from == to) return;
  vertices_[to] = vertices_[from];
  x_[to] = x_[from];
  y_[to] = y_[from];
  z_[to] = z_[from];
  for (const uint32_t w : vertices_[to].neighbour) {
    for (uint32_t &back : vertices_[w].neighbour) {
      if (back == from) back = to;
    }
  }
}

}  // namespace hsp
