// Fills a mesh: patch by patch, until all patches that share a curve agree how many points it has.
#pragma once

#include "core/patience.hpp"
#include "mesh/surface_outline.hpp"

namespace hsp {

class MeshBuilder : public Limited<MeshLimits> {
 public:
  void carve(Workspace &workspace, const MeshLimits &limits);

  // A mesh with edges of about this length, in lattice steps. Status::capacity if a limit is too small; needed() then
  // reports what suffices as far as it is known. Status::range if there are more points than any limit allows.
  // Status::degenerate if borders lie on each other in ways that nothing tells apart.
  Status build(const MeshedSurface &from, double edge, Patience patience = Patience());

  const Mesh &mesh() const { return mesh_; }

 private:
  struct PatchRange {
    uint32_t first, last;  // triangles
    bool outdated;         // to be made again
    bool unfinished;       // not made at all
  };

  template <class Outline>
  Status build_all(Outline &outline, double edge, Patience &patience);
  template <class Outline>
  bool has_too_many_inside(const Outline &outline, double edge, Patience &patience) const;
  template <class Outline>
  Status triangulate_all(Outline &outline, double edge, Patience &patience);
  template <class Outline>
  Status triangulate_rest(Outline &outline, double edge, Patience &patience);
  enum class Borders : uint8_t { apart, pinched, without_area };
  template <class Outline>
  PatchState attempt(Outline &outline, double edge, uint32_t sphere, Borders borders);
  template <class Outline>
  bool triangulate(Outline &outline, double edge, uint32_t sphere, bool pinched);
  template <class Outline>
  void add_samples(Outline &outline, uint32_t c);
  template <class Outline>
  bool refine(Outline &outline, Patience &patience);
  void remove_outdated(uint32_t first_of_bands, Patience &patience);
  template <class Outline>
  bool name_balls(const Outline &outline, Patience &patience);
  void sort_by_patches(Patience &patience);

  Mesh mesh_;
  BoundaryCurves curves_;
  SphericalPatch patch_;
  Span<PatchRange> range_;       // [spheres]
  Span<uint32_t> vertex_moves_;  // [vertices]
};

}  // namespace hsp
