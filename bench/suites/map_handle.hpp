// hsp_map in memory of its own, for the benchmarks; see handles.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "handles.hpp"

namespace bench {

class VisibleMap {
 public:
  using Direction = std::array<double, 3>;

  // Makes room for what any of these directions needs.
  VisibleMap(const Model &model, const std::vector<Direction> &directions);

  void compute(const Direction &towards);

  hsp_map_info info() const;
  size_t bytes() const { return map_.bytes(); }

 private:
  const Model *model_;
  hsp_view_options options_{};
  support::OwnedMap map_;
};

}  // namespace bench
