// The cubes that no ball meets, as O(cubes) boxes, the runs: cubes along x between the other cubes of a row; empty rows
// between the other rows of a layer; and empty layers. The outermost runs reach to infinity.
#pragma once

#include "cells/cube_cover.hpp"
#include "core/first_index.hpp"

namespace hsp {

class EmptyRuns {
 public:
  void carve(Workspace &workspace, uint32_t cubes);
  // Numbers the runs 0, 1 .. in the order of z, y and x; run 0 is that below all balls.
  void build(const CubeCover &cover);

  uint32_t count() const { return count_; }
  // The run that holds a cube that no ball meets.
  uint32_t find(const CubeCover &cover, const CubeCoordinates &cube) const;
  // Calls visit(run, low, high) for each run, in any order: the run is the cubes from low to before high. Along an axis
  // on which it has no end, low is -infinity or high is infinity.
  static constexpr int64_t infinity = INT64_C(1) << 60;
  template <class Visit>
  void for_each_run(const CubeCover &cover, Visit visit) const;
  // Calls visit(a, b) once for each pair of runs with a common side.
  template <class Visit>
  void for_each_contact(const CubeCover &cover, Visit visit) const;

 private:
  struct Row {
    int64_t y;
    uint32_t first_cube;
    uint32_t before, after;  // the run of rows before this one, if any; the run behind its last cube
  };
  struct Layer {
    int64_t z;
    uint32_t first_row;
    uint32_t before, after;  // the run of layers before this one, if any; the run of rows behind its last row
  };
  // A run along one line, and how far it reaches.
  struct Stretch {
    int64_t low, high;
    uint32_t run;
  };

  uint32_t end_of_row(uint32_t row) const { return rows_[row + 1].first_cube; }
  uint32_t end_of_layer(uint32_t layer) const { return layers_[layer + 1].first_row; }
  // Calls visit(stretch) for the runs in a row, or for the runs of rows in a layer.
  template <class Visit>
  void for_each_in_row(const CubeCover &cover, uint32_t row, Visit visit) const;
  template <class Visit>
  void for_each_in_layer(uint32_t layer, Visit visit) const;
  // A position on another line: a cube or row at which one of its runs ends, and `low`, where that run begins.
  struct OtherLine {
    uint32_t at, end;
    int64_t low;
  };
  // Visits the runs of the other line beside a stretch of one line: those that begin before it ends, from the first
  // that does not end before it begins.
  template <class HighAt, class RunAt, class Visit>
  static void visit_beside(const Stretch &stretch, OtherLine &line, HighAt high_at, RunAt run_at, Visit visit);
  template <class Visit>
  void contacts_of_rows(const CubeCover &cover, uint32_t row, uint32_t other, Visit visit) const;
  template <class Visit>
  void contacts_of_layers(const CubeCover &cover, uint32_t layer, Visit visit) const;
  // The first of first .. last - 1 whose key is not below `wanted`; last if there is none. Keys are ascending integers,
  // mostly in steps of one: then the answer is found at once, else by bisection.
  template <class KeyAt>
  static uint32_t first_not_below(uint32_t first, uint32_t last, int64_t wanted, KeyAt key_at) {
    if (first == last || wanted <= key_at(first)) return first;
    const uint64_t steps = static_cast<uint64_t>(wanted - key_at(first));
    if (steps >= last - first) {
      if (key_at(last - 1) < wanted) return last;
    } else if (key_at(first + static_cast<uint32_t>(steps)) == wanted) {
      return first + static_cast<uint32_t>(steps);
    }
    return first_index(first, last, [&](uint32_t k) { return key_at(k) >= wanted; });
  }
  // The first row of a layer that is not before y: the row at y, or the one behind the run of rows that holds y.
  uint32_t first_row_at(uint32_t layer, int64_t y) const {
    return first_not_below(layers_[layer].first_row, end_of_layer(layer), y,
                           [&](uint32_t row) { return rows_[row].y; });
  }
  uint32_t run_of_rows(uint32_t layer, uint32_t first_row) const {
    return first_row < end_of_layer(layer) ? rows_[first_row].before : layers_[layer].after;
  }

