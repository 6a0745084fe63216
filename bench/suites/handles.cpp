#include "handles.hpp"

#include <algorithm>

namespace bench {
std::vector<double> unequal_weights(uint32_t balls) {
  std::vector<double> weights;
  for (uint32_t ball = 0; ball < balls; ++ball) weights.push_back(1.0 + ball % 3);
  return weights;
}

Model::Model(const Balls &balls, double probe) : balls_(&balls), model_(balls.size()) {
  expect_ok(hsp_model_options_init(&options_, sizeof options_), "hsp_model_options_init");
  options_.probe = probe;
  set();
}

void Model::set(const std::vector<double> &xyz) {
  expect_ok(hsp_model_set(get(), size(), xyz.data(), balls_->radius.data(), &options_, nullptr), "hsp_model_set");
}

double Model::largest_radius() const {
  return read(hsp_model_get_info, get(), "hsp_model_get_info").largest_radius;
}

Boundary::Boundary(Model &model, Room room)
    : model_(&model), area_(model.size()), volume_(model.size()), weight_(unequal_weights(model.size())) {
  by_centre_.resize(3 * size_t{model.size()});
  by_radius_.resize(model.size());
  hsp_boundary_limits limits = support::default_boundary_limits(model.size());
  if (room == Room::exact) {
    limits.vertices = 4 * limits.balls + 64;
    limits.circles = limits.balls / 4 + 16;
    boundary_.take(limits);
    compute();
    limits = boundary_.needed();
  }
  boundary_.take(limits);
  compute();
}

void Boundary::compute() {
  boundary_.compute([this](hsp_boundary *boundary, hsp_boundary_limits *limits) {
    return hsp_boundary_compute_with(boundary, model_->get(), nullptr, limits);
  });
}

hsp_totals Boundary::measure() {
  hsp_totals totals{};
  expect_ok(hsp_boundary_measure(boundary_.get(), nullptr, &totals, area_.data(), volume_.data(),
                                 static_cast<uint32_t>(area_.size()), nullptr),
            "hsp_boundary_measure");
  return totals;
}

hsp_energy Boundary::gradient() {
  return energy_of(hsp_boundary_get_gradient, boundary_.get(), weight_.data(), by_centre_, by_radius_,
                   "hsp_boundary_get_gradient");
}

hsp_curvatures Boundary::curvature() {
  hsp_curvatures totals{};
  expect_ok(hsp_boundary_curvature(boundary_.get(), &totals, by_radius_.data(), nullptr,
                                   static_cast<uint32_t>(by_radius_.size()), nullptr),
            "hsp_boundary_curvature");
  return totals;
}

hsp_morphometric_energy Boundary::curvature_gradient() {
  hsp_morphometry_request bending{};
  bending.struct_size = sizeof bending;
  bending.bending = 1;
  hsp_morphometric_energy energy{};
  hsp_morphometry_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = static_cast<uint32_t>(by_radius_.size());
  outputs.energy = &energy;
  outputs.d_centre = by_centre_.data();
  outputs.d_radius = by_radius_.data();
  outputs.area = area_.data();
  expect_ok(hsp_boundary_get_morphometry(boundary_.get(), &bending, &outputs), "hsp_boundary_get_morphometry");
  return energy;
}

hsp_boundary_counts Boundary::counts() const {
  return read(hsp_boundary_get_counts, boundary_.get(), "hsp_boundary_get_counts");
}

Contacts::Contacts(const Boundary &boundary) : boundary_(&boundary) {
  contacts_.take(support::contacts_limits_for(boundary.get()));
  compute();
  contacts_.take(contacts_.needed());
  compute();
}

void Contacts::compute() {
  contacts_.compute([this](hsp_contacts *contacts, hsp_contacts_limits *limits) {
    return hsp_contacts_compute_with(contacts, boundary_->get(), nullptr, limits);
  });
}

hsp_complex Contacts::complex() const {
  return read(hsp_contacts_get_complex, contacts_.get(), "hsp_contacts_get_complex");
}

uint32_t Contacts::count() const {
  uint32_t needed = 0;
  hsp_contacts_get_pairs(contacts_.get(), nullptr, 0, &needed);
  return needed;
}

Periodic::Periodic(const Model &model, const std::array<double, 3> &side, bool areas_alone)
    : model_(&model),
      box_{side[0], 0, 0, 0, side[1], 0, 0, 0, side[2]},
      area_(model.size()),
      by_centre_(3 * size_t{model.size()}) {
  expect_ok(hsp_model_options_init(&options_, sizeof options_), "hsp_model_options_init");
  options_.probe = model.probe();
  request_.struct_size = sizeof request_;
  request_.areas_alone = areas_alone ? 1 : 0;
  request_.options = &options_;
  hsp_periodic_limits limits{};
  expect_ok(hsp_periodic_limits_init(&limits, sizeof limits, model.size()), "hsp_periodic_limits_init");
  periodic_.take(limits);
  compute();
  periodic_.take(periodic_.needed());
  compute();
}

void Periodic::compute() {
  const Balls &balls = model_->balls();
  periodic_.compute([&](hsp_periodic *periodic, hsp_periodic_limits *limits) {
    return hsp_periodic_compute_with(periodic, model_->size(), balls.xyz.data(), balls.radius.data(), box_.data(),
                                     &request_, limits, nullptr);
  });
}

void Periodic::differentiate() {
  hsp_gradient_request request{};
  expect_ok(hsp_gradient_request_init(&request, sizeof request), "hsp_gradient_request_init");
  request.tension = 1;
  hsp_periodic_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = static_cast<uint32_t>(area_.size());
  outputs.d_centre = by_centre_.data();
  outputs.area = area_.data();
  expect_ok(hsp_periodic_get_gradient(periodic_.get(), &request, &outputs), "hsp_periodic_get_gradient");
}

void Periodic::differentiate_twice() {
  hsp_gradient_request request{};
  expect_ok(hsp_gradient_request_init(&request, sizeof request), "hsp_gradient_request_init");
  request.tension = 1;
  first_.resize(model_->size() + size_t{1});
  for (;;) {
    uint32_t needed = 0;
    const auto room = static_cast<uint32_t>(column_.size());
    const int32_t status = hsp_periodic_get_hessian_rows(periodic_.get(), &request, first_.data(), column_.data(),
                                                         block_.data(), nullptr, room, &needed);
    if (status != HSP_E_CAPACITY) return expect_ok(status, "hsp_periodic_get_hessian_rows");
    column_.resize(needed);
    block_.resize(9 * size_t{needed});
  }
}

hsp_periodic_counts Periodic::counts() const {
  return read(hsp_periodic_get_counts, periodic_.get(), "hsp_periodic_get_counts");
}

Topology::Topology(const Boundary &boundary) : boundary_(&boundary) {
  topology_.take(support::topology_limits_for(boundary.get()));
  compute();
  topology_.take(needed());
  compute();
}

void Topology::compute() {
  topology_.compute([this](hsp_topology *topology, hsp_topology_limits *limits) {
    return hsp_topology_compute_with(topology, boundary_->get(), nullptr, limits);
  });
}

hsp_topology_counts Topology::counts() const {
  return read(hsp_topology_get_counts, topology_.get(), "hsp_topology_get_counts");
}

hsp_topology_limits Topology::needed() const {
  return topology_.needed();
}

size_t Topology::bytes_by_default() const {
  // The limits that suffice for molecules, as the header says.
  const uint32_t n = boundary_->model().size();
  const hsp_topology_limits limits{sizeof limits, n, std::min(n, 256U), 16 * n + 96, 2 * n + 16, 0};
  size_t bytes = 0;
  expect_ok(hsp_topology_bytes(&limits, &bytes), "hsp_topology_bytes");
  return bytes;
}

}  // namespace bench
