// The solvent-excluded surface of a set of balls (Section 4.3; Richards 1977): the boundary of all that a probe of
// radius p cannot reach, p the probe that the radii of the model contain. It follows from the boundary of the union,
// the surface that the probe's centre runs on, feature by feature:
//   face    a convex patch: the face, shrunk to the ball without the probe
//   arc     a saddle patch, which only its own axis cuts (saddle.hpp)
//   vertex  a concave patch on the probe's sphere, which only probes at other vertices cut (probe_caps.hpp)
// Convex and saddle patches are closed forms of what the boundary holds; only concave patches are kept here. PROOFS.md
// proves which of them are cut by which, and why.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/limits.hpp"
#include "core/workspace.hpp"
#include "surface/concave_patches.hpp"
#include "surface/probe_caps.hpp"
#include "surface/surface_shells.hpp"

namespace hsp {

struct SurfaceLimits {
  uint32_t vertices = 0;        // of the boundary
  uint32_t faces = 0;           // of the boundary
  uint32_t neighbours = 0;      // most probes that may cut any one of the patches
  uint32_t pieces = 0;          // of cut patches
  uint32_t arcs = 0;            // around these
  uint32_t cusped_circles = 0;  // circles whose saddle patches reach their axis
};

// Enough for molecules: in haemoglobin no more than 34 probes overlap any one; up to 22 of 100 patches are cut, into
// pieces of 5 arcs.
constexpr SurfaceLimits default_surface_limits(uint32_t vertices, uint32_t faces, uint32_t circles) {
  return {vertices, faces, 64, vertices / 4 + 16, vertices + vertices / 4 + 64, vertices / 8 + circles + 16};
}

struct SurfaceCounts {
  uint32_t cut_patches = 0;      // concave patches that other probes cut
  uint32_t cusped_arcs = 0;      // arcs and circles whose saddle patch its axis cuts
  uint32_t rounded_patches = 0;  // cut patches of a surface that doubles do not decide
};

class Surface {
 public:
  ConcavePatch patch(uint32_t vertex) const { return concave_[vertex]; }
  const SurfaceCounts &counts() const { return counts_; }
  // The exceptions: concave patches that others cut, and circles with cusps.
  const CutPatches &cut_patches() const { return cut_patches_; }
  const CuspedCircles &cusped_circles() const { return cusped_circles_; }
  // Of the two half-edges of each arc the first: numbers the arcs.
  const RankedBits &first_half_edges() const { return first_half_edges_; }
  const SurfaceShells &shells() const { return shells_; }
  // Vertices whose probe touches another one in a point of its patch: there derivatives of areas jump.
  const RankedBits &touching() const { return touching_; }
  // The part that is measured. Patches, edges and shells are those of both parts.
  const ChosenFaces &chosen() const { return chosen_; }
  Span<uint32_t> scratch() const { return scratch_; }  // [faces + pieces]
  // Whether patches are cut by decisions about the actual balls (actual_balls.hpp): then vertices may be too near each
  // other for doubles.
  bool is_of_actual_balls() const { return of_actual_balls_; }

 private:
  friend class SurfaceBuilder;

  ChosenFaces chosen_;
  ConcavePatches concave_;
  CutPatches cut_patches_;
  CuspedCircles cusped_circles_;
  RankedBits first_half_edges_;
  SurfaceShells shells_;
  RankedBits touching_;
  Span<uint32_t> scratch_;
  SurfaceCounts counts_;
  bool of_actual_balls_ = false;
};

}  // namespace hsp
