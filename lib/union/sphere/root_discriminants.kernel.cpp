#include "sphere/root_discriminants.hpp"

#include "sphere/lane_planes.hpp"

namespace hsp::HSP_TARGET {
namespace {

// |v|^2, rounded.
FourDoubles squared(const LanePlanes &plane) {
  return plane.x * plane.x + plane.y * plane.y + plane.z * plane.z;
}

// sqrt(D) of four vertices, in lanes where that is certain.
LaneBits find_roots(const BallArrays &balls, const uint32_t *vertices, double *roots) {
  const auto balls_of = [&](uint32_t slot) {
    const uint32_t ids[4] = {vertices[slot], vertices[4 + slot], vertices[8 + slot], vertices[12 + slot]};
    return LaneBalls(balls, ids);
  };
  const LaneBalls own = balls_of(0);
  const LanePlanes p(own, balls_of(1)), q(own, balls_of(2));
  const LaneNormals n(p.v, q.v);
  const Twofold nn = sum_of_squares(n.x, n.y, n.z);
  const Twofold ph = from(p.h), qh = from(q.h);
  const Twofold qq = sum_of_squares(difference_of_products(ph, q.x, qh, p.x), difference_of_products(ph, q.y, qh, p.y),
                                    difference_of_products(ph, q.z, qh, p.z));
  const Twofold W = exact_square(own.r + own.r);
  const Twofold Wnn_high = product(nn, W.high);
  const Twofold Wnn{Wnn_high.high, Four::fused(nn.high, W.low, Wnn_high.low)};
  const FourDoubles error = Four::all(0x1p-96) * W.high * (squared(p) * squared(q));
  Twofold D{};
  const LaneBits certain = rounded_within(difference(Wnn, qq), error, D) & lanes_where(D.high > Four::all(0.0));
  Four::store(roots, Four::square_root(D.high));
  return certain;
}

}  // namespace

bool find_roots_in_lanes(const BallArrays &balls, const uint32_t *vertices, uint32_t count, double *roots,
                         uint32_t &done) {
  done = 0;
  if constexpr (!has_twofold) return true;
  LaneBits all = 15U;
  uint32_t v = 0;
  for (; v + 4 <= count; v += 4) {
    const LaneBits certain = find_roots(balls, vertices + 4 * static_cast<uint64_t>(v), roots + v);
    all &= certain;
    if (certain == 15U) [[likely]]
      continue;
    for (uint32_t lane = 0; lane < 4; ++lane) {
      if ((certain >> lane & 1U) == 0) roots[v + lane] = doubtful_root;
    }
  }
  done = v;
  return all == 15U;
}

}  // namespace hsp::HSP_TARGET
