// Questions to a finished map: what is seen at a point, how deep, and what an edge separates.
#pragma once

#include "maps/disc_grid.hpp"
#include "maps/visibility_map.hpp"

namespace hsp {

// What is seen at a point of the view plane.
struct MapSight {
  uint32_t ball;  // no_id for the background
  double depth;   // view coordinate z of the ball's front there
};

// The ball by the discs at the point, without the map's edges: O(balls of a few squares).
MapSight sight_at(const VisibilityMap &map, const DiscGrid &grid, double x, double y);

// A point of an edge, and how far below it the surface is on either side; infinite beside all balls. One of both is 0,
// or both on a crease.
struct EdgePoint {
  double x, y, z;
  double gap_left, gap_right;
};

// t: a parameter of the edge.
EdgePoint edge_point(const VisibilityMap &map, uint32_t edge, double t);

// Adds up the areas of each ball's faces; area [n], by the numbers that the caller gave the balls.
void sum_visible_areas(const VisibilityMap &map, Span<const uint32_t> caller, Span<double> area);

// All that is covered, of a map of whatever bodies.
template <class Map>
double covered_area(const Map &map) {
  double sum = 0.0;
  for (const MapFace &face : map.faces.items()) sum += face.owner == no_id ? 0.0 : face.area;
  return sum;
}

// The half-edge before another one around its face: the one before it around their common vertex, the other way.
uint32_t previous_half_edge(const VisibilityMap &map, uint32_t h);

// The loop of the same face after another one, the first one after the last.
uint32_t next_loop(const VisibilityMap &map, uint32_t loop);

}  // namespace hsp
