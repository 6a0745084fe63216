// hsp_cells in memory of its own, for the benchmarks; see handles.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "handles.hpp"
#include "owned_spaces.hpp"

namespace bench {

// The cells of free space of a model.
class FreeSpace {
 public:
  // Makes room for as much as it takes, and computes them.
  explicit FreeSpace(const Model &model);

  void compute();
  hsp_cells_counts counts() const;
  // The cells of points [count][3]. Returns how many are in none.
  size_t locate(const std::vector<double> &points) const;

 private:
  const Model *model_;
  support::OwnedHandle<support::CellsKind> cells_;
};

}  // namespace bench
