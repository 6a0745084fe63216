// Finds the balls of some ranges that meet a query ball: one at a time, or as many at a time as a register holds floats
// (lanes/words.hpp). Both give the same hits.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"
#include "model/ball_range.hpp"
#include "model/meeting.hpp"

namespace hsp {

// The arrays of a BallSet, which may be read seven entries after the last ball.
struct QueryArrays {
  const double *x, *y, *z, *r;
  const uint32_t *caller;
};

// A query ball on the lattice; its numbers are integers.
struct QueryBall {
  double x, y, z, r;
  uint32_t excluded;  // the caller's index of a ball that is never a hit, or no_id
};

// The caller's indices of the balls that have been found, in any order. Hits beyond the room are counted, not stored.
struct QueryHits {
  static constexpr uint32_t room = 128;
  uint32_t ids[room + 8];  // the last eight may be overwritten
  uint32_t count;
};

// A set with a directory of rows (row_directory.hpp), for whole queries in lanes. Lengths in steps, and numbers of
// cubes, are doubles. Arrays of four hold x, y, z and 0.
struct QueryGrid {
  const uint32_t *cells = nullptr;  // of the directory; null if there is none
  uint64_t row, layer;              // number of entries in a row, number of rows in a layer
  double low[4], size[4];           // coordinates of the first cube; numbers of cubes along each axis
  double side, inverse_side, largest_radius;
  double factor = 0.0;  // steps in the caller's unit of length; 0 without a directory, or if lengths are divided
  // The balls relative to the middle of the box, rounded to floats, x, y, z, r of each ball side by side: a query reads
  // half as much memory, and half as many registers hold eight balls. As many balls behind the last one may be read as
  // in QueryArrays.
  const float *rounded = nullptr;  // null if there are none
  double middle[4];                // an integer along each axis, and 0
  double extent;                   // no centre is farther from the middle along any axis
};

// Adds the hits among the balls of the ranges.
void add_hits(const QueryArrays &balls, const QueryBall &query, const BallRange *ranges, uint32_t count,
              QueryHits &hits);
HSP_KERNEL(void, add_hits_in_lanes,
           (const QueryArrays &balls, const QueryBall &query, const BallRange *ranges, uint32_t count, QueryHits &hits),
           (balls, query, ranges, count, hits))
// The same as find_balls() of queries.hpp, for a ball in the caller's unit. False, and nothing is written, if the query
// is to be refused, or if it meets many rows of cubes or many balls.
HSP_KERNEL(bool, find_balls_in_lanes,
           (const QueryGrid &grid, const QueryArrays &balls, const double *xyz, double radius, uint32_t *ids,
            uint32_t capacity, uint32_t &hits),
           (grid, balls, xyz, radius, ids, capacity, hits))
// The same for find_neighbours().
HSP_KERNEL(bool, find_neighbours_in_lanes,
           (const QueryGrid &grid, const QueryArrays &balls, uint32_t rank, uint32_t *ids, uint32_t capacity,
            uint32_t &hits),
           (grid, balls, rank, ids, capacity, hits))

// A query ball in floats, relative to the same point as the balls.
struct RoundedQueryBall {
  float ball[4];  // x, y, z, r
  float doubt;    // a ball may meet the query if the computed d^2 - t^2 is not above this
};
// Writes to `near` the ids of the balls that may meet the query, of some ranges of rounded balls, none of them empty.
// `rounded` is as in QueryGrid, ids[j] is the id of its ball j. `near` has room for all of these balls and for eight
// more. Returns how many are written.
uint32_t near_query(const RoundedQueryBall &query, const float *rounded, const uint32_t *ids, const BallRange *ranges,
                    uint32_t count, uint32_t *near);
HSP_KERNEL(uint32_t, near_query_in_lanes,
           (const RoundedQueryBall &query, const float *rounded, const uint32_t *ids, const BallRange *ranges,
            uint32_t count, uint32_t *near),
           (query, rounded, ids, ranges, count, near))

// Writes the hits, of which there are no more than QueryHits::room, in ascending order.
void write_ascending(const QueryHits &hits, uint32_t *ids);
// The same. `room`: how many ids the array has in all. Entries behind the hits may be read, and written as they were.
HSP_KERNEL(void, write_ascending_in_lanes, (const QueryHits &hits, uint32_t *ids, uint32_t room), (hits, ids, room))

}  // namespace hsp
