// Published radii by element. This is chemistry, which lib knows nothing of.
#pragma once

#include <cstdint>

namespace hsp {

enum class RadiiSet : uint32_t { bondi = 0, chem3d = 1, uff = 4 };

// The largest atomic number; the least is 1.
inline constexpr uint32_t element_count = 118;

struct ElementRadius {
  double radius;  // angstrom
  bool fallback;  // the set's source has none: the radius of RadiiSet::bondi if that has one, else 2.00
};

ElementRadius element_radius(RadiiSet set, uint32_t atomic_number);

}  // namespace hsp
