// Whether a crease is equally long in both of the concave patches that it bounds, up to what is known of its ends.
// Each patch has found them on its own: where they are not the same the surface is not closed there, whatever joints
// it has.
#pragma once

#include "boundary/boundary.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {

class CreaseLengths {
 public:
  CreaseLengths(const BallSet &balls, const Boundary &boundary, const CutPatches &cut)
      : balls_(balls),
        boundary_(boundary),
        cut_(cut),
        probe_(static_cast<double>(balls.probe_steps)),
        length_(static_cast<double>(balls.largest_radius)) {}

  // Up to rounding, of lengths in units of the largest radius.
  static constexpr double tolerance = 1e-6;
  // Angles of the two arcs that differ by no more need no closer look: no crease is larger than the probe, nor the
  // probe than the largest radius.
  static bool may_differ(const PatchArc &arc, const PatchArc &twin) {
    const double off = arc.angle - twin.angle;
    return !(off <= tolerance && -off <= tolerance);
  }

  // Of an arc that is a crease with a twin.
  bool agree(uint32_t arc) const;
  // By how much the length of a crease may differ in its two patches, in lattice steps.
  double uncertainty(uint32_t arc) const { return uncertainty_of_ends(arc) + uncertainty_of_ends(cut_.arc(arc).twin); }

 private:
  // A circle on the unit sphere about a vertex, that an arc of a cut patch lies on; and how far off it may be.
  struct ArcCircle {
    Vec3 axis;
    double height, error;
  };
  uint32_t vertex_of(uint32_t arc) const { return cut_.piece(cut_.piece_of_arc(arc)).vertex; }
  ArcCircle circle_of(uint32_t vertex, const PatchArc &arc) const;
  double uncertainty_of_ends(uint32_t arc) const;
  Vec3 centre_of(uint32_t ball) const;
  Vec3 offset_of(uint32_t vertex) const;

  const BallSet &balls_;
  const Boundary &boundary_;
  const CutPatches &cut_;
  const double probe_, length_;
};

}  // namespace hsp
