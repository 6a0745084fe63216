#include "cells/empty_runs.hpp"

namespace hsp {

void EmptyRuns::carve(Workspace &workspace, uint32_t cubes) {
  before_cube_ = workspace.take<uint32_t>(cubes);
  rows_ = workspace.take<Row>(static_cast<uint64_t>(cubes) + 1);
  layers_ = workspace.take<Layer>(static_cast<uint64_t>(cubes) + 1);
}

void EmptyRuns::build(const CubeCover &cover) {
  row_count_ = layer_count_ = count_ = 0;
  for (uint32_t k = 0; k < cover.cubes(); ++k) {
    const CubeCoordinates &cube = cover.cube(k);
    const CubeCoordinates *const last = k > 0 ? &cover.cube(k - 1) : nullptr;
    const bool new_layer = last == nullptr || cube.z != last->z;
    const bool new_row = new_layer || cube.y != last->y;
    if (new_row && last != nullptr) rows_[row_count_ - 1].after = count_++;
    if (new_layer) {
      if (last != nullptr) layers_[layer_count_ - 1].after = count_++;
      const bool gap = last == nullptr || cube.z != last->z + 1;
      layers_[layer_count_++] = {cube.z, row_count_, gap ? count_++ : no_id, no_id};
    }
    if (new_row) {
      const bool gap = new_layer || cube.y != last->y + 1;
      rows_[row_count_++] = {cube.y, k, gap ? count_++ : no_id, no_id};
    }
    before_cube_[k] = new_row || cube.x != last->x + 1 ? count_++ : no_id;
  }
  if (row_count_ > 0) {
    rows_[row_count_ - 1].after = count_++;
    layers_[layer_count_ - 1].after = count_++;
  }
  rows_[row_count_] = {0, cover.cubes(), no_id, no_id};
  layers_[layer_count_] = {0, row_count_, count_++, no_id};
}

uint32_t EmptyRuns::find(const CubeCover &cover, const CubeCoordinates &cube) const {
  const uint32_t layer = first_not_below(0, layer_count_, cube.z, [&](uint32_t k) { return layers_[k].z; });
  if (layer == layer_count_ || layers_[layer].z != cube.z) return layers_[layer].before;
  const uint32_t row = first_row_at(layer, cube.y);
  if (row == end_of_layer(layer) || rows_[row].y != cube.y) return run_of_rows(layer, row);
  const uint32_t end = end_of_row(row);
  const uint32_t next =
      first_not_below(rows_[row].first_cube, end, cube.x, [&](uint32_t k) { return cover.cube(k).x; });
  return next < end ? before_cube_[next] : rows_[row].after;
}

}  // namespace hsp
