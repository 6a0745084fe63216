// The curves of a smooth surface, divided by as many points as their lengths demand, and sets of balls whose surfaces
// have all kinds of parts: cusps, creases, patches in pieces, whole circles.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "built_surface.hpp"
#include "lattice_lengths.hpp"
#include "mesh/surface_outline.hpp"
#include "random_balls.hpp"

class DividedCurves {
 public:
  DividedCurves(const BuiltSurface &built, double length)
      : room_(hsp::SurfaceMap(built.balls(), built.boundary(), built.surface()).edge_count()),
        curves_(built.balls(), built.boundary(), built.surface(),
                hsp::Span<hsp::MeshCurve>(room_.data(), static_cast<uint32_t>(room_.size()))) {
    hsp::Patience endless;
    EXPECT_TRUE(curves_.divide(length, endless));
  }

  hsp::SurfaceOutline &get() { return curves_; }
  const hsp::SurfaceOutline &get() const { return curves_; }

 private:
  std::vector<hsp::MeshCurve> room_;
  hsp::SurfaceOutline curves_;
};

// Three equal balls around a point: a hole in each concave patch at 2.9 and 3.09, three whole spindles at 3.2.
inline support::BallList three_around(double circumradius) {
  support::BallList three;
  three.add(1000.0 * circumradius, 0.0, 0.0, 1700.0);
  three.add(-500.0 * circumradius, 866.0 * circumradius, 0.0, 1700.0);
  three.add(-500.0 * circumradius, -866.0 * circumradius, 0.0, 1700.0);
  return three;
}

// Thirty balls, most of them with cusps and patches in pieces.
inline constexpr double small_cluster_probe = 70.0;
inline support::BallList small_cluster(uint64_t seed) {
  oracle::RandomSource random(seed);
  return oracle::in_lengths(oracle::loose_balls(random, 30), 1);
}

inline double distance_between(const hsp::BallSet &balls, const hsp::Position &a, const hsp::Position &b) {
  const hsp::Vec3 d = balls.difference(a.ball, b.ball) + (b.offset - a.offset);
  return std::sqrt(dot(d, d));
}

// The probe's radius less the distance of a point from the nearest vertex of the boundary: at most 0 for all points of
// the surface, and 0 on concave patches.
inline double depth_in_probes(const BuiltSurface &built, const hsp::Position &point) {
  double nearest = 4e9;
  for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
    nearest = std::min(
        nearest, distance_between(built.balls(), point, hsp::position_of_vertex(built.balls(), built.boundary(), v)));
  }
  return static_cast<double>(built.balls().probe_steps) - nearest;
}
