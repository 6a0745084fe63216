#include "surface/concave_patches.hpp"

namespace hsp {

// Placement new begins the lives of these doubles: the memory held floats.
void ConcavePatches::put(uint32_t vertex, const ConcavePatch &patch) {
  ::new (static_cast<void *>(&area_and_volume_[2 * vertex])) double(patch.area);
  ::new (static_cast<void *>(&area_and_volume_[2 * vertex + 1])) double(patch.volume);
  vector_area_[vertex] = patch.vector_area;
}

void ConcavePatches::clear(uint32_t vertices) {
  for (uint32_t v = 0; v < vertices; ++v) put(v, {});
}

// A vector area is stored over the offset of its vertex, after the offsets of all four vertices at hand have been read.
bool ConcavePatches::measure(const BallSet &balls, const Boundary &boundary, const ProbePositions &positions,
                             const CutPatches &cut, Patience &patience) {
  constexpr uint32_t lanes = ProbeTriangles::lanes;
  const uint32_t vertices = boundary.vertex_count();
  ProbeTriangles triangles;
  for (uint32_t first = 0; first < vertices; first += lanes) {
    if (!patience.allows(2000)) return false;
    const uint32_t count = vertices - first < lanes ? vertices - first : lanes;
    measure_triangles(balls, boundary, positions, first, triangles);
    for (uint32_t lane = 0; lane < count; ++lane) {
      const uint32_t v = first + lane;
      if (cut.is_cut(v)) {
        put(v, cut.patch(v));
        continue;
      }
      const Vec3 vector_area{triangles.vector_area[0][lane], triangles.vector_area[1][lane],
                             triangles.vector_area[2][lane]};
      put(v, ConcaveScale(balls, boundary, positions[v]).patch(triangles.steradians[lane], vector_area));
    }
  }
  return true;
}

}  // namespace hsp
