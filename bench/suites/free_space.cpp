#include "free_space.hpp"

namespace bench {

FreeSpace::FreeSpace(const Model &model) : model_(&model) {
  hsp_cells_limits limits{};
  expect_ok(hsp_cells_limits_init(&limits, sizeof limits, model.size()), "hsp_cells_limits_init");
  cells_.take(limits);
  compute();
}

void FreeSpace::compute() {
  cells_.compute(
      [this](hsp_cells *cells, hsp_cells_limits *limits) { return hsp_cells_compute(cells, model_->get(), limits); });
}

hsp_cells_counts FreeSpace::counts() const {
  return read(hsp_cells_get_counts, cells_.get(), "hsp_cells_get_counts");
}

size_t FreeSpace::locate(const std::vector<double> &points) const {
  size_t in_none = 0;
  for (size_t i = 0; i < points.size(); i += 3) {
    uint32_t cell = 0;
    const int32_t status = hsp_cells_locate(cells_.get(), &points[i], &cell);
    if (status != HSP_OK) expect_ok(status, "hsp_cells_locate");
    in_none += cell == HSP_NONE ? 1 : 0;
  }
  return in_none;
}

}  // namespace bench
