#include "sphere/root_discriminants.hpp"

#if HSP_AVX2
#include "core/avx2_lanes.hpp"

namespace hsp {
namespace {

// Numbers that are the sum of two doubles.
struct Twofold {
  Doubles high, low;
};

// a + b, exact in any order of size.
Twofold exact_sum(Doubles a, Doubles b) {
  const Doubles sum = a + b;
  const Doubles of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

Twofold exact_square(Doubles a) {
  const Doubles high = a * a;
  return {high, fused_minus(a, a, high)};
}

// Without the square of the second part.
Twofold square(const Twofold &a) {
  const Twofold of_high = exact_square(a.high);
  return {of_high.high, fused(a.high + a.high, a.low, of_high.low)};
}

Twofold product(const Twofold &a, Doubles b) {
  const Doubles high = a.high * b;
  return {high, fused(a.low, b, fused_minus(a.high, b, high))};
}

Twofold difference(const Twofold &a, const Twofold &b) {
  const Twofold sum = exact_sum(a.high, -b.high);
  return {sum.high, sum.low + (a.low - b.low)};
}

Twofold sum_of_squares(const Twofold &a, const Twofold &b, const Twofold &c) {
  const Twofold x = square(a), y = square(b), z = square(c);
  const Twofold two = exact_sum(x.high, y.high);
  const Twofold three = exact_sum(two.high, z.high);
  return {three.high, (two.low + three.low) + (x.low + y.low + z.low)};
}

Twofold from(LongIntegers a) {
  Twofold result{};
  result.high = to_doubles(a, result.low);
  return result;
}

// The plane of one other ball, as plane_of in exact/plane.hpp.
struct LanePlanes {
  Doubles x, y, z;
  LongIntegers ix, iy, iz;
  Twofold h;
  Doubles squared;  // |v|^2, rounded

  LanePlanes(const BallArrays &balls, const Doubles (&own)[4], const uint32_t *vertices, uint32_t slot) {
    const uint32_t id[4] = {vertices[slot], vertices[4 + slot], vertices[8 + slot], vertices[12 + slot]};
    x = Doubles::at(balls.x, id) - own[0];
    y = Doubles::at(balls.y, id) - own[1];
    z = Doubles::at(balls.z, id) - own[2];
    const Doubles r = Doubles::at(balls.r, id);
    ix = LongIntegers::from(x);
    iy = LongIntegers::from(y);
    iz = LongIntegers::from(z);
    const LongIntegers U = hsp::product(ix, ix) + hsp::product(iy, iy) + hsp::product(iz, iz);
    h = from(U - hsp::product(LongIntegers::from(r - own[3]), LongIntegers::from(r + own[3])));
    squared = x * x + y * y + z * z;
  }
};

Twofold difference_of_products(const Twofold &a, Doubles b, const Twofold &c, Doubles d) {
  return difference(product(a, b), product(c, d));
}

// sqrt(D) of four vertices, in lanes where that is certain.
LaneBits find_roots(const BallArrays &balls, const uint32_t *vertices, double *roots) {
  const uint32_t id[4] = {vertices[0], vertices[4], vertices[8], vertices[12]};
  const Doubles own[4] = {Doubles::at(balls.x, id), Doubles::at(balls.y, id), Doubles::at(balls.z, id),
                          Doubles::at(balls.r, id)};
  const LanePlanes p(balls, own, vertices, 1), q(balls, own, vertices, 2);
  const Twofold nn = sum_of_squares(from(hsp::product(p.iy, q.iz) - hsp::product(p.iz, q.iy)),
                                    from(hsp::product(p.iz, q.ix) - hsp::product(p.ix, q.iz)),
                                    from(hsp::product(p.ix, q.iy) - hsp::product(p.iy, q.ix)));
  const Twofold qq =
      sum_of_squares(difference_of_products(p.h, q.x, q.h, p.x), difference_of_products(p.h, q.y, q.h, p.y),
                     difference_of_products(p.h, q.z, q.h, p.z));
  const Twofold W = exact_square(own[3] + own[3]);
  const Twofold Wnn_high = product(nn, W.high);
  const Twofold Wnn{Wnn_high.high, fused(nn.high, W.low, Wnn_high.low)};
  const Twofold D = difference(Wnn, qq);
  const Twofold rounded = exact_sum(D.high, D.low);
  const Doubles error = Doubles::all(0x1p-96) * W.high * (p.squared * q.squared);
  const Doubles above = rounded.high + (rounded.low + error), below = rounded.high + (rounded.low - error);
  const LaneBits certain = not_less(below, above) & greater(rounded.high, Doubles::all(0.0));
  square_root(rounded.high).store(roots);
  return certain;
}

}  // namespace

bool find_roots_in_lanes(const BallArrays &balls, const uint32_t *vertices, uint32_t count, double *roots,
                         uint32_t &done) {
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

}  // namespace hsp
#endif
