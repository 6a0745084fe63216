#include "periodic/periodic_queries.hpp"

namespace hsp {

void find_in_block(const CubeGrid &grid, const CubeBlock &block, const exact::Vector &point, int64_t radius,
                   uint32_t excluded, QueryHits &hits) {
  const QueryArrays arrays = query_arrays(grid.balls());
  const Vec3 p = to_double(point);
  const QueryBall query{p.x, p.y, p.z, static_cast<double>(radius), excluded};
  if (find_by_levels(grid, query, hits)) return;
  hits.count = 0;
  if constexpr (has_lanes) {
    if (grid.in_lanes()) return add_hits_in_lanes(grid.target(), arrays, query, block.range, block.ranges, hits);
  }
  add_hits(arrays, query, block.range, block.ranges, hits);
}

// Numbers of balls in the box come before those of all images, and images are numbered by their balls: two ascending
// rows are merged.
void put_in_order(const PeriodicUnion &periodic, const QueryHits &hits, OrderedHits &ordered) {
  const PeriodicImages &images = periodic.images();
  uint32_t sorted[QueryHits::room + 8];
  bool written = false;
  if constexpr (has_lanes) {
    written = periodic.grid().in_lanes();
    if (written) write_ascending_in_lanes(periodic.grid().target(), hits, sorted, hits.count);
  }
  if (!written) write_ascending(hits, sorted);
  uint32_t image = 0;
  while (image < hits.count && !images.is_image(sorted[image])) ++image;
  const uint32_t first_image = image;
  ordered.count = hits.count;
  for (uint32_t own = 0, next = 0; next < hits.count; ++next) {
    const bool takes_image = own == first_image || (image < hits.count && images.ball_of(sorted[image]) < sorted[own]);
    ordered.ids[next] = takes_image ? sorted[image++] : sorted[own++];
  }
}

}  // namespace hsp
