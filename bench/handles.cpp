#include "handles.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace bench {

void require_ok(int32_t status, const char *what) {
  if (status != HSP_OK) throw std::runtime_error(std::string(what) + ": " + hsp_status_text(status));
}

Model::Model(const Balls &balls, double probe) : balls_(&balls) {
  require_ok(hsp_model_options_init(&options_, sizeof options_), "hsp_model_options_init");
  options_.probe = probe;
  std::size_t bytes = 0;
  require_ok(hsp_model_bytes(size(), &bytes), "hsp_model_bytes");
  memory_.resize(bytes);
  require_ok(hsp_model_init(memory_.data(), memory_.size(), size(), &model_), "hsp_model_init");
  set();
}

void Model::set(const std::vector<double> &xyz) {
  require_ok(hsp_model_set(model_, size(), xyz.data(), balls_->radius.data(), &options_, nullptr), "hsp_model_set");
}

double Model::largest_radius() const {
  hsp_model_info info{};
  require_ok(hsp_model_get_info(model_, &info), "hsp_model_get_info");
  return info.largest_radius;
}

Boundary::Boundary(Model &model, Room room) : model_(&model), area_(model.size()), volume_(model.size()) {
  by_centre_.resize(3 * std::size_t{model.size()});
  by_radius_.resize(model.size());
  for (std::uint32_t ball = 0; ball < model.size(); ++ball) weight_.push_back(1.0 + ball % 3);
  hsp_boundary_limits limits{};
  require_ok(hsp_boundary_limits_init(&limits, sizeof limits, model.size()), "hsp_boundary_limits_init");
  if (room == Room::by_default) {
    take(limits);
  } else {
    take_exact_room(limits);
  }
  compute();
}

void Boundary::take_exact_room(hsp_boundary_limits limits) {
  // Two enlargements at most lead to success (hsp_boundary_get_needed); the last round is for the exact size.
  limits.vertices = 4 * limits.balls + 64;
  limits.circles = limits.balls / 4 + 16;
  take(limits);
  int32_t status = hsp_boundary_compute(boundary_, model_->get());
  for (int enlargements = 0; status == HSP_E_CAPACITY && enlargements < 2; ++enlargements) {
    hsp_boundary_limits needed = limits;
    require_ok(hsp_boundary_get_needed(boundary_, &needed), "hsp_boundary_get_needed");
    limits.neighbours = std::max(limits.neighbours, needed.neighbours);
    limits.vertices = std::max(limits.vertices, needed.vertices);
    limits.circles = std::max(limits.circles, needed.circles);
    take(limits);
    status = hsp_boundary_compute(boundary_, model_->get());
  }
  require_ok(status, "hsp_boundary_compute");
  require_ok(hsp_boundary_get_needed(boundary_, &limits), "hsp_boundary_get_needed");
  limits.struct_size = sizeof limits;
  limits.reserved = 0;
  take(limits);
}

void Boundary::take(const hsp_boundary_limits &limits) {
  std::size_t bytes = 0;
  require_ok(hsp_boundary_bytes(&limits, &bytes), "hsp_boundary_bytes");
  std::vector<std::byte>().swap(memory_);
  memory_.resize(bytes);
  require_ok(hsp_boundary_init(memory_.data(), memory_.size(), &limits, &boundary_), "hsp_boundary_init");
}

void Boundary::compute() {
  require_ok(hsp_boundary_compute(boundary_, model_->get()), "hsp_boundary_compute");
}

hsp_totals Boundary::measure() {
  hsp_totals totals{};
  require_ok(
      hsp_boundary_measure(boundary_, &totals, area_.data(), volume_.data(), static_cast<std::uint32_t>(area_.size())),
      "hsp_boundary_measure");
  return totals;
}

hsp_energy Boundary::gradient() {
  hsp_energy energy{};
  require_ok(hsp_boundary_gradient(boundary_, weight_.data(), 1.0, 1.0, HSP_TANGENT_MEETING, &energy, by_centre_.data(),
                                   by_radius_.data(), nullptr, static_cast<std::uint32_t>(by_radius_.size())),
             "hsp_boundary_gradient");
  return energy;
}

hsp_boundary_counts Boundary::counts() const {
  hsp_boundary_counts counts{};
  require_ok(hsp_boundary_get_counts(boundary_, &counts), "hsp_boundary_get_counts");
  return counts;
}

Topology::Topology(const Boundary &boundary) : boundary_(&boundary) {
  hsp_topology_limits limits{};
  require_ok(hsp_topology_limits_for(&limits, sizeof limits, boundary.get()), "hsp_topology_limits_for");
  compute_in_room_for(limits);
  compute_in_room_for(needed());
}

void Topology::compute_in_room_for(hsp_topology_limits limits) {
  take(limits);
  int32_t status = hsp_topology_compute(topology_, boundary_->get());
  // Three enlargements at most lead to success (hsp_topology_get_needed).
  for (int enlargements = 0; status == HSP_E_CAPACITY && enlargements < 3; ++enlargements) {
    const hsp_topology_limits wanted = needed();
    limits.neighbours = std::max(limits.neighbours, wanted.neighbours);
    limits.edges = std::max(limits.edges, wanted.edges);
    limits.extra_arcs = std::max(limits.extra_arcs, wanted.extra_arcs);
    take(limits);
    status = hsp_topology_compute(topology_, boundary_->get());
  }
  require_ok(status, "hsp_topology_compute");
}

void Topology::take(const hsp_topology_limits &limits) {
  std::size_t bytes = 0;
  require_ok(hsp_topology_bytes(&limits, &bytes), "hsp_topology_bytes");
  std::vector<std::byte>().swap(memory_);
  memory_.resize(bytes);
  require_ok(hsp_topology_init(memory_.data(), memory_.size(), &limits, &topology_), "hsp_topology_init");
}

void Topology::compute() {
  require_ok(hsp_topology_compute(topology_, boundary_->get()), "hsp_topology_compute");
}

hsp_topology_counts Topology::counts() const {
  hsp_topology_counts counts{};
  require_ok(hsp_topology_get_counts(topology_, &counts), "hsp_topology_get_counts");
  return counts;
}

hsp_topology_limits Topology::needed() const {
  hsp_topology_limits limits{};
  require_ok(hsp_topology_get_needed(topology_, &limits), "hsp_topology_get_needed");
  return limits;
}

std::size_t Topology::bytes_by_default() const {
  hsp_topology_limits limits{};
  require_ok(hsp_topology_limits_init(&limits, sizeof limits, boundary_->model().size()), "hsp_topology_limits_init");
  std::size_t bytes = 0;
  require_ok(hsp_topology_bytes(&limits, &bytes), "hsp_topology_bytes");
  return bytes;
}

}  // namespace bench
