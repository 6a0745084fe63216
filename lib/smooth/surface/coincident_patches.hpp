// Vertices at one position, up to rounding, on the sphere of a probe: the triangles that they see, the sides between
// them, and which of their patches has a point.
//
// Patches share the answers: they are asked in the order of the vertices, from the lowest one, so that all of them have
// the same bits. Lengths in units of the smaller probe of cusped_circles.hpp, points on the unit sphere around the
// probe's own vertex.
#pragma once

#include "exact/circle_crossing.hpp"
#include "surface/cusped_circles.hpp"
#include "surface/probe_caps.hpp"

namespace hsp {

// Nearer to each other than this positions are the same up to rounding: the smaller probe keeps others farther apart.
inline constexpr double same_position = 0x1p-28;

// The triangle that a vertex sees, as the numbers of its balls in the record of the vertex have it.
struct SeenTriangle {
  Vec3 inward[3];

  SeenTriangle(const BallSet &balls, const Boundary &boundary, const Position &position, uint32_t vertex);
};

class CoincidentPatches {
 public:
  // For the vertex that the caps were gathered for.
  CoincidentPatches(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, const ProbeGrid &grid,
                    const CuspedCircles &cusped, const ProbeCaps &probe)
      : balls_(balls), boundary_(boundary), chosen_(chosen), grid_(grid), cusped_(cusped), probe_(probe) {}

  const Boundary &boundary() const { return boundary_; }
  const ProbeGrid &grid() const { return grid_; }
  const ProbeCaps &probe() const { return probe_; }

  SeenTriangle triangle(uint32_t vertex) const { return {balls_, boundary_, grid_.position(vertex), vertex}; }
  // The vertex across the covered gap beside this one on the circle with cusps that a side is on; no_id without cusps.
  uint32_t across_cusps(uint32_t vertex, uint32_t slot) const;
  Vec3 way(uint32_t from, uint32_t to) const {
    return (1.0 / smaller_probe(balls_)) * grid_.difference(balls_, from, to);
  }

  // How far within the triangle that a vertex sees a point lies; of the sides besides one.
  double depth_in(uint32_t vertex, const Vec3 &point, uint32_t besides = no_id) const;
  // Of the vertices at the position of a cap, the one whose patch has a point.
  uint32_t vertex_at(uint32_t cap, const Vec3 &point) const;
  // Calls visit(vertex, across, slot, inward) for each side between two vertices at the position of a cap, once: of the
  // upper one, to the lower one across.
  template <class Visit>
  void for_each_side_between(uint32_t cap, Visit visit) const {
    probe_.for_each_at_position(cap, [&](uint32_t vertex) {
      const SeenTriangle seen = triangle(vertex);
      for (uint32_t slot = 0; slot < 3; ++slot) {
        const uint32_t across = across_cusps(vertex, slot);
        bool is_here = false;
        probe_.for_each_at_position(cap, [&](uint32_t other) { is_here |= other == across && other < vertex; });
        if (is_here) visit(vertex, across, slot, seen.inward[slot]);
      }
    });
  }

  // Let two vertices be at one position, with a side between them, and two more probes meet them in a point of this
  // side: the one of the two that has the corner of these two probes.
  uint32_t owner_of_corner(uint32_t vertex, uint32_t opposite_probe, uint32_t a, uint32_t b, const Vec3 &point) const;
  // Let two pairs of vertices each be at one position, and two of their sides pass through a point where their spheres
  // meet: the one of the second pair that has the corner with both of the first.
  uint32_t owner_on_side(uint32_t vertex, uint32_t opposite_probe, uint32_t first, uint32_t second,
                         const Vec3 &point) const;

 private:
  Vec3 normal_towards(uint32_t vertex, uint32_t opposite_probe) const;

  const BallSet &balls_;
  const Boundary &boundary_;
  const ChosenFaces &chosen_;
  const ProbeGrid &grid_;
  const CuspedCircles &cusped_;
  const ProbeCaps &probe_;
};

}  // namespace hsp
