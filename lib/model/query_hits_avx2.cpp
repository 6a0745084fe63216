// Balls eight at a time, and their indices in order without branches on them; for AVX2.
#if HSP_AVX2
#include "model/query_hits.hpp"

#include "core/avx2_lanes.hpp"

namespace hsp {
namespace {

// Which of four balls meet the query, and of which that is not certain.
struct Verdict {
  LaneBits meet, doubtful;
};

struct WideQuery {
  Doubles x, y, z, r;

  Verdict test(const QueryArrays &balls, size_t j) const {
    const Doubles dx = x - Doubles::load(balls.x + j);
    const Doubles dy = y - Doubles::load(balls.y + j);
    const Doubles dz = z - Doubles::load(balls.z + j);
    const Doubles sum = r + Doubles::load(balls.r + j);
    const Doubles within = sum * sum;
    const Doubles excess = fused(dz, dz, fused(dy, dy, fused_minus(dx, dx, within)));
    return {negative(excess), not_less(within * Doubles::all(meeting_doubt), magnitude(excess))};
  }
};

// Of the eight balls from j on. Apart, so that the loop above it needs no room for what this leaves untouched.
[[gnu::noinline]] LaneBits decided(const QueryArrays &balls, const QueryBall &query, uint32_t j, LaneBits doubtful,
                                   LaneBits meet) {
  for (; doubtful != 0; doubtful &= doubtful - 1) {
    const uint32_t lane = lowest(doubtful), k = j + lane;
    const bool meets =
        meet_exactly(balls.x[k] - query.x, balls.y[k] - query.y, balls.z[k] - query.z, balls.r[k] + query.r);
    meet = (meet & ~(1U << lane)) | static_cast<LaneBits>(meets) << lane;
  }
  return meet;
}

// Compares each lane with that at the place given by `partners`; the lanes of `takes_larger` keep the larger one.
template <int takes_larger>
inline Integers exchange(Integers a, Integers partners) {
  return {_mm256_blend_epi32(_mm256_min_epu32(a.v, partners.v), _mm256_max_epu32(a.v, partners.v), takes_larger)};
}
inline Integers with_next(Integers a) {  // 1 0 3 2 5 4 7 6
  return {_mm256_shuffle_epi32(a.v, 0xB1)};
}
inline Integers with_second_next(Integers a) {  // 2 3 0 1 6 7 4 5
  return {_mm256_shuffle_epi32(a.v, 0x4E)};
}
inline Integers with_fourth_next(Integers a) {  // 4 5 6 7 0 1 2 3
  return {_mm256_permute4x64_epi64(a.v, 0x4E)};
}
inline Integers reversed_fours(Integers a) {  // 3 2 1 0 7 6 5 4
  return {_mm256_shuffle_epi32(a.v, 0x1B)};
}
inline Integers reversed(Integers a) {  // 7 6 5 4 3 2 1 0
  return reversed_fours(with_fourth_next(a));
}

// Batcher's bitonic sorter (Knuth, TAOCP 3, section 5.3.4).
inline Integers sorted_halves(Integers a) {  // of eight lanes whose halves of four are bitonic
  a = exchange<0xCC>(a, with_second_next(a));
  return exchange<0xAA>(a, with_next(a));
}
inline Integers sorted_bitonic(Integers a) {
  return sorted_halves(exchange<0xF0>(a, with_fourth_next(a)));
}
inline Integers sorted(Integers a) {
  a = exchange<0xAA>(a, with_next(a));
  a = exchange<0xCC>(a, reversed_fours(a));
  a = exchange<0xAA>(a, with_next(a));
  return sorted_halves(exchange<0xF0>(a, reversed(a)));
}

// The first `count` ids of eight; larger than all others in the lanes beyond.
inline Integers load_ids(const uint32_t *ids, uint32_t count) {
  const Integers beyond = {_mm256_cmpgt_epi32(Integers::ascending().v, Integers::all(count - 1).v)};
  return {_mm256_or_si256(Integers::load(ids).v, beyond.v)};
}
inline void store_ids(uint32_t *ids, Integers a, uint32_t count) {
  const __m256i wanted = _mm256_cmpgt_epi32(Integers::all(count).v, Integers::ascending().v);
  _mm256_maskstore_epi32(reinterpret_cast<int *>(ids), wanted, a.v);
}

// Two sorted halves of `half` eights each, a power of two, to one.
inline void merge(Integers *eights, uint32_t half) {
  const auto exchange_whole = [](Integers &a, Integers &b, Integers partner) {
    b = {_mm256_max_epu32(a.v, partner.v)};
    a = {_mm256_min_epu32(a.v, partner.v)};
  };
  // Smallest against largest, after which each half is bitonic. The upper half comes out in reversed order.
  Integers *const upper = eights + half;
  for (uint32_t k = 0; k < half; ++k) exchange_whole(eights[k], upper[half - 1 - k], reversed(upper[half - 1 - k]));
  for (uint32_t stride = half / 2; stride > 0; stride /= 2) {
    for (uint32_t first = 0; first < 2 * half; first += 2 * stride) {
      for (uint32_t k = first; k < first + stride; ++k)
        exchange_whole(eights[k], eights[k + stride], eights[k + stride]);
    }
  }
  for (uint32_t k = 0; k < 2 * half; ++k) eights[k] = sorted_bitonic(eights[k]);
}

}  // namespace

void add_hits_avx2(const QueryArrays &balls_at, const QueryBall &query, const BallRange *ranges, uint32_t count,
                   QueryHits &hits) {
  const QueryArrays balls = balls_at;  // in registers
  const WideQuery wide{Doubles::all(query.x), Doubles::all(query.y), Doubles::all(query.z), Doubles::all(query.r)};
  const Integers excluded = Integers::all(query.excluded);
  uint32_t found = hits.count;
  for (const BallRange *range = ranges; range < ranges + count; ++range) {
    uint32_t j = range->first;
    const uint32_t last = range->last;
    // Nearly always once: that is easier to predict than steps of four.
    do {
      const Verdict low = wide.test(balls, j), high = wide.test(balls, size_t{j} + 4);
      LaneBits meet = low.meet | high.meet << 4;
      const LaneBits valid = first_lanes(last - j);
      const LaneBits doubtful = (low.doubtful | high.doubtful << 4) & valid;
      if (doubtful != 0) [[unlikely]]
        meet = decided(balls, query, j, doubtful, meet);
      const Integers ids = Integers::load(balls.caller + j);
      meet &= valid & ~equal(ids, excluded);
      store_front(hits.ids + (found < QueryHits::room ? found : QueryHits::room), ids, FrontOrder::of_eight(meet));
      found += ones(meet);
      j += 8;
    } while (j < last);
  }
  hits.count = found;
}

void write_ascending_avx2(const QueryHits &hits, uint32_t *ids) {
  const uint32_t count = hits.count;
  if (count <= 8) {
    store_ids(ids, sorted(load_ids(hits.ids, count)), count);
    return;
  }
  // A power of two of eights, sorted each, then merged two by two.
  Integers eights[QueryHits::room / 8];
  uint32_t used = 0;
  for (; 8 * used < count; ++used) {
    eights[used] = sorted(load_ids(hits.ids + 8 * used, count - 8 * used));
  }
  uint32_t all = used;
  for (; (all & (all - 1)) != 0; ++all) eights[all] = Integers::all(UINT32_MAX);
  for (uint32_t half = 1; half < all; half *= 2) {
    for (uint32_t first = 0; first < all; first += 2 * half) merge(eights + first, half);
  }
  for (uint32_t k = 0; k + 1 < used; ++k) eights[k].store(ids + 8 * k);
  store_ids(ids + 8 * (used - 1), eights[used - 1], count - 8 * (used - 1));
}

}  // namespace hsp
#endif
