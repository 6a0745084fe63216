#include "cells/arrangement.hpp"

#include "core/disjoint_sets.hpp"
#include "exact/predicates.hpp"
#include "model/queries.hpp"

namespace hsp {
namespace {

// No ball has an index as large.
constexpr uint32_t crosses_another = UINT32_C(1) << 31;
static_assert(max_count < crosses_another);

}  // namespace

Arrangement arrangement_on_sphere(const CubeGrid &grid, uint32_t i, Span<uint32_t> scratch, uint64_t &words) {
  const uint32_t room = scratch.size() / 2;
  const Span<uint32_t> ids = scratch.part(0, room);
  QueryResult result{ids.data(), room, 0};
  find_neighbours(grid, i, result);
  words = 2 * uint64_t{result.hits};
  if (result.hits > room) return {};
  // Only balls whose spheres meet this one in a circle matter.
  const BallSet &balls = grid.balls();
  const exact::LatticeBall own = balls.ball(i);
  uint32_t circles = 0;
  double length_squared = static_cast<double>(exact::sphere_of(own).W);
  for (uint32_t k = 0; k < result.hits; ++k) {
    const uint32_t j = grid.grid_index(ids[k]);
    const exact::LatticeBall other = balls.ball(j);
    if (exact::pair_relation(own, other) != exact::PairRelation::circle) continue;
    const exact::Plane plane = exact::plane_of(own, other);
    const double squared = static_cast<double>(dot(plane.v, plane.v));
    length_squared = squared > length_squared ? squared : length_squared;
    ids[circles++] = j;
  }
  const auto plane_of = [&](uint32_t k) { return exact::plane_of(own, balls.ball(ids[k] & ~crosses_another)); };
  DisjointSets sets(scratch.part(room, room + circles));
  sets.reset();
  Arrangement count;
  const exact::Predicates predicates(exact::sphere_of(own), length_squared);
  for (uint32_t j = 0; j < circles; ++j) {
    const exact::Plane plane = plane_of(j);
    for (uint32_t k = j + 1; k < circles; ++k) {
      if (predicates.crossing(plane, plane_of(k)).sign < 0) continue;
      count.vertices += 2;
      ids[j] |= crosses_another;
      ids[k] |= crosses_another;
      static_cast<void>(sets.join(j, k));
    }
  }
  count.edges = 2 * count.vertices;
  count.faces = count.vertices + 1;
  for (uint32_t k = 0; k < circles; ++k) {
    count.edges += (ids[k] & crosses_another) == 0 ? 1 : 0;
    count.faces += sets.root(k) == k ? 1 : 0;
  }
  return count;
}

}  // namespace hsp
