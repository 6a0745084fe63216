// Random query centres, and the loops that ask about all of them or about every ball.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "handles.hpp"

namespace bench {

// `count` points [count][3], uniform in the box around all balls (centres and radii).
std::vector<double> random_points_in_box(const Model &model, size_t count);

// `count` points [count][3], each uniform in the ball of radius 1 Angstrom around a random centre.
std::vector<double> random_points_near_atoms(const Model &model, size_t count);

// `count` points [count][3] within 1 Angstrom of the surface, outside all balls: a random direction from a random
// centre, uniform between the sphere and 1 Angstrom above it, those inside other balls left out.
std::vector<double> random_points_near_surface(const Model &model, size_t count);

// Ask for the balls that contain each of the points [count][3], or that meet the ball of this radius around it.
// Returns the number of hits.
size_t query_points(const Model &model, const std::vector<double> &points);
size_t query_balls(const Model &model, const std::vector<double> &points, double radius);

// Ask for the first ball on the ray from each of the points [count][3] towards the next one. Returns how many rays meet
// one.
size_t query_rays(const Model &model, const std::vector<double> &points);

// Ask for the neighbours of every ball of the model (Step 1). Returns the number of neighbours listed.
size_t query_all_neighbours(const Model &model);

// The same in one call, into arrays that grow as needed.
size_t query_all_pairs(const Model &model, std::vector<uint32_t> &first, std::vector<uint32_t> &ids);

// Ask in which region of the complement each of the points [count][3] lies. Returns how many lie inside balls and how
// many in voids.
struct Located {
  size_t inside = 0;
  size_t in_voids = 0;
};
Located locate_points(Topology &topology, const std::vector<double> &points);

}  // namespace bench