  Span<uint32_t> before_cube_;  // [cubes] the run before a cube in its row; no_id if there is none
  Span<Row> rows_;              // [rows + 1]
  Span<Layer> layers_;          // [layers + 1]; the last entry is behind all layers
  uint32_t row_count_ = 0, layer_count_ = 0, count_ = 0;
};

template <class Visit>
void EmptyRuns::for_each_in_row(const CubeCover &cover, uint32_t row, Visit visit) const {
  int64_t low = -infinity;
  for (uint32_t cube = rows_[row].first_cube; cube < end_of_row(row); ++cube) {
    const int64_t x = cover.cube(cube).x;
    if (before_cube_[cube] != no_id) visit(Stretch{low, x, before_cube_[cube]});
    low = x + 1;
  }
  visit(Stretch{low, infinity, rows_[row].after});
}

template <class Visit>
void EmptyRuns::for_each_in_layer(uint32_t layer, Visit visit) const {
  int64_t low = -infinity;
  for (uint32_t row = layers_[layer].first_row; row < end_of_layer(layer); ++row) {
    if (rows_[row].before != no_id) visit(Stretch{low, rows_[row].y, rows_[row].before});
    low = rows_[row].y + 1;
  }
  visit(Stretch{low, infinity, layers_[layer].after});
}

template <class HighAt, class RunAt, class Visit>
void EmptyRuns::visit_beside(const Stretch &stretch, OtherLine &line, HighAt high_at, RunAt run_at, Visit visit) {
  for (;;) {
    const bool last = line.at == line.end;
    const int64_t high = last ? infinity : high_at(line.at);
    const uint32_t run = run_at(line.at);
    const int64_t from = stretch.low > line.low ? stretch.low : line.low;
    const int64_t to = stretch.high < high ? stretch.high : high;
    if (run != no_id && from < to) visit(stretch.run, run);
    if (last || high >= stretch.high) break;
    line.low = high + 1;
    ++line.at;
  }
}

template <class Visit>
void EmptyRuns::contacts_of_rows(const CubeCover &cover, uint32_t row, uint32_t other, Visit visit) const {
  OtherLine line{rows_[other].first_cube, end_of_row(other), -infinity};
  const auto high_at = [&](uint32_t cube) { return cover.cube(cube).x; };
  const auto run_at = [&](uint32_t cube) { return cube == line.end ? rows_[other].after : before_cube_[cube]; };
  for_each_in_row(cover, row, [&](const Stretch &stretch) { visit_beside(stretch, line, high_at, run_at, visit); });
}

template <class Visit>
void EmptyRuns::contacts_of_layers(const CubeCover &cover, uint32_t layer, Visit visit) const {
  const uint32_t other = layer + 1;
  OtherLine line{layers_[other].first_row, end_of_layer(other), -infinity};
  const auto high_at = [&](uint32_t row) { return rows_[row].y; };
  const auto run_at = [&](uint32_t row) { return run_of_rows(other, row); };
  for_each_in_layer(layer, [&](const Stretch &stretch) { visit_beside(stretch, line, high_at, run_at, visit); });
  for (uint32_t above = 0; above < 2; ++above) {
    const uint32_t of = layer + above, to = layer + 1 - above;
    for (uint32_t row = layers_[of].first_row; row < end_of_layer(of); ++row) {
      const uint32_t there = first_row_at(to, rows_[row].y);
      if (there < end_of_layer(to) && rows_[there].y == rows_[row].y) {
        if (above == 0) contacts_of_rows(cover, row, there, visit);
        continue;
      }
      const uint32_t run = run_of_rows(to, there);
      for_each_in_row(cover, row, [&](const Stretch &stretch) { visit(stretch.run, run); });
    }
  }
}

template <class Visit>
void EmptyRuns::for_each_run(const CubeCover &cover, Visit visit) const {
  constexpr int64_t all = infinity;
  int64_t low_z = -all;
  for (uint32_t layer = 0; layer < layer_count_; ++layer) {
    const int64_t z = layers_[layer].z;
    if (layers_[layer].before != no_id) {
      visit(layers_[layer].before, CubeCoordinates{-all, -all, low_z}, CubeCoordinates{all, all, z});
    }
    for_each_in_layer(layer, [&](const Stretch &rows) {
      visit(rows.run, CubeCoordinates{-all, rows.low, z}, CubeCoordinates{all, rows.high, z + 1});
    });
    for (uint32_t row = layers_[layer].first_row; row < end_of_layer(layer); ++row) {
      const int64_t y = rows_[row].y;
      for_each_in_row(cover, row, [&](const Stretch &cubes) {
        visit(cubes.run, CubeCoordinates{cubes.low, y, z}, CubeCoordinates{cubes.high, y + 1, z + 1});
      });
    }
    low_z = z + 1;
  }
  visit(layers_[layer_count_].before, CubeCoordinates{-all, -all, low_z}, CubeCoordinates{all, all, all});
}

template <class Visit>
void EmptyRuns::for_each_contact(const CubeCover &cover, Visit visit) const {
  for (uint32_t layer = 0; layer < layer_count_; ++layer) {
    const uint32_t below = layers_[layer].before, above = layers_[layer + 1].before;
    const auto with_layers = [&](const Stretch &stretch) {
      if (below != no_id) visit(stretch.run, below);
      if (above != no_id) visit(stretch.run, above);
    };
    for_each_in_layer(layer, with_layers);
    for (uint32_t row = layers_[layer].first_row; row < end_of_layer(layer); ++row) {
      const uint32_t before = rows_[row].before, after = run_of_rows(layer, row + 1);
      for_each_in_row(cover, row, [&](const Stretch &stretch) {
        with_layers(stretch);
        if (before != no_id) visit(stretch.run, before);
        if (after != no_id) visit(stretch.run, after);
      });
      if (after == no_id) contacts_of_rows(cover, row, row + 1, visit);
    }
    if (above == no_id) contacts_of_layers(cover, layer, visit);
  }
}

}  // namespace hsp
