// hsp_model, hsp_boundary, hsp_contacts, hsp_periodic and hsp_topology in memory of their own, for the benchmarks.
// Those of the components stand beside: smooth_surface, free_space and view_handle.
//
// Memory is allocated before anything is timed, written once so that its pages exist, and used again by every
// iteration, as the library asks its users to do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardsphere.h"
#include "owned_boxes.hpp"
#include "paper_molecules.hpp"

namespace bench {

using support::expect_ok;

class Model {
 public:
  // Takes the balls, `probe` added to every radius.
  Model(const Balls &balls, double probe);

  // Calls hsp_model_set with the balls once more; this is "build" in the reports.
  void set() { set(balls_->xyz); }

  // The same with other centres [size()][3]: a frame of a trajectory.
  void set(const std::vector<double> &xyz);

  hsp_model *get() const { return model_.get(); }
  const Balls &balls() const { return *balls_; }
  uint32_t size() const { return balls_->size(); }
  double probe() const { return options_.probe; }
  double largest_radius() const;

 private:
  const Balls *balls_;
  hsp_model_options options_{};
  support::OwnedModel model_;
};

// Weights of balls, not all the same.
std::vector<double> unequal_weights(uint32_t balls);

// The answer of a call such as hsp_boundary_get_counts about a handle.
template <class Handle, class Record>
Record read(int32_t (*get)(const Handle *, Record *), const Handle *handle, const char *call) {
  Record record{};
  expect_ok(get(handle, &record), call);
  return record;
}

// A weighted sum of areas plus the volume, of a boundary or a surface by its function, with its derivatives by every
// centre [n][3] and radius [n]. sigma: null for all ones.
template <class Handle>
hsp_energy energy_of(int32_t (*get)(const Handle *, const hsp_gradient_request *, hsp_gradient_outputs *),
                     const Handle *handle, const double *sigma, std::vector<double> &by_centre,
                     std::vector<double> &by_radius, const char *call) {
  hsp_energy energy{};
  const auto n = static_cast<uint32_t>(by_radius.size());
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tangency = HSP_TANGENT_OVERLAP;
  request.tension = 1.0;
  request.pressure = 1.0;
  request.sigma = sigma;
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &energy;
  outputs.d_centre = by_centre.data();
  outputs.d_radius = by_radius.data();
  expect_ok(get(handle, &request, &outputs), call);
  return energy;
}

// How much room a handle gets: exactly as much as its contents need, which computing them tells, or as much as the
// library's default limits say.
enum class Room { exact, by_default };

class Boundary {
 public:
  explicit Boundary(Model &model, Room room = Room::exact);

  void compute();

  // Areas and volumes of every ball.
  hsp_totals measure();
  // The areas that measure() found.
  const std::vector<double> &areas() const { return area_; }

  // A weighted sum of areas plus the volume, with its derivatives by every centre and radius.
  hsp_energy gradient();

  // Mean curvature of every ball; the mean curvature with its derivatives by every centre and radius.
  hsp_curvatures curvature();
  hsp_morphometric_energy curvature_gradient();

  hsp_boundary_counts counts() const;
  const hsp_boundary *get() const { return boundary_.get(); }
  const Model &model() const { return *model_; }
  size_t bytes() const { return boundary_.bytes(); }

 private:
  Model *model_;
  std::vector<double> area_;
  std::vector<double> volume_;
  std::vector<double> weight_;
  std::vector<double> by_centre_;
  std::vector<double> by_radius_;
  support::OwnedBoundary boundary_;
};

// Contacts and shares over a boundary.
class Contacts {
 public:
  // Makes room for exactly what this computed boundary needs, simplices only counted, and computes them.
  explicit Contacts(const Boundary &boundary);

  void compute();
  hsp_complex complex() const;
  // The number of contacts.
  uint32_t count() const;
  size_t bytes() const { return contacts_.bytes(); }

 private:
  const Boundary *boundary_;
  support::OwnedHandle<support::ContactsKind> contacts_;
};

// The balls of a model in a periodic box with these sides.
class Periodic {
 public:
  // Makes as much room as is needed, and computes the union in the box.
  Periodic(const Model &model, const std::array<double, 3> &side, bool areas_alone = false);

  void compute();
  hsp_periodic_counts counts() const;
  // Areas and their gradient.
  void differentiate();
  // The area's second derivatives.
  void differentiate_twice();

 private:
  const Model *model_;
  hsp_model_options options_{};
  std::vector<uint32_t> first_, column_;
  std::vector<double> block_;
  hsp_periodic_request request_{};
  std::array<double, 9> box_{};
  std::vector<double> area_, by_centre_;
  support::OwnedPeriodic periodic_;
};

class Topology {
 public:
  // Makes room for exactly what the topology of this computed boundary needs, and computes it.
  explicit Topology(const Boundary &boundary);

  void compute();
  hsp_topology_counts counts() const;
  hsp_topology_limits needed() const;
  hsp_topology *get() { return topology_.get(); }
  size_t bytes() const { return topology_.bytes(); }

  // The bytes by hsp_topology_bytes for the default limits; no such memory is taken.
  size_t bytes_by_default() const;

 private:
  const Boundary *boundary_;
  support::OwnedTopology topology_;
};

}  // namespace bench
