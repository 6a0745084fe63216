#include "sphere/near_balls.hpp"

#if HSP_AVX2
#include "lanes/words.hpp"

namespace hsp {
namespace {

constexpr double roundoff = 0x1p-53;

// One ball against four others, by the operations of caps.cpp: no product is fused.
struct FourDistances {
  Doubles dx, dy, dz, sum, squared;

  FourDistances(const Doubles (&own)[4], Doubles x, Doubles y, Doubles z, Doubles r)
      : dx(x - own[0]), dy(y - own[1]), dz(z - own[2]), sum(r + own[3]), squared(dx * dx + dy * dy + dz * dz) {}
};

}  // namespace

uint32_t near_balls(const BallArrays &balls, uint32_t i, uint32_t &first, uint32_t last, uint32_t *near,
                    uint32_t room) {
  const Doubles own[4] = {Doubles::all_of(balls.x + i), Doubles::all_of(balls.y + i), Doubles::all_of(balls.z + i),
                          Doubles::all_of(balls.r + i)};
  const Doubles above = Doubles::all(1.0 + 8 * roundoff);
  uint32_t found = 0;
  uint32_t j = first;
  const auto add = [&](const FourDistances &d, LaneBits valid) {
    const LaneBits chosen = valid & not_less(d.sum * d.sum * above, d.squared);
    store_front(near + found, Integers::ascending() + Integers::all(j), FrontOrder::of_eight(chosen));
    found += ones(chosen);
  };
  for (; j + 4 <= last && found + 4 <= room; j += 4) {
    add({own, Doubles::load(balls.x + j), Doubles::load(balls.y + j), Doubles::load(balls.z + j),
         Doubles::load(balls.r + j)},
        15U);
  }
  if (j < last && last - j < 4 && found + 4 <= room) {
    const uint32_t rest = last - j;
    add({own, Doubles::load_first(balls.x + j, rest), Doubles::load_first(balls.y + j, rest),
         Doubles::load_first(balls.z + j, rest), Doubles::load_first(balls.r + j, rest)},
        first_lanes(rest));
    j = last;
  }
  first = j;
  return found;
}

uint32_t caps_of_circles(const BallArrays &balls, uint32_t i, const uint32_t *near, uint32_t count,
                         const CapArrays &caps, double &length_squared) {
  const Doubles own[4] = {Doubles::all_of(balls.x + i), Doubles::all_of(balls.y + i), Doubles::all_of(balls.z + i),
                          Doubles::all_of(balls.r + i)};
  const Doubles above = Doubles::all(1.0 + 8 * roundoff);
  const Doubles below = Doubles::all(1.0 - 8 * roundoff);
  const Doubles inverse_diameter = Doubles::all(0.5 / balls.r[i]);
  Doubles longest = Doubles::all(length_squared);
  uint32_t k = 0;
  for (; k < count; k += 4) {
    const uint32_t *const ids = near + k;
    const Doubles r = Doubles::at(balls.r, ids);
    const FourDistances d(own, Doubles::at(balls.x, ids), Doubles::at(balls.y, ids), Doubles::at(balls.z, ids), r);
    const Doubles difference = r - own[3];
    const LaneBits circles =
        greater(d.sum * d.sum * below, d.squared) & greater(d.squared, difference * difference * above);
    const LaneBits valid = first_lanes(count - k) & 15U;
    if ((circles & valid) != valid) break;

    const LongIntegers x = LongIntegers::from(d.dx), y = LongIntegers::from(d.dy), z = LongIntegers::from(d.dz);
    const LongIntegers U = product(x, x) + product(y, y) + product(z, z);
    const LongIntegers h = U - product(LongIntegers::from(difference), LongIntegers::from(d.sum));
    const Doubles length_2 = to_doubles(U);
    const Doubles inverse = Doubles::all(1.0) / square_root(length_2);
    longest = larger(longest, length_2);
    (d.dx * inverse).store(caps.ux + k);
    (d.dy * inverse).store(caps.uy + k);
    (d.dz * inverse).store(caps.uz + k);
    (to_doubles(h) * inverse * inverse_diameter).store(caps.b + k);
    for (uint32_t lane = 0; lane < 4; ++lane) caps.ball[k + lane] = ids[lane];
  }
  double lengths[4];
  longest.store(lengths);
  for (const double length : lengths) length_squared = length > length_squared ? length : length_squared;
  return k < count ? k : count;
}

}  // namespace hsp
#endif
