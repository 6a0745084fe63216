#include "model/query_hits.hpp"

#include "core/small_code.hpp"
#include "core/sorting.hpp"

namespace hsp {

void add_hits(const QueryArrays &balls, const QueryBall &query, const BallRange *ranges, uint32_t count,
              QueryHits &hits) {
  uint32_t found = hits.count;
  for (const BallRange *range = ranges; range < ranges + count; ++range) {
    for (uint32_t j = range->first; j < range->last; ++j) {
      const bool hit = meet(balls.x[j] - query.x, balls.y[j] - query.y, balls.z[j] - query.z, balls.r[j] + query.r);
      // Always stored, but kept only if it is a hit: a branch here could not be predicted.
      const uint32_t id = balls.caller[j];
      hits.ids[found < QueryHits::room ? found : QueryHits::room] = id;
      found += static_cast<uint32_t>(hit) & static_cast<uint32_t>(id != query.excluded);
    }
  }
  hits.count = found;
}

uint32_t near_query(const RoundedQueryBall &query, const float *rounded, const uint32_t *ids, const BallRange *ranges,
                    uint32_t count, uint32_t *near) {
  uint32_t found = 0;
  for (const BallRange *range = ranges; range < ranges + count; ++range) {
    for (uint32_t j = range->first; j < range->last; ++j) {
      const float *const other = rounded + 4 * size_t{j};
      const float dx = other[0] - query.ball[0], dy = other[1] - query.ball[1], dz = other[2] - query.ball[2];
      const float sum = other[3] + query.ball[3];
      near[found] = ids[j];
      found += static_cast<uint32_t>(dx * dx + dy * dy + dz * dz - sum * sum <= query.doubt);
    }
  }
  return found;
}

void write_ascending(const QueryHits &hits, uint32_t *ids) {
  constexpr uint32_t few = small_code ? 0 : 24;
  if (hits.count <= few) {
    // The place of a hit is the number of smaller hits: a loop without branches on the values.
    for (uint32_t k = 0; k < hits.count; ++k) {
      uint32_t smaller = 0;
      for (uint32_t other = 0; other < hits.count; ++other) smaller += hits.ids[other] < hits.ids[k] ? 1U : 0U;
      ids[smaller] = hits.ids[k];
    }
    return;
  }
  for (uint32_t k = 0; k < hits.count; ++k) ids[k] = hits.ids[k];
  sort_ascending(Span<uint32_t>(ids, hits.count));
}

}  // namespace hsp
