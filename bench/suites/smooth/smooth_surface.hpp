// hsp_surface in memory of its own, for the benchmarks; see handles.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "handles.hpp"
#include "owned_surfaces.hpp"

namespace bench {

// The solvent-excluded surface over a boundary.
class SmoothSurface {
 public:
  // Makes room for exactly what this computed boundary needs, and computes it.
  explicit SmoothSurface(const Boundary &boundary);

  void compute();
  // Areas and volume, of every ball and in total.
  hsp_surface_totals measure();
  // The sum of area and volume, with its derivatives by every centre and radius.
  hsp_energy gradient();
  // The same with a weight for the area of each ball.
  hsp_energy weighted_gradient();
  hsp_surface_counts counts() const;
  size_t bytes() const { return surface_.bytes(); }

 private:
  hsp_energy gradient_with(const double *sigma);  // null for all ones

  const Boundary *boundary_;
  std::vector<hsp_surface_totals> balls_;
  std::vector<double> weight_;
  std::vector<double> by_centre_;
  std::vector<double> by_radius_;
  support::OwnedSurface surface_;
};

// The boundary in triangles, with edges of half an Angstrom.
class Triangles {
 public:
  explicit Triangles(const Boundary &boundary);

  void compute();
  uint32_t count() const;
  size_t bytes() const { return mesh_.bytes(); }

 private:
  const Boundary *boundary_;
  support::OwnedHandle<support::MeshKind> mesh_;
};

}  // namespace bench
