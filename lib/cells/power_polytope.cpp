#include "cells/power_polytope.hpp"

#include <initializer_list>

namespace hsp {

void PowerPolytope::carve(Workspace &workspace, uint32_t balls) {
  vertices_ = workspace.take<PolytopeVertex>(2 * most_vertices(balls));
  for (Span<double> *numbers : {&x_, &y_, &z_, &squared_, &value_}) {
    *numbers = workspace.take<double>(2 * most_vertices(balls));
    for (double &number : *numbers) number = 0.0;  // four are read at once, and some may not be those of vertices
  }
  beyond_ = workspace.take<uint64_t>(2 * most_vertices(balls) / 64 + 1);
  holes_ = workspace.take<uint32_t>(2 * most_vertices(balls));
  open_ = workspace.take<uint32_t>(most_planes(balls));
  for (uint32_t &end : open_) end = no_id;
  count_ = 0;
  wide_code_ = workspace.wide_code();
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
    squared_[v] = dot(vertex.at.y - centre, vertex.at.y - centre);
    x_[v] = vertex.at.y.x;
    y_[v] = vertex.at.y.y;
    z_[v] = vertex.at.y.z;
  }
}

double PowerPolytope::reach() const {
  const uint32_t count = count_;
  const double *const squared = squared_.data();
  double most[2] = {0.0, 0.0};
  for (uint32_t v = 0; v + 1 < count; v += 2) {
    most[0] = squared[v] > most[0] ? squared[v] : most[0];
    most[1] = squared[v + 1] > most[1] ? squared[v + 1] : most[1];
  }
  // A simple polytope has an even number of vertices.
  return std::sqrt(most[0] > most[1] ? most[0] : most[1]) + most_doubt_;
}

Vec3 PowerPolytope::middle() const {
  const uint32_t count = count_;
  const double *const x = x_.data(), *const y = y_.data(), *const z = z_.data();
  Vec3 sum{0, 0, 0};
  for (uint32_t v = 0; v < count; ++v) sum = sum + Vec3{x[v], y[v], z[v]};
  return (1.0 / static_cast<double>(count)) * sum;
}

void PowerPolytope::cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame) {
  const uint32_t old = count_, hole_count = hole_count_;
  const UnitPlane S = planes[plane];
  const EdgeCrossing crossing(frame);
  const Vec3 centre = centre_;
  PolytopeVertex *const vertices = vertices_.data();
  double *const x = x_.data(), *const y = y_.data(), *const z = z_.data(), *const squared = squared_.data();
  const double *const values = value_.data();
  const uint32_t *const holes = holes_.data();
  const uint64_t first_bits = beyond_[0];
  const uint64_t *const more_bits = beyond_.data();
  const auto is_beyond = [&](uint32_t v) { return ((old <= 64 ? first_bits : more_bits[v / 64]) >> v % 64 & 1) != 0; };
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
  // behind the last one. The bits stay as they are meanwhile.
  uint32_t filled = 0, end = old;
  double most_doubt = most_doubt_;
  for (uint32_t hole = 0; hole < hole_count; ++hole) {
    const uint32_t w = holes[hole];
    const PlacedPoint gone = vertices[w].at;
    const uint32_t planes_of[3] = {vertices[w].plane[0], vertices[w].plane[1], vertices[w].plane[2]};
    const uint32_t next[3] = {vertices[w].neighbour[0], vertices[w].neighbour[1], vertices[w].neighbour[2]};
    const double value = values[w];
    // The edge to vertex v, on planes a and b.
    const auto cross = [&](uint32_t v, uint32_t a, uint32_t b) __attribute__((always_inline)) {
      if (is_beyond(v)) return;
      const uint32_t to = filled <= hole ? holes[filled++] : end++;
      PolytopeVertex &left = vertices[v], &made = vertices[to];
      left.neighbour[left.neighbour[0] == w ? 0 : left.neighbour[1] == w ? 1 : 2] = to;
      PlacedPoint at;
      if (!crossing.find(left.at, values[v], gone, value, at)) {
        at = frame.common_point(planes[a], planes[b], S);
      }
      const Vec3 from_centre = at.y - centre;
      made.at = at;
      squared[to] = dot(from_centre, from_centre);
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
    cross(next[0], planes_of[1], planes_of[2]);
    cross(next[1], planes_of[0], planes_of[2]);
    cross(next[2], planes_of[0], planes_of[1]);
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
  squared_[to] = squared_[from];
  for (const uint32_t w : vertices_[to].neighbour) {
    for (uint32_t &back : vertices_[w].neighbour) {
      if (back == from) back = to;
    }
  }
}

}  // namespace hsp
