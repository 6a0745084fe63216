// Models and boundaries of the C interface that own their memory, and their results in the oracles' terms.
#pragma once

#include <cstdint>
#include <vector>

#include "boundary_record.hpp"
#include "hardsphere.h"
#include "lattice_ball.hpp"
#include "owned_handle.hpp"

using support::expect_ok;

// A model of lattice balls: the doubles passed are exact multiples of the step, a power of two, so that nothing is
// rounded. The probe, in the same lengths, is a multiple of the step too.
class LibraryModel {
 public:
  explicit LibraryModel(const oracle::Balls &balls, double step = 1, double probe = 0);

  [[nodiscard]] hsp_model *handle() const { return model_.get(); }
  [[nodiscard]] uint32_t balls() const { return balls_; }

 private:
  uint32_t balls_;
  support::OwnedModel model_;
};

// The boundary of such a model.
class LibraryBoundary {
 public:
  explicit LibraryBoundary(const oracle::Balls &balls, double step = 1, double probe = 0);

  [[nodiscard]] const hsp_boundary *handle() const { return boundary_.get(); }
  [[nodiscard]] const hsp_model *model() const { return model_.handle(); }
  [[nodiscard]] hsp_boundary_counts counts() const;
  [[nodiscard]] std::vector<hsp_vertex> vertices() const;
  [[nodiscard]] std::vector<hsp_arc> arcs() const;
  [[nodiscard]] std::vector<hsp_circle> circles() const;
  [[nodiscard]] std::vector<hsp_face> faces() const;
  [[nodiscard]] std::vector<hsp_ball> balls() const;

  // All records in the oracle's form. Throws std::runtime_error where ids or counts contradict each other.
  [[nodiscard]] oracle::BoundaryRecord record() const;

  struct Measures {
    hsp_totals totals{};
    std::vector<double> area;
    std::vector<double> volume;
  };
  [[nodiscard]] Measures measure() const;

 private:
  template <class Record, class Getter>
  std::vector<Record> records(Getter getter, const char *call) const;

  LibraryModel model_;
  support::OwnedBoundary boundary_;
};
