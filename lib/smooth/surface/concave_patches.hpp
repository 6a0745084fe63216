// The rest of the concave patches of all vertices, after other probes have cut them.
#pragma once

#include "measure/areas.hpp"
#include "surface/cut_patches.hpp"
#include "surface/probe_grid.hpp"

namespace hsp {

// A part of the unit sphere about a vertex, in lattice steps. The outward normal is towards the probe's centre.
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

// They are stored where the grid of probes was, once nobody searches any more: there is memory for one of both. So
// whole patches, which the search has measured already, are measured once more.
class ConcavePatches {
 public:
  void use(const ProbeGrid &grid) {
    vector_area_ = grid.shared_vectors();
    area_and_volume_ = grid.shared_doubles();
  }
  // The probes must stand at their positions; they do not any more thereafter.
  // False if that is stopped.
  bool measure(const BallSet &balls, const Boundary &boundary, const ProbePositions &positions, const CutPatches &cut,
               Patience &patience);
  // Without a probe.
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
