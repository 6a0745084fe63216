// hsp_model, hsp_boundary and hsp_topology in memory of their own, for the benchmarks.
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
  void set() { set(balls_->xyz); }

  /// The same with other centres [size()][3]: a frame of a trajectory.
  void set(const std::vector<double> &xyz);

  hsp_model *get() { return model_; }
  const hsp_model *get() const { return model_; }
  const Balls &balls() const { return *balls_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(balls_->radius.size()); }
  double probe() const { return options_.probe; }
  double largest_radius() const;

 private:
  const Balls *balls_;
  hsp_model_options options_{};
  std::vector<std::byte> memory_;
  hsp_model *model_ = nullptr;
};

/// How much room a handle gets: exactly what its contents need, which is found out by computing them, or what the
/// library's default limits say.
enum class Room { exact, by_default };

class Boundary {
 public:
  explicit Boundary(Model &model, Room room = Room::exact);

  void compute();

  /// Areas and volumes of every ball.
  hsp_totals measure();

  /// A weighted sum of areas plus the volume, with its derivatives by every centre and radius.
  hsp_energy gradient();

  hsp_boundary_counts counts() const;
  const hsp_boundary *get() const { return boundary_; }
  const Model &model() const { return *model_; }
  std::size_t bytes() const { return memory_.size(); }

 private:
  void take(const hsp_boundary_limits &limits);
  void take_exact_room(hsp_boundary_limits limits);

  Model *model_;
  std::vector<std::byte> memory_;
  std::vector<double> area_;
  std::vector<double> volume_;
  std::vector<double> weight_;
  std::vector<double> by_centre_;
  std::vector<double> by_radius_;
  hsp_boundary *boundary_ = nullptr;
};

class Topology {
 public:
  /// Makes room for exactly what the topology of this computed boundary needs, and computes it.
  explicit Topology(const Boundary &boundary);

  void compute();
  hsp_topology_counts counts() const;
  hsp_topology_limits needed() const;
  hsp_topology *get() { return topology_; }
  std::size_t bytes() const { return memory_.size(); }

  /// What hsp_topology_bytes says for the default limits; no such memory is taken.
  std::size_t bytes_by_default() const;

 private:
  void take(const hsp_topology_limits &limits);
  void compute_in_room_for(hsp_topology_limits limits);

  const Boundary *boundary_;
  std::vector<std::byte> memory_;
  hsp_topology *topology_ = nullptr;
};

}  // namespace bench
