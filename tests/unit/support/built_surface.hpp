// A smooth surface over any balls, in memory of its own.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"
#include "surface/surface_areas.hpp"
#include "surface/surface_builder.hpp"

class BuiltSurface {
 public:
  // Radii are without the probe; a step of 1 leaves whole numbers as they are, 0 lets the set choose.
  explicit BuiltSurface(const support::BallList &balls, double probe, double step = 1.0)
      : built_(balls, probe, step), status_(built_.status()) {
    if (status_ != hsp::Status::ok) return;
    const uint32_t n = balls.size();
    status_ = boundary_memory_.build(boundary_, hsp::BoundaryLimits{n, n, 8 * n, n, 0}, built_.grid());
    if (status_ != hsp::Status::ok) return;
    const hsp::Boundary &found = boundary();
    status_ = surface_memory_.build(surface_,
                                    hsp::default_limits(found.vertex_count(), found.face_count(), found.circle_count()),
                                    this->balls(), found);
  }

  // Builds the surface again, over these shells of the boundary alone.
  hsp::Status choose(const std::vector<uint32_t> &shells) {
    const hsp::Boundary &found = boundary();
    const hsp::Span<const uint32_t> chosen(shells.data(), static_cast<uint32_t>(shells.size()));
    status_ = surface_memory_.build(surface_,
                                    hsp::default_limits(found.vertex_count(), found.face_count(), found.circle_count()),
                                    balls(), found, hsp::Patience(), &chosen);
    return status_;
  }

  hsp::Status status() const { return status_; }
  const hsp::CubeGrid &grid() const { return built_.grid(); }
  const hsp::BallSet &balls() const { return grid().balls(); }
  const hsp::Boundary &boundary() const { return boundary_.boundary(); }
  const hsp::Surface &surface() const { return surface_.surface(); }
  hsp::SurfaceMeasure total() const {
    return hsp::measure_surface(grid(), boundary(), surface(), [](uint32_t, const hsp::SurfaceMeasure &) {});
  }

 private:
  BuiltGrid built_;
  CarvedMemory boundary_memory_;
  CarvedMemory surface_memory_;
  hsp::BoundaryBuilder boundary_;
  hsp::SurfaceBuilder surface_;
  hsp::Status status_;
};
