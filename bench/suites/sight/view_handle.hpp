// hsp_view, hsp_map and hsp_sticks in memory of their own, for the benchmarks; see handles.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "handles.hpp"
#include "owned_views.hpp"

namespace bench {

using Direction = std::array<double, 3>;

class View {
 public:
  // pieces is HSP_PIECES_*. boundary: null for G-pieces cut from the model alone. Makes room for what any of these
  // directions needs.
  View(const Model &model, const Boundary *boundary, uint32_t pieces, const std::vector<Direction> &directions);

  void compute(const Direction &towards);

  // Writes the flat SVG of the direction computed last to a sink that only counts. Returns the bytes.
  uint64_t write_picture();

  hsp_view_info info() const;

 private:
  const Model *model_;
  const Boundary *boundary_;
  hsp_view_options options_{};
  hsp_picture_options picture_{};
  std::vector<uint32_t> colour_;
  support::OwnedView view_;
};

class VisibleMap {
 public:
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

// Small balls, and sticks between those whose full radii overlap as those of bonded atoms do.
class Sticks {
 public:
  explicit Sticks(const Balls &balls);

  // Computes a painting order, or a map.
  void compute(const Direction &towards, bool as_map);
  // Writes the SVG of the last computation to a sink that only counts, with the contours of `ink`, a map that was
  // computed before, if this is not null. Returns the number of bytes.
  uint64_t write_picture(const Sticks *ink);

 private:
  Model model_;
  std::vector<hsp_stick> sticks_;
  support::OwnedHandle<support::SticksKind> handle_;
};

}  // namespace bench
