// The parts of a free arc as settled_circles.hpp decides it: parts of the side, or creases with several vertices at one
// position.
#pragma once

#include "surface/settled_circles.hpp"

namespace hsp {

class ArcParts {
 public:
  struct Part {
    uint32_t across;  // as PatchArc has it
    double angle;
  };
  static constexpr uint32_t most = 8;

  explicit ArcParts(const SettledCircles &circles)
      : circles_(circles), patches_(circles.patches()), probe_(patches_.probe()) {}

  // Returns how many parts there are, in the order of the arc.
  uint32_t find(const RegionArc &arc, Span<const RegionCorner> corners, Part (&parts)[most]) const;

 private:
  uint32_t find_on_side(const RegionArc &arc, Span<const RegionCorner> corners, Part (&parts)[most]) const;
  uint32_t owner_of_end(uint32_t cap, const RegionCorner &end) const;

  const SettledCircles &circles_;
  const CoincidentPatches &patches_;
  const ProbeCaps &probe_;
};

}  // namespace hsp
