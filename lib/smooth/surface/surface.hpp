// The solvent-excluded surface of a set of balls (Section 4.3; Richards 1977): the boundary of all points that a probe
// of radius p cannot reach. The radii of the model contain p. The probe's centre runs on the boundary of the union, and
// each feature of that boundary gives one patch:
//   face    a convex patch: the face, shrunk to the ball without the probe
//   arc     a saddle patch, which only its own axis cuts (saddle.hpp)
//   vertex  a concave patch on the probe's sphere, which only probes at other vertices cut (probe_caps.hpp)
// Convex and saddle patches have closed forms in the records of the boundary, so only concave patches are stored.
// PROOFS.md proves which patches are cut, and by what.
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
  uint32_t neighbours = 0;      // the most probes that may cut one patch
  uint32_t pieces = 0;          // of all cut patches
  uint32_t arcs = 0;            // around these pieces
  uint32_t cusped_circles = 0;  // circles whose saddle patches reach their axis
};

// Enough for molecules: in haemoglobin no probe is overlapped by more than 34 others; up to 22 of 100 concave patches
// are cut, into pieces of 5 arcs.
constexpr SurfaceLimits default_limits(uint32_t vertices, uint32_t faces, uint32_t circles) {
  return {vertices, faces, 64, vertices / 4 + 16, vertices + vertices / 4 + 64, vertices / 8 + circles + 16};
}

struct SurfaceCounts {
  uint32_t cut_patches = 0;      // concave patches that other probes cut
  uint32_t cusped_arcs = 0;      // arcs and circles whose saddle patch its axis cuts
  uint32_t rounded_patches = 0;  // all cut patches if doubles do not decide the surface, else 0
};

class Surface {
 public:
  ConcavePatch patch(uint32_t vertex) const { return concave_[vertex]; }
  SurfaceCounts counts() const {
    const uint32_t cut = cut_patches_.piece_count() - cut_patches_.extra_pieces().size();
    return {cut, cusped_circles_.saddles(), of_actual_balls_ ? cut : 0};
  }
  // The exceptions: concave patches that other probes cut, and circles with cusps.
  const CutPatches &cut_patches() const { return cut_patches_; }
  const CuspedCircles &cusped_circles() const { return cusped_circles_; }
  // The first of the two half-edges of each arc; its rank in this set is the number of the arc.
  const RankedBits &first_half_edges() const { return first_half_edges_; }
  const SurfaceShells &shells() const { return shells_; }
  // Vertices whose probe touches another probe in a point of the vertex's patch: derivatives of areas jump there.
  const RankedBits &touching() const { return touching_; }
  // The part of the boundary whose surface is measured. Patches, edges and shells are there for both parts.
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
  bool of_actual_balls_ = false;
};

}  // namespace hsp
