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

namespace {

// A copy of the balls, with room for plugs behind them.
Balls with_plugs(const Pores &pores) {
  uint32_t n = 0;
  expect_ok(hsp_pores_get_plugged_balls(pores.get(), nullptr, nullptr, 0, &n), "hsp_pores_get_plugged_balls");
  Balls balls;
  balls.name = "with_plugs";
  balls.xyz.resize(size_t{3} * n);
  balls.radius.resize(n);
  expect_ok(hsp_pores_get_plugged_balls(pores.get(), balls.xyz.data(), balls.radius.data(), n, nullptr),
            "hsp_pores_get_plugged_balls");
  return balls;
}

}  // namespace

Pockets::Pockets(const Model &model)
    : pores_(model),
      count_(find()),
      balls_(model.size()),
      plugged_balls_(with_plugs(pores_)),
      plugged_model_(plugged_balls_, 0.0),
      plugged_boundary_(plugged_model_),
      plugged_(plugged_model_, pores_.get()),
      sizes_(count_) {}

uint32_t Pockets::find() {
  uint32_t count = 0;
  expect_ok(hsp_pores_find_pockets(pores_.get(), narrow, wide, &count), "hsp_pores_find_pockets");
  return count;
}

uint32_t Pockets::list_plugs() {
  uint32_t n = 0;
  expect_ok(hsp_pores_get_plugged_balls(pores_.get(), plugged_balls_.xyz.data(), plugged_balls_.radius.data(),
                                        plugged_balls_.size(), &n),
            "hsp_pores_get_plugged_balls");
  return n - balls_;
}

uint32_t Pockets::compute_plugged() {
  plugged_.compute();
  return plugged_model_.size();
}

uint32_t Pockets::measure() {
  expect_ok(
      hsp_pores_measure_pockets(pores_.get(), plugged_.get(), plugged_boundary_.get(), sizes_.data(), count_, nullptr),
      "hsp_pores_measure_pockets");
  uint32_t closed = 0;
  for (const hsp_pore_pocket_size &size : sizes_) closed += size.closed;
  return closed;
}

}  // namespace bench
