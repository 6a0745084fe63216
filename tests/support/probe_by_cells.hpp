// Whether a probe of a given radius gets from one point to another, by the cells of the library itself (hsp_cells): the
// balls are grown by the probe, the free space around them is cut into cells, and both points have to lie in one region
// of cells. The pores answer the same question from maxima and gates without growing a ball: two parts of the library
// are held against each other, and this is no independent oracle.
#pragma once

#include <hardsphere.h>

#include <optional>
#include <utility>
#include <vector>

#include "ball_list.hpp"

namespace support {

class ProbeByCells {
 public:
  // The lengths of the balls must be multiples of the lattice step.
  ProbeByCells(BallList balls, double step) : balls_(std::move(balls)), step_(step) {
    size_t bytes = 0;
    failed_ = hsp_model_bytes(balls_.size(), &bytes) != HSP_OK;
    model_memory_.resize(bytes);
    failed_ = failed_ || hsp_model_init(model_memory_.data(), bytes, balls_.size(), &model_) != HSP_OK;
  }

  // Whether a probe of this radius, a multiple of the step, gets from `from` to `to`; null is the outside. No answer if
  // the balls, grown by the probe, are too large for the lattice.
  std::optional<bool> passes(double probe, const double *from, const double *to) {
    hsp_model_options options{};
    failed_ = failed_ || hsp_model_options_init(&options, sizeof options) != HSP_OK;
    options.probe = probe;
    options.step = step_;
    const int32_t status =
        hsp_model_set(model_, balls_.size(), balls_.xyz.data(), balls_.radius.data(), &options, nullptr);
    if (status == HSP_E_RANGE) return std::nullopt;
    failed_ = failed_ || status != HSP_OK || !cut();
    const uint32_t here = region_of(from), there = to == nullptr ? 0 : region_of(to);
    return here != HSP_NONE && here == there;
  }

  // Whether a call of the library failed that must not fail; then no other answer of this object counts.
  bool has_failed() const { return failed_; }

 private:
  bool cut() {
    hsp_cells_limits limits{};
    int32_t status = hsp_cells_limits_init(&limits, sizeof limits, balls_.size());
    do {
      size_t bytes = 0;
      if (status != HSP_E_CAPACITY && status != HSP_OK) return false;
      if (hsp_cells_bytes(&limits, &bytes) != HSP_OK) return false;
      cells_memory_.resize(bytes);
      if (hsp_cells_init(cells_memory_.data(), bytes, &limits, &cells_) != HSP_OK) return false;
      status = hsp_cells_compute(cells_, model_, &limits);
    } while (status != HSP_OK);
    return true;
  }
  uint32_t region_of(const double *xyz) {
    uint32_t cell = HSP_NONE;
    failed_ = failed_ || hsp_cells_locate(cells_, xyz, &cell) != HSP_OK;
    if (failed_ || cell == HSP_NONE) return HSP_NONE;
    hsp_free_cell record{};
    failed_ = hsp_cells_get_cells(cells_, cell, 1, &record) != HSP_OK;
    return record.region;
  }

  BallList balls_;
  double step_;
  bool failed_ = false;
  std::vector<unsigned char> model_memory_, cells_memory_;
  hsp_model *model_ = nullptr;
  hsp_cells *cells_ = nullptr;
};

}  // namespace support
