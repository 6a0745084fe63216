// A mesh in memory of its own, and properties of its triangles as a surface, computed from positions and corners alone.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "carved_memory.hpp"
#include "mesh/mesh_builder.hpp"

class BuiltMesh {
 public:
  using Point = std::array<double, 3>;

  // The mesh of balls and their boundary, or of the smooth surface over it, as in MeshedSurface. Limits start with
  // those expected to suffice.
  template <class... Source>
  BuiltMesh(double edge, const Source &...source) {
    hsp::MeshLimits limits;
    EXPECT_EQ(hsp::expected_mesh_limits({source...}, edge, limits), hsp::Status::ok);
    for (;;) {
      memory_.carve(builder_, limits);
      status_ = builder_.build({source...}, edge);
      if (status_ != hsp::Status::capacity || retries_ == 20) break;
      limits = builder_.retry_limits();
      ++retries_;
    }
  }

  hsp::Status status() const { return status_; }
  uint32_t retries() const { return retries_; }
  const hsp::MeshBuilder &builder() const { return builder_; }
  const hsp::Mesh &mesh() const { return builder_.mesh(); }
  int64_t euler() const { return int64_t{mesh().vertex_count()} - mesh().triangle_count() / 2; }

  // Every edge is in two triangles that run through it in opposite directions, and the triangles around a vertex are
  // one ring.
  bool is_closed() const {
    struct Wedge {
      uint32_t vertex, next, last;
      bool operator<(const Wedge &w) const { return vertex < w.vertex || (vertex == w.vertex && next < w.next); }
    };
    std::vector<Wedge> wedges;
    for (uint32_t t = 0; t < mesh().triangle_count(); ++t) {
      const uint32_t *const v = mesh().triangle(t).vertex;
      for (uint32_t k = 0; k < 3; ++k) wedges.push_back({v[k], v[(k + 1) % 3], v[(k + 2) % 3]});
    }
    std::sort(wedges.begin(), wedges.end());
    size_t rings = 0;
    for (size_t first = 0, last = 0; first < wedges.size(); first = last, ++rings) {
      while (last < wedges.size() && wedges[last].vertex == wedges[first].vertex) ++last;
      size_t seen = 0;
      size_t at = first;
      do {
        const auto begin = wedges.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = wedges.begin() + static_cast<std::ptrdiff_t>(last);
        const Wedge wanted{wedges[at].vertex, wedges[at].last, 0};
        const auto found = std::lower_bound(begin, end, wanted);
        if (found == end || wanted < *found || (found + 1 != end && !(*found < found[1]))) return false;
        at = static_cast<size_t>(found - wedges.begin());
      } while (++seen <= last - first && at != first);
      if (seen != last - first) return false;
    }
    return rings == mesh().vertex_count();
  }

  // Vertices whose normal does not point to the side that their triangles show.
  uint32_t wrong_normals() const {
    std::vector<double> along(mesh().vertex_count(), 0.0);
    for (uint32_t t = 0; t < mesh().triangle_count(); ++t) {
      const Point n = twice_area(t);
      for (const uint32_t v : mesh().triangle(t).vertex) {
        for (size_t axis = 0; axis < 3; ++axis) along[v] += mesh().vertex(v).normal[axis] * n[axis];
      }
    }
    uint32_t wrong = 0;
    for (const double a : along) wrong += a > 0.0 ? 0 : 1;
    return wrong;
  }

  double area() const {
    double sum = 0.0;
    for (uint32_t t = 0; t < mesh().triangle_count(); ++t) {
      const Point n = twice_area(t);
      sum += 0.5 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    return sum;
  }
  double volume() const {
    double sum = 0.0;
    for (uint32_t t = 0; t < mesh().triangle_count(); ++t) {
      const Point n = twice_area(t);
      for (size_t axis = 0; axis < 3; ++axis) sum += corner(t, 0)[axis] * n[axis] / 6;
    }
    return sum;
  }

 private:
  Point corner(uint32_t t, uint32_t k) const {
    const double *const p = mesh().vertex(mesh().triangle(t).vertex[k]).position;
    return {p[0], p[1], p[2]};
  }
  Point twice_area(uint32_t t) const {
    const Point a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    Point u, v;
    for (size_t axis = 0; axis < 3; ++axis) {
      u[axis] = b[axis] - a[axis];
      v[axis] = c[axis] - a[axis];
    }
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }

  CarvedMemory memory_;
  hsp::MeshBuilder builder_;
  hsp::Status status_ = hsp::Status::state;
  uint32_t retries_ = 0;
};
