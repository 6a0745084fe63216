#include "surface/near_probes.hpp"
#include "surface/front.hpp"

namespace hsp::HSP_TARGET {
namespace {

using L = Wide<float, register_floats>;

// Vectors from this vertex to others.
struct ProbeDifferences {
  L::Real x, y, z;

  L::Real along(const float (&direction)[3]) const {
    return L::fused(x, L::all(direction[0]), L::fused(y, L::all(direction[1]), z * L::all(direction[2])));
  }
  L::Real squared() const { return L::fused(x, x, L::fused(y, y, z * z)); }
};

// The lanes that may cut the triangle.
uint32_t may_cut(const ProbeSearch &search, const ProbeDifferences &q) {
  using Real = L::Real;
  const Real square = q.squared();
  const Real margin = L::all(search.margin), below = L::all(-search.margin), before = below + below;
  const Real ratio = square * L::all(search.inverse_square_of_reach);
  const Real reach = L::fused(square, L::all(1.0F) - ratio, L::all(8 * search.margin));
  const Real height[3] = {q.along(search.inward[0]), q.along(search.inward[1]), q.along(search.inward[2])};
  const Real along[3] = {q.along(search.corner[0]), q.along(search.corner[1]), q.along(search.corner[2])};
  uint64_t cut = L::set_lanes(L::both(L::both(height[0] > below, height[1] > below), height[2] > below));
  for (int k = 0; k < 3; ++k) {
    const Real a = along[(k + 1) % 3], b = along[(k + 2) % 3], minus_cosine = L::all(-search.cosine[k]);
    cut |= L::set_lanes(L::both(L::both(height[k] < margin, height[k] * height[k] < reach),
                                L::both(L::fused(minus_cosine, a, b) > before, L::fused(minus_cosine, b, a) > before)));
  }
  return static_cast<uint32_t>(cut);
}

}  // namespace

// Probes that overlap are gathered side by side first, without branches, which could not be predicted.
uint32_t find_near_probes(ProbeSearch &search, uint32_t *found) {
  constexpr uint32_t n = L::lanes, room = ProbeSearch::room;
  alignas(32) float x[room + n], y[room + n], z[room + n];
  alignas(32) uint32_t near[room + n];
  const L::Real own_x = L::all(search.own[0]), own_y = L::all(search.own[1]), own_z = L::all(search.own[2]),
                reach = L::all(search.square_of_reach);
  uint32_t count = 0;
  uint32_t at = search.at;
  for (; at < search.ranges; ++at) {
    uint32_t k = search.range[at].first;
    const uint32_t last = search.range[at].last;
    for (; k < last && count <= room - n; k += n) {
      const ProbeDifferences q{L::load(search.x + k) - own_x, L::load(search.y + k) - own_y,
                               L::load(search.z + k) - own_z};
      const Front<n> overlap(static_cast<uint32_t>(L::set_lanes(q.squared() < reach)) & first_of<n>(last - k));
      overlap.store(x + count, q.x);
      overlap.store(y + count, q.y);
      overlap.store(z + count, q.z);
      overlap.copy(near + count, search.vertex + k);
      count += overlap.count();
    }
    search.range[at].first = k;
    if (k < last) break;
  }
  search.at = at;
  uint32_t kept = 0;
  for (uint32_t k = 0; k < count; k += n) {
    const Front<n> cut(may_cut(search, {L::load(x + k), L::load(y + k), L::load(z + k)}) & first_of<n>(count - k));
    cut.copy(found + kept, near + k);
    kept += cut.count();
  }
  return kept;
}

}  // namespace hsp::HSP_TARGET
