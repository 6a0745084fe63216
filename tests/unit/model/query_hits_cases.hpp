// Hits among ranges of balls, and their order, for every way in which the library finds them.
#pragma once

#include "cases.hpp"
#include "core/status.hpp"
#include "model/query_hits.hpp"

namespace cases {

using AddHits = void(const hsp::QueryArrays &, const hsp::QueryBall &, const hsp::BallRange *, uint32_t,
                     hsp::QueryHits &);
// To where there is room for as many ids as the last argument says.
using WriteAscending = void(const hsp::QueryHits &, uint32_t *, uint32_t);
inline void write_plainly(const hsp::QueryHits &hits, uint32_t *ids, uint32_t) {
  write_ascending(hits, ids);
}

// Balls on a small lattice, where many of them touch a query exactly; in memory with something behind.
struct LatticeBalls {
  static constexpr uint32_t most = 300;
  double x[most + 7], y[most + 7], z[most + 7], r[most + 7];
  uint32_t caller[most + 7];

  // Multiples of the scale, moved by a constant along x. The numbers after the balls would be hits.
  void fill(Random &random, int64_t extent, int64_t scale, int64_t moved) {
    for (uint32_t j = 0; j < most + 7; ++j) {
      const bool behind = j >= most;
      x[j] = static_cast<double>(behind ? moved : scale * random.in(-extent, extent) + moved);
      y[j] = static_cast<double>(behind ? 0 : scale * random.in(-extent, extent));
      z[j] = static_cast<double>(behind ? 0 : scale * random.in(-extent, extent));
      r[j] = static_cast<double>(behind ? scale * 99 : scale * random.in(0, 4));
      caller[j] = (j * 7 + 3) % most;
    }
  }
  hsp::QueryArrays arrays() const { return {x, y, z, r, caller}; }
};

// Hit by hit in integers, for numbers of few digits.
inline bool lattice_balls_meet(const LatticeBalls &balls, uint32_t j, const hsp::QueryBall &query, int64_t scale) {
  const auto steps = [scale](double length) { return static_cast<int64_t>(length) / scale; };
  const int64_t dx = steps(balls.x[j] - query.x), dy = steps(balls.y[j] - query.y), dz = steps(balls.z[j] - query.z);
  const int64_t reach = steps(balls.r[j]) + steps(query.r);
  return dx * dx + dy * dy + dz * dz <= reach * reach;
}

// Ranges of all lengths up to 20 and of none, few hits and more than there is room for, one ball excluded or none.
template <AddHits add>
uint32_t hits_are_found() {
  static LatticeBalls balls;
  static hsp::QueryHits hits;
  Random random(11);
  uint32_t beyond_room = 0, touching = 0;
  for (uint32_t round = 0; round < 3000; ++round) {
    const int64_t scale = round % 3 == 0 ? 1 : INT64_C(1) << (round % 29);
    const int64_t extent = random.in(1, 12);
    const int64_t moved = round % 5 == 0 ? (INT64_C(1) << 49) : 0;
    balls.fill(random, extent, scale, moved);
    const hsp::QueryBall query{static_cast<double>(scale * random.in(-extent, extent) + moved),
                               static_cast<double>(scale * random.in(-extent, extent)),
                               static_cast<double>(scale * random.in(-extent, extent)),
                               static_cast<double>(scale * (round % 7 == 0 ? 40 : random.in(0, 4))),
                               round % 2 == 0 ? hsp::no_id : random.below(LatticeBalls::most)};
    hsp::BallRange ranges[24];
    uint32_t count = 0;
    for (uint32_t first = random.below(5); count < 24 && first < LatticeBalls::most; ++count) {
      const uint32_t length = random.below(21), left = LatticeBalls::most - first;
      ranges[count] = {first, first + (length < left ? length : left)};
      first = ranges[count].last + random.below(3);
    }
    hits.count = 0;
    add(balls.arrays(), query, ranges, count, hits);
    uint32_t expected = 0;
    for (uint32_t k = 0; k < count; ++k) {
      for (uint32_t j = ranges[k].first; j < ranges[k].last; ++j) {
        if (balls.caller[j] == query.excluded || !lattice_balls_meet(balls, j, query, scale)) continue;
        if (expected < hsp::QueryHits::room && hits.ids[expected] != balls.caller[j]) return round;
        ++expected;
        touching += static_cast<uint32_t>(!hsp::meet(balls.x[j] - query.x, balls.y[j] - query.y, balls.z[j] - query.z,
                                                     (balls.r[j] + query.r) * (1 - 0x1p-40)));
      }
    }
    if (hits.count != expected) return round;
    beyond_room += static_cast<uint32_t>(expected > hsp::QueryHits::room);
  }
  return beyond_room > 50 && touching > 1000 ? all_hold : 3000;
}

// Squares that doubles cannot tell apart, in every lane.
template <AddHits add>
uint32_t near_ties_are_decided() {
  static LatticeBalls balls;
  static hsp::QueryHits hits;
  Random random(12);
  balls.fill(random, 0, 1, 0);
  for (uint32_t lane = 0; lane < 16; ++lane) {
    for (const int64_t beside : {0, 1}) {
      for (uint32_t j = 0; j < 16; ++j) balls.x[j] = 5e9, balls.y[j] = 0, balls.r[j] = 1e9;
      balls.x[lane] = 2e9;
      balls.y[lane] = static_cast<double>(beside);
      const hsp::BallRange range{0, 13};
      hits.count = 0;
      add(balls.arrays(), {0, 0, 0, 1e9, hsp::no_id}, &range, 1, hits);
      const bool hit = beside == 0 && lane < 13;
      if (hits.count != static_cast<uint32_t>(hit) || (hit && hits.ids[0] != balls.caller[lane])) return lane;
    }
  }
  return all_hold;
}

// Ascending, as many as there are, and nothing beside them.
template <WriteAscending write>
uint32_t hits_are_ordered() {
  static hsp::QueryHits hits;
  constexpr uint32_t untouched = 4444;
  Random random(13);
  for (uint32_t count = 0; count <= hsp::QueryHits::room; ++count) {
    for (uint32_t round = 0; round < 20; ++round) {
      // Distinct numbers in every order, side by side or far apart; also the largest one that a ball can have.
      for (uint32_t &id : hits.ids) id = round % 3 == 0 ? UINT32_MAX : 7;
      const uint32_t gap = round < 10 ? 1 : UINT32_C(1) << (round - 8);
      uint32_t next = round < 10 ? 0 : random.below(4096);
      for (uint32_t k = 0; k < count; ++k, next += 1 + random.below(gap)) {
        hits.ids[k] = round % 2 == 0 ? UINT32_C(0x0FFFFFFF) - 3 * next : next;
      }
      for (uint32_t k = count; k > 1; --k) {
        const uint32_t other = random.below(k), id = hits.ids[k - 1];
        hits.ids[k - 1] = hits.ids[other];
        hits.ids[other] = id;
      }
      hits.count = count;
      uint32_t sum = 0, sum_written = 0;
      // No more room than is said: a sanitizer would see what is read or written behind it.
      uint32_t all_ids[hsp::QueryHits::room + 9];
      for (uint32_t &id : all_ids) id = untouched;
      const uint32_t room = count + round % 10;
      uint32_t *const ids = all_ids + hsp::QueryHits::room + 9 - room;
      write(hits, ids, room);
      for (uint32_t k = 0; k < count; ++k) {
        sum += hits.ids[k];
        sum_written += ids[k];
        if (k > 0 && ids[k - 1] > ids[k]) return count;
      }
      if (sum != sum_written) return count;
      for (uint32_t *id = all_ids; id < all_ids + hsp::QueryHits::room + 9; ++id) {
        if ((id < ids || id >= ids + count) && *id != untouched) return count;
      }
    }
  }
  return all_hold;
}

inline constexpr Check model_query_hits[] = {{"hits_are_found", hits_are_found<hsp::add_hits>},
                                             {"near_ties_are_decided", near_ties_are_decided<hsp::add_hits>},
                                             {"hits_are_ordered", hits_are_ordered<write_plainly>}};

}  // namespace cases
