// Areas and volumes of the concave patches of all vertices, as far as other probes leave them.
#pragma once

#include "measure/areas.hpp"
#include "surface/cut_patches.hpp"
#include "surface/probe_grid.hpp"

namespace hsp {

// Turns measures of a part of the unit sphere about a vertex into those of the probe's sphere, in lattice steps. The
// outward normal of the surface points to the probe's centre.
struct ConcaveScale {
  double p;
  Vec3 arm;  // from the origin of the component to the vertex

  ConcaveScale(const BallSet &balls, const Boundary &boundary, const Position &vertex)
      : p(static_cast<double>(balls.probe_steps)),
        arm(offset_from_origin(balls, boundary, vertex.ball) + vertex.offset) {}
  ConcavePatch patch(double steradians, const Vec3 &vector_area) const {
    return {p * p * steradians, -p * p * (p * steradians + dot(arm, vector_area)) / 3, vector_area};
  }
};

// Patches are stored in the memory of the grid of probes, after its last search: there is memory for only one of the
// two. So whole patches, which the search has measured already, are measured once more.
class ConcavePatches {
 public:
  void use(const ProbeGrid &grid) {
    vector_area_ = grid.shared_vectors();
    area_and_volume_ = grid.shared_doubles();
  }
  // The positions of the probes must still be there; they are overwritten. False if `patience` stops it.
  bool measure(const BallSet &balls, const Boundary &boundary, const ProbePositions &positions, const CutPatches &cut,
               Patience &patience);
  // All measures are 0, as without a probe.
  void clear(uint32_t vertices);

  ConcavePatch operator[](uint32_t vertex) const {
    return {area_and_volume_[2 * vertex], area_and_volume_[2 * vertex + 1], vector_area_[vertex]};
  }

 private:
  void put(uint32_t vertex, const ConcavePatch &patch);

  Span<Vec3> vector_area_;        // [vertices]
  Span<double> area_and_volume_;  // [2 vertices]
};

}  // namespace hsp
