// Caps of a unit sphere from a table, and the free part of the sphere by sampling. The sampling uses the library's
// sin_cos and vectors, but not its arcs or formulas.
#pragma once

#include <cmath>

#include "cases.hpp"
#include "core/elementary.hpp"
#include "sphere/caps.hpp"
#include "surface/free_region.hpp"

namespace cases {

struct UnitCap {
  double x, y, z;  // any length
  double height;
};

struct SmallCaps {
  static constexpr uint32_t most = 12;
  hsp::Caps caps;
  hsp::FixedVector<hsp::RegionCorner> corners;
  hsp::FixedVector<hsp::RegionArc> arcs;
  alignas(64) unsigned char memory[24 * 1024];

  SmallCaps(const UnitCap *cap, uint32_t n) {
    hsp::Workspace workspace(memory, sizeof memory);
    caps.carve(workspace, most);
    corners = hsp::FixedVector(workspace.take<hsp::RegionCorner>(6 * most));
    arcs = hsp::FixedVector(workspace.take<hsp::RegionArc>(6 * most));
    caps.count = n;
    for (uint32_t k = 0; k < n; ++k) {
      const double length = std::sqrt(cap[k].x * cap[k].x + cap[k].y * cap[k].y + cap[k].z * cap[k].z);
      caps.ux[k] = cap[k].x / length;
      caps.uy[k] = cap[k].y / length;
      caps.uz[k] = cap[k].z / length;
      caps.b[k] = cap[k].height;
      caps.ball[k] = k;
    }
  }

  // Area and vector area by points of a Fibonacci lattice.
  double sample(hsp::Vec3 &vector_area) const {
    constexpr uint32_t points = 20000;
    constexpr double golden = 2.399963229728653;
    double area = 0.0;
    vector_area = {0.0, 0.0, 0.0};
    for (uint32_t k = 0; k < points; ++k) {
      const double z = 1.0 - (2.0 * k + 1.0) / points;
      const hsp::SinCos turn = hsp::sin_cos(golden * k);
      const double radius = std::sqrt(1.0 - z * z);
      const hsp::Vec3 p{radius * turn.cosine, radius * turn.sine, z};
      bool free = true;
      for (uint32_t c = 0; c < caps.count; ++c) free = free && dot(caps.axis(c), p) < caps.b[c];
      if (!free) continue;
      area += 4 * hsp::pi / points;
      vector_area = combine(1.0, vector_area, 4 * hsp::pi / points, p);
    }
    return area;
  }
};

// Areas that differ by a multiple of 2 pi are equal.
inline bool near_modulo_turn(double a, double b, double tolerance) {
  const double turns = (a - b) / (2 * hsp::pi);
  return near(turns, std::round(turns), tolerance / (2 * hsp::pi));
}

// A random triangle of great circles and caps, as on a probe.
struct RandomCaps {
  UnitCap cap[SmallCaps::most];
  uint32_t n;

  explicit RandomCaps(uint64_t seed) {
    Random random(seed);
    n = 3 + random.below(SmallCaps::most - 3);
    for (uint32_t k = 0; k < n; ++k) {
      const auto coordinate = [&random] { return 2 * random.fraction() - 1; };
      cap[k] = {coordinate(), coordinate(), coordinate(), k < 3 ? 0.0 : 0.1 + 0.9 * random.fraction()};
    }
  }
};

}  // namespace cases
