// The balls of some ranges that meet a query ball: one at a time, or where registers hold several numbers as many as
// there are floats in one (lanes/words.hpp). Both decide alike.
#pragma once

#include <cmath>
#include <cstdint>

#include "lanes/target.hpp"
#include "model/ball_range.hpp"

namespace hsp {

// The arrays of a BallSet, which may be read seven entries after the last ball.
struct QueryArrays {
  const double *x, *y, *z, *r;
  const uint32_t *caller;
};

// A query ball on the lattice; its numbers are integers.
struct QueryBall {
  double x, y, z, r;
  uint32_t excluded;  // the caller's index of a ball that is no hit; or no_id
};

// The caller's indices of the balls that have been found, in any order. Beyond the room hits are counted, not stored.
struct QueryHits {
  static constexpr uint32_t room = 128;
  uint32_t ids[room + 8];  // and entries after them that may be overwritten
  uint32_t count;
};

// A set with a directory of rows (row_directory.hpp), for whole queries in lanes. Lengths in
// steps and numbers of cubes, as doubles; x, y, z and 0.
struct QueryGrid {
  const uint32_t *cells = nullptr;  // of the directory; null: there is none
  uint64_t row, layer;              // entries of one row, rows of one layer
  double low[4], size[4];           // the first cube, and how many there are
  double side, inverse_side, largest_radius;
  double factor = 0.0;  // of lengths, for steps; 0 without a directory, or if lengths are divided
  // The balls from the middle of the box, rounded to floats, x, y, z, r of each side by side: a query reads half as
  // much memory, and half as many numbers of eight balls at a time. May be read as far behind as QueryArrays.
  const float *rounded = nullptr;  // null: there are none
  double middle[4];                // an integer along each axis, and 0
  double extent;                   // from the middle along any axis no centre is further
};

// Sets whose extent is more than so many largest radii are not rounded (RoundedQuery of query_hits.kernel.cpp).
constexpr double most_extent_of_rounded = 0x1p18;

// How far the difference of squares can be wrong between a query of radius q and rounded balls. Let the reach be q +
// r_max, the extent H, u = 2^-24. A ball's coordinates are wrong by u H, those of a query that has rows to look at by u
// (H + reach), their difference by u of itself, and the sum of radii by 3 u reach. Up to a distance of 2 reach that
// comes to no more than u (14 H + 44 reach) reach, whether sums of products are fused or not. Further away the
// difference is above 3/5 of the distance squared, and that above the doubt, as long as H is no more than 2^18 reach.
static inline double rounded_doubt(double extent, double reach) {
  return 0x1p-24 * (16.0 * extent + 64.0 * reach) * reach;
}

// Balls meet if |c_j - c| <= r_j + r on the lattice. The differences and the sum are exact as doubles; the squares have
// a relative error below 5 units of 2^-53, fused or not, so that only near-ties need integers.
constexpr double meeting_doubt = 16 * 0x1p-53;

// From centre to centre, and the sum of the radii; by integers alone.
bool meet_exactly(double dx, double dy, double dz, double sum);

inline bool meet(double dx, double dy, double dz, double sum) {
  const double within = sum * sum;
  const double excess = (dx * dx + dy * dy + dz * dz) - within;
  // This branch is nearly always taken. The sign itself cannot be predicted, so there must be no branch on it.
  if (std::fabs(excess) > meeting_doubt * within) [[likely]]
    return excess < 0.0;
  return meet_exactly(dx, dy, dz, sum);
}

// Adds the hits among the balls of the ranges.
void add_hits(const QueryArrays &balls, const QueryBall &query, const BallRange *ranges, uint32_t count,
              QueryHits &hits);
HSP_KERNEL(void, add_hits_in_lanes,
           (const QueryArrays &balls, const QueryBall &query, const BallRange *ranges, uint32_t count, QueryHits &hits),
           (balls, query, ranges, count, hits))
// The balls that meet a ball in the caller's unit, as find_balls() of queries.hpp. False, and nothing is written, if
// the query is to be refused, or meets many rows of cubes or balls.
HSP_KERNEL(bool, find_balls_in_lanes,
           (const QueryGrid &grid, const QueryArrays &balls, const double *xyz, double radius, uint32_t *ids,
            uint32_t capacity, uint32_t &hits),
           (grid, balls, xyz, radius, ids, capacity, hits))
// The same for find_neighbours().
HSP_KERNEL(bool, find_neighbours_in_lanes,
           (const QueryGrid &grid, const QueryArrays &balls, uint32_t rank, uint32_t *ids, uint32_t capacity,
            uint32_t &hits),
           (grid, balls, rank, ids, capacity, hits))

void sort_ascending(uint32_t *ids, uint32_t count);
// Writes the hits, if there are no more than the room, in ascending order.
void write_ascending(const QueryHits &hits, uint32_t *ids);
// At ids[count ..] there may be more that is the caller's, `room` ids in all: it is read and written as it was.
HSP_KERNEL(void, write_ascending_in_lanes, (const QueryHits &hits, uint32_t *ids, uint32_t room), (hits, ids, room))

}  // namespace hsp
