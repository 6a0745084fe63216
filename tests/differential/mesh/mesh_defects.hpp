// How far the triangles of a mesh are from lying flat on the surface, in degrees: between the normals of triangles that
// share an edge where the surface is smooth, and between the normal of a triangle and the surface's at its corners.
//
// The surface is smooth inside of patches; the smooth surface also where patches of different kinds meet. At cusps it
// has tips, so edges that end there do not count.
#pragma once

#include <mesh_result.h>

#include <array>
#include <set>

struct MeshDefects {
  double bend = 0.0;       // the largest angle between neighbours
  double tilt = 0.0;       // the largest one at a corner
  double mean_bend = 0.0;  // weighted by the areas of triangles
  double mean_tilt = 0.0;
  double share_above = 0.0;  // of the area: triangles with a larger bend or tilt than the limit
};

// NULL: of a boundary. Triangles without area, as between vertices that coincide, are left out.
MeshDefects mesh_defects(const mesh_result &mesh, const hsp_surface *surface, double limit);

// Corners of a smooth surface that lie on no ball: cusps, and where creases meet.
std::set<std::array<double, 3>> surface_cusps(const hsp_surface *surface);
