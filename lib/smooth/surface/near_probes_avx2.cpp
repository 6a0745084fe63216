#if HSP_AVX2
#include "surface/near_probes.hpp"

#include "lanes/avx2_lanes.hpp"

namespace hsp {
namespace {

struct FloatVectors {
  Floats x, y, z;

  Floats along(const float (&direction)[3]) const {
    return fused(x, Floats::all_of(direction),
                 fused(y, Floats::all_of(direction + 1), z * Floats::all_of(direction + 2)));
  }
};

// The lanes that may cut the triangle.
inline LaneBits may_cut(const ProbeSearch &search, const FloatVectors &q) {
  const Floats square = fused(q.x, q.x, fused(q.y, q.y, q.z * q.z));
  const Floats margin = Floats::all(search.margin), below = -margin;
  const Floats ratio = square * Floats::all(search.inverse_square_of_reach);
  const Floats reach = fused(square, Floats::all(1.0F) - ratio, Floats::all(8 * search.margin));
  const Floats height[3] = {q.along(search.inward[0]), q.along(search.inward[1]), q.along(search.inward[2])};
  const Floats along[3] = {q.along(search.corner[0]), q.along(search.corner[1]), q.along(search.corner[2])};
  LaneBits cut = greater(height[0], below) & greater(height[1], below) & greater(height[2], below);
  const Floats before = below + below;
  for (int k = 0; k < 3; ++k) {
    const Floats a = along[(k + 1) % 3], b = along[(k + 2) % 3], cosine = Floats::all_of(search.cosine + k);
    cut |= greater(margin, height[k]) & greater(reach, height[k] * height[k]) &
           greater(minus_fused(cosine, a, b), before) & greater(minus_fused(cosine, b, a), before);
  }
  return cut;
}

}  // namespace

// Those that overlap are put side by side first.
uint32_t find_near_probes_avx2(ProbeSearch &search, uint32_t *found) {
  constexpr uint32_t room = ProbeSearch::room;
  alignas(32) float x[room + 8], y[room + 8], z[room + 8];
  alignas(32) uint32_t near[room + 8];
  const Floats own_x = Floats::all(search.own[0]), own_y = Floats::all(search.own[1]),
               own_z = Floats::all(search.own[2]), reach = Floats::all(search.square_of_reach);
  uint32_t count = 0;
  uint32_t at = search.at;
  for (; at < search.ranges; ++at) {
    uint32_t k = search.range[at].first;
    const uint32_t last = search.range[at].last;
    for (; k < last && count <= room - 8; k += 8) {
      const Floats dx = Floats::load(search.x + k) - own_x, dy = Floats::load(search.y + k) - own_y,
                   dz = Floats::load(search.z + k) - own_z;
      const LaneBits overlap = greater(reach, fused(dx, dx, fused(dy, dy, dz * dz))) & first_lanes(last - k);
      const FrontOrder order = FrontOrder::of_eight(overlap);
      store_front(x + count, dx, order);
      store_front(y + count, dy, order);
      store_front(z + count, dz, order);
      store_front(near + count, Integers::load(search.vertex + k), order);
      count += ones(overlap);
    }
    search.range[at].first = k;
    if (k < last) break;
  }
  search.at = at;
  uint32_t kept = 0;
  for (uint32_t k = 0; k < count; k += 8) {
    const LaneBits cut = may_cut(search, {Floats::load(x + k), Floats::load(y + k), Floats::load(z + k)});
    const LaneBits there = cut & first_lanes(count - k);
    store_front(found + kept, Integers::load(near + k), FrontOrder::of_eight(there));
    kept += ones(there);
  }
  return kept;
}

}  // namespace hsp
#endif
