// hsp_model and hsp_boundary in memory of their own, for the benchmarks.
//
// Memory is taken before anything is timed, written once so that its pages are there, and used again by every
// iteration: what the library asks of its users is what is timed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardsphere.h"
#include "molecule_file.hpp"

namespace bench {

/// Throws std::runtime_error with the status' text and `what`, unless the status is HSP_OK.
void require_ok(int32_t status, const char *what);

class Model {
 public:
  /// Takes the balls, `probe` added to every radius.
  Model(const Balls &balls, double probe);

  /// hsp_model_set with the balls once more: what "build" means in the reports.
  void set();

  hsp_model *get() { return model_; }
  const hsp_model *get() const { return model_; }
  const Balls &balls() const { return *balls_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(balls_->radius.size()); }
  double largest_radius() const;

 private:
  const Balls *balls_;
  hsp_model_options options_{};
  std::vector<std::byte> memory_;
  hsp_model *model_ = nullptr;
};

class Boundary {
 public:
  /// Makes room for exactly what the model's boundary needs, which it finds out by computing it.
  explicit Boundary(Model &model);

  void compute();
  hsp_totals measure();
  hsp_boundary_counts counts() const;
  std::size_t bytes() const { return memory_.size(); }

 private:
  void take(const hsp_boundary_limits &limits);

  hsp_model *model_;
  std::vector<std::byte> memory_;
  std::vector<double> area_;
  std::vector<double> volume_;
  hsp_boundary *boundary_ = nullptr;
};

}  // namespace bench
