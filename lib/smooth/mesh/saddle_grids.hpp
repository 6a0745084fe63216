// The saddles of the smooth surface as triangles: every part of a saddle is a grid, with equally many points on
// opposite edges.
#pragma once

#include "mesh/mesh_sizes.hpp"
#include "mesh/surface_curves.hpp"

namespace hsp {

class SaddleGrids {
 public:
  explicit SaddleGrids(const SurfaceCurves &curves) : curves_(curves) {}

  // The room that they are expected to need. The curves need not be divided yet.
  void add_sizes(double length, MeshSizes &sizes) const;
  // Whether the chosen patches have no more triangles than any limit allows. Makes none.
  bool fit(double length, Patience &patience) const;
  // Adds the triangles of chosen patches. Along the profile of a whole circle edges have about this length. False if
  // there are more triangles than any limit allows.
  bool add_triangles(double length, Patience &patience, FixedVector<MeshVertex> &vertices,
                     FixedVector<MeshTriangle> &triangles) const;

 private:
  struct Grid;
  template <class Visit>
  bool for_each_grid(double length, Patience &patience, Visit visit) const;
  Grid grid_of(uint32_t saddle, uint32_t part, const SaddleBand &band, double length) const;
  void add_grid(const SaddleBand &band, Grid &grid, FixedVector<MeshVertex> &vertices,
                FixedVector<MeshTriangle> &triangles) const;

  const SurfaceCurves &curves_;
};

}  // namespace hsp
