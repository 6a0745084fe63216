#include "sphere/near_balls.hpp"

#include "lanes/four_doubles.hpp"
#include "model/meeting.hpp"

namespace hsp::HSP_TARGET {
namespace {

// One ball against four others, by the operations of caps.cpp: no product is fused.
struct FourDistances {
  FourDoubles dx, dy, dz, sum, squared;

  FourDistances(const FourDoubles (&own)[4], FourDoubles x, FourDoubles y, FourDoubles z, FourDoubles r)
      : dx(x - own[0]), dy(y - own[1]), dz(z - own[2]), sum(r + own[3]), squared(dx * dx + dy * dy + dz * dz) {}
};

}  // namespace

uint32_t near_balls(const BallArrays &balls, uint32_t i, uint32_t &first, uint32_t last, uint32_t *near,
                    uint32_t room) {
  const FourDoubles own[4] = {Four::all(balls.x[i]), Four::all(balls.y[i]), Four::all(balls.z[i]),
                              Four::all(balls.r[i])};
  const FourDoubles above = Four::all(certainly_above);
  uint32_t found = 0;
  uint32_t j = first;
  const auto add = [&](const FourDistances &d, LaneBits valid) {
    const LaneBits chosen = valid & lanes_where(d.sum * d.sum * above >= d.squared);
    store_front(near + found, Integers::ascending() + Integers::all(j), FrontOrder::of(chosen));
    found += ones(chosen);
  };
  for (; j + 4 <= last && found + 4 <= room; j += 4) {
    add({own, Four::load(balls.x + j), Four::load(balls.y + j), Four::load(balls.z + j), Four::load(balls.r + j)}, 15U);
  }
  if (j < last && last - j < 4 && found + 4 <= room) {
    const uint32_t rest = last - j;
    add({own, Four::load_first(balls.x + j, rest), Four::load_first(balls.y + j, rest),
         Four::load_first(balls.z + j, rest), Four::load_first(balls.r + j, rest)},
        first_lanes(rest));
    j = last;
  }
  first = j;
  return found;
}

uint32_t caps_of_circles(const BallArrays &balls, uint32_t i, const uint32_t *near, uint32_t count,
                         const CapArrays &caps, double &length_squared) {
  const FourDoubles own[4] = {Four::all(balls.x[i]), Four::all(balls.y[i]), Four::all(balls.z[i]),
                              Four::all(balls.r[i])};
  const FourDoubles above = Four::all(certainly_above), below = Four::all(certainly_below);
  const FourDoubles inverse_diameter = Four::all(0.5 / balls.r[i]);
  FourDoubles longest = Four::all(length_squared);
  uint32_t k = 0;
  for (; k < count; k += 4) {
    const uint32_t *const ids = near + k;
    const FourDoubles r = Four::gather(balls.r, ids);
    const FourDistances d(own, Four::gather(balls.x, ids), Four::gather(balls.y, ids), Four::gather(balls.z, ids), r);
    const FourDoubles difference = r - own[3];
    const LaneBits circles =
        lanes_where(d.sum * d.sum * below > d.squared) & lanes_where(d.squared > difference * difference * above);
    const LaneBits valid = first_lanes(count - k) & 15U;
    if ((circles & valid) != valid) break;

    const LongIntegers x = LongIntegers::from(d.dx), y = LongIntegers::from(d.dy), z = LongIntegers::from(d.dz);
    const LongIntegers U = product(x, x) + product(y, y) + product(z, z);
    const LongIntegers h = U - product(LongIntegers::from(difference), LongIntegers::from(d.sum));
    const FourDoubles length_2 = to_doubles(U);
    // The lanes behind the last ball hold the ball itself, at distance 0: 1 keeps them finite. Every other length is at
    // least 1, as it is the root of a positive integer.
    const FourDoubles one = Four::all(1.0), inverse = one / Four::square_root(Four::larger(length_2, one));
    longest = Four::larger(longest, length_2);
    Four::store(caps.ux + k, d.dx * inverse);
    Four::store(caps.uy + k, d.dy * inverse);
    Four::store(caps.uz + k, d.dz * inverse);
    Four::store(caps.b + k, to_doubles(h) * inverse * inverse_diameter);
    for (uint32_t lane = 0; lane < 4; ++lane) caps.ball[k + lane] = ids[lane];
  }
  double lengths[4];
  Four::store(lengths, longest);
  for (const double length : lengths) length_squared = length > length_squared ? length : length_squared;
  return k < count ? k : count;
}

}  // namespace hsp::HSP_TARGET
