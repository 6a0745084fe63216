#include "loop_nesting.hpp"

#include <stdexcept>

#include "disjoint_sets.hpp"

namespace oracle {
namespace {

std::vector<uint32_t> clusters_of_caps(const TiedBalls &set, const SphereLoops &sphere) {
  DisjointSets clusters(sphere.circles.size());
  for (size_t p = 0; p < sphere.circles.size(); ++p)
    for (size_t q = 0; q < p; ++q) {
      const Cap &first = sphere.circles[p].circle();
      const Cap &second = sphere.circles[q].circle();
      if (set.circles_cross(sphere.ball, first, second) || set.circle_inside(sphere.ball, first, second) ||
          set.circle_inside(sphere.ball, second, first))
        clusters.join(p, q);
    }
  return clusters.numbers();
}

// The loop through a free crossing of a cluster's circle with a great circle.
uint32_t loop_through(const SphereLoops &sphere, uint32_t ball, const Cap &great_circle, int side) {
  for (size_t p = 0; p < sphere.circles.size(); ++p) {
    if (sphere.circles[p].circle().ball != ball) continue;
    const bool whole = sphere.circles[p].kind() == FreePieces::Kind::whole;
    return sphere.loop_of_arc[p].at(whole ? 0 : sphere.circles[p].arc_with_crossing(great_circle, side));
  }
  throw std::logic_error("no such circle");
}

// The loop that bounds the component of the complement of a cluster in which a cap of another cluster lies.
uint32_t loop_around(const TiedBalls &set, const SphereLoops &sphere, const std::vector<Cap> &cluster, const Cap &cap) {
  Cap great_circle = {cross(cap.normal, cluster.front().normal), no_ball};
  if (is_zero(great_circle.normal)) great_circle.normal = cross(cap.normal, Vector{1, 0, 0});
  if (is_zero(great_circle.normal)) great_circle.normal = cross(cap.normal, Vector{0, 1, 0});
  const FreePieces walk(set, sphere.ball, great_circle, cluster);
  const FreeArc &arc = walk.arcs().at(walk.arc_with_direction(cap.normal));
  // Seen from the cap's circle the great circle comes second, which turns the sides round.
  const uint32_t loop = loop_through(sphere, arc.exit.ball, great_circle, -1);
  if (loop != loop_through(sphere, arc.entry.ball, great_circle, +1))
    throw std::logic_error("one component with two loops: " + to_text(set.balls()));
  return loop;
}

}  // namespace

std::vector<uint32_t> faces_of_loops(const TiedBalls &set, const SphereLoops &sphere) {
  const std::vector<uint32_t> cluster_of_cap = clusters_of_caps(set, sphere);
  std::vector<std::vector<Cap>> clusters;
  std::vector<uint32_t> cluster_of_loop(sphere.loops);
  for (size_t p = 0; p < sphere.circles.size(); ++p) {
    if (cluster_of_cap[p] >= clusters.size()) clusters.resize(cluster_of_cap[p] + 1);
    clusters[cluster_of_cap[p]].push_back(sphere.circles[p].circle());
    for (const uint32_t loop : sphere.loop_of_arc[p]) cluster_of_loop[loop] = cluster_of_cap[p];
  }

  const size_t count = clusters.size();
  std::vector<std::vector<uint32_t>> around(count, std::vector<uint32_t>(count, 0));
  for (size_t k = 0; k < count; ++k)
    for (size_t other = 0; other < count; ++other)
      if (k != other) around[k][other] = loop_around(set, sphere, clusters[k], clusters[other].front());

  DisjointSets faces(sphere.loops);
  for (uint32_t l = 0; l < sphere.loops; ++l)
    for (uint32_t m = 0; m < l; ++m) {
      const uint32_t k = cluster_of_loop[l];
      const uint32_t other = cluster_of_loop[m];
      if (k == other || around[k][other] != l || around[other][k] != m) continue;
      bool separated = false;
      for (size_t third = 0; third < count; ++third)
        if (third != k && third != other && around[third][k] != around[third][other]) separated = true;
      if (!separated) faces.join(l, m);
    }
  if (sphere.loops > 0 && faces.count() + count != sphere.loops + 1)
    throw std::logic_error("faces, clusters and loops are no tree: " + to_text(set.balls()));
  return faces.numbers();
}

}  // namespace oracle
