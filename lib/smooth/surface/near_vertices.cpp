#include "surface/near_vertices.hpp"

#include "core/sorting.hpp"
#include "surface/probe_caps.hpp"

namespace hsp {
namespace {

// Above this error the floats of a triangle's sides are useless: all probes that overlap count as near.
constexpr double most_side_error = 0x1p-24;
constexpr float no_limit = 16.0F;

}  // namespace

bool NearVertices::find(uint32_t vertex) {
  find_by_floats(vertex);
  required_ = list_.required();
  if (list_.overflowed()) return false;
  if (asked() > 0) {
    uint32_t left = 0;
    for (const uint32_t other : list_.items()) {
      if (actual_.may_cut_patch(other, vertex)) list_[left++] = other;
    }
    list_.shrink(left);
  }
  sort_ascending(list_.items());
  return true;
}

void NearVertices::find_by_floats(uint32_t vertex) {
  const BallSet &balls = actual_.balls();
  const Boundary &boundary = actual_.boundary();
  const uint32_t lane = measure_next_triangle(balls, boundary, grid_.positions(), vertex, triangles_);
  ProbeSearch search;
  grid_.start_search(balls, vertex, search);
  aim(triangles_, lane, search);
  const double error = vertex_error * static_cast<double>(balls.largest_radius) * triangles_.side_error[lane];
  const bool has_sides =
      triangles_.steradians[lane] >= 0.0 && boundary.root_discriminant(vertex) > 0.0 && error <= most_side_error;
  if (!has_sides) search.margin = no_limit;
  list_.clear();
  for_each_near_probe(boundary.target(), search, [&](uint32_t other) {
    if (other != vertex && may_cut(boundary, chosen_, vertex, other)) list_.push(other);
  });
}

}  // namespace hsp
