#include "model/grid_order.hpp"

#include <initializer_list>

namespace hsp {

GridOrder grid_order_by_comparing(const BallSet &balls, const CubeAxis &axis, Span<uint32_t> entries) {
  const Span<uint32_t> order = entries.part(0, balls.n);
  for (uint32_t k = 0; k < balls.n; ++k) order[k] = k;
  sort_in_place(order, [&](uint32_t i, uint32_t j) {
    for (const Span<double> *coordinate : {&balls.z, &balls.y, &balls.x}) {
      const int64_t a = axis.cube_at(static_cast<int64_t>((*coordinate)[i]));
      const int64_t b = axis.cube_at(static_cast<int64_t>((*coordinate)[j]));
      if (a != b) return a < b;
    }
    return balls.ranks_before(i, j);
  });
  for (uint32_t k = balls.n; k-- > 0;) entries[2 * k + 1] = entries[k];
  return {entries, false, 0, 0};
}

}  // namespace hsp
