#include "smooth_surface.hpp"

namespace bench {

SmoothSurface::SmoothSurface(const Boundary &boundary)
    : boundary_(&boundary),
      balls_(boundary.model().size()),
      weight_(unequal_weights(boundary.model().size())),
      by_centre_(3 * size_t{boundary.model().size()}),
      by_radius_(boundary.model().size()) {
  surface_.take(support::surface_limits_for(boundary.get()));
  compute();
  surface_.take(surface_.needed());
  compute();
}

void SmoothSurface::compute() {
  surface_.compute([this](hsp_surface *surface, hsp_surface_limits *limits) {
    return hsp_surface_compute(surface, boundary_->get(), limits);
  });
}

hsp_surface_totals SmoothSurface::measure() {
  hsp_surface_totals totals{};
  expect_ok(hsp_surface_measure(surface_.get(), &totals, balls_.data(), static_cast<uint32_t>(balls_.size()), nullptr),
            "hsp_surface_measure");
  return totals;
}

hsp_energy SmoothSurface::gradient_with(const double *sigma) {
  return energy_of(hsp_surface_get_gradient, surface_.get(), sigma, by_centre_, by_radius_, "hsp_surface_get_gradient");
}

hsp_energy SmoothSurface::gradient() {
  return gradient_with(nullptr);
}

hsp_energy SmoothSurface::weighted_gradient() {
  return gradient_with(weight_.data());
}

hsp_surface_counts SmoothSurface::counts() const {
  return read(hsp_surface_get_counts, surface_.get(), "hsp_surface_get_counts");
}

namespace {
constexpr double edge = 0.5;
}

Triangles::Triangles(const Boundary &boundary) : boundary_(&boundary) {
  hsp_mesh_limits limits{};
  expect_ok(hsp_mesh_limits_init(&limits, sizeof limits, boundary.get(), edge), "hsp_mesh_limits_init");
  mesh_.take(limits);
  compute();
}

void Triangles::compute() {
  mesh_.compute([this](hsp_mesh *handle, hsp_mesh_limits *wanted) {
    return hsp_mesh_compute(handle, boundary_->get(), edge, wanted);
  });
}

uint32_t Triangles::count() const {
  hsp_mesh_counts counts{};
  expect_ok(hsp_mesh_get_counts(mesh_.get(), &counts), "hsp_mesh_get_counts");
  return counts.triangles;
}

}  // namespace bench
