// Vertices of a mesh of the smooth surface against its definition: their distance from the outside of the balls with
// the probe is the probe's radius, and inside of patches their normals point to where the outside is nearest.
#pragma once

#include <mesh_result.h>

struct VertexErrors {
  double off = 0.0;     // the largest difference of a distance and the probe's radius
  double normal = 0.0;  // the largest one of a normal
};

VertexErrors surface_vertex_errors(const mesh_result &mesh, double probe);
