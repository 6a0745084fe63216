// The balls of some ranges that meet a query ball: one at a time, or where registers hold several numbers as many as
// there are floats in one (lanes/words.hpp). Both decide alike.
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

// The same in floats, from a point that is the same for balls and query.
struct RoundedQueryBall {
  float ball[4];  // x, y, z, r
  float doubt;    // d^2 - t^2 up to that much may be none above 0
};
// Those of some ranges of rounded balls, none of them empty, that may meet the query. `rounded` is as in QueryGrid, its
// balls have these ids, and in `near` there is room for as many, and for eight more. Returns how many there are.
uint32_t near_query(const RoundedQueryBall &query, const float *rounded, const uint32_t *ids, const BallRange *ranges,
                    uint32_t count, uint32_t *near);
HSP_KERNEL(uint32_t, near_query_in_lanes,
           (const RoundedQueryBall &query, const float *rounded, const uint32_t *ids, const BallRange *ranges,
            uint32_t count, uint32_t *near),
           (query, rounded, ids, ranges, count, near))

// Writes the hits, if there are no more than the room, in ascending order.
void write_ascending(const QueryHits &hits, uint32_t *ids);
// At ids[count ..] there may be more that is the caller's, `room` ids in all: it is read and written as it was.
HSP_KERNEL(void, write_ascending_in_lanes, (const QueryHits &hits, uint32_t *ids, uint32_t room), (hits, ids, room))

}  // namespace hsp
