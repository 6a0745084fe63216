#include "hsp_surface.hpp"

#include "compute_from.hpp"
#include "gradient_arrays.hpp"
#include "measure/tangency.hpp"
#include "surface/degenerate_balls.hpp"
#include "surface/surface_gradients.hpp"

namespace hsp::capi {

static int32_t read_request(const hsp_surface_request *given, hsp_surface_request &request, Executor &executor) {
  const int32_t status = read_request(given, request);
  return status == HSP_OK ? executor.read(request.executor) : status;
}

}  // namespace hsp::capi

using namespace hsp::capi;

namespace {

static_assert(HSP_SURFACE_DEGENERATE == HSP_GRADIENT_ONE_SIDED);  // as GradientArrays writes it

hsp_surface_totals to_c(const hsp::SurfaceMeasure &measure) {
  return {measure.area(), measure.volume, measure.convex, measure.saddle, measure.concave};
}

// Sets HSP_SURFACE_DEGENERATE in cases that a ball's own faces do not show. Of equal balls all but one have no
// vertices. Balls that touch from inside are flagged, too: without a probe all of them, with a probe those of different
// weights, whose shares have a kink though the sum has none.
void flag_degenerate_balls(const hsp::CubeGrid &grid, const hsp::Boundary &boundary, const hsp::Surface &surface,
                           const hsp::AreaWeights &weights, bool any_tied, uint32_t *flags) {
  const hsp::BallSet &balls = grid.balls();
  const auto flag = [&](uint32_t ball) { flags[balls.caller[ball]] |= HSP_SURFACE_DEGENERATE; };
  hsp::visit_free_inner_contacts(grid, boundary, [&](uint32_t inner, uint32_t outer) {
    if (balls.probe_steps > 0 && balls.r[inner] != balls.r[outer] &&
        weights.of(balls, inner) == weights.of(balls, outer))
      return;
    flag(inner);
    flag(outer);
  });
  hsp::visit_degenerate_balls(grid, boundary, surface, any_tied, flag);
}

int32_t compute(hsp_surface *surface, const hsp_boundary *boundary, const hsp_surface_request *request,
                hsp_surface_limits *limits) {
  return compute_from(surface, boundary, request, limits, [&](const hsp_surface_request &asked, Executor &executor) {
    const hsp::Span<const uint32_t> chosen(asked.shells, asked.shells == nullptr ? 0 : asked.count);
    for (const uint32_t shell : chosen) {
      if (shell >= boundary->structure().shell_count()) return hsp::Status::id;
    }
    surface->boundary.set(boundary);
    return surface->builder.build(boundary->balls(), boundary->structure(), hsp::Patience(&executor),
                                  asked.shells == nullptr ? nullptr : &chosen);
  });
}

}  // namespace

int32_t hsp_surface_limits_init(hsp_surface_limits *limits, uint32_t struct_size, const hsp_boundary *boundary) {
  if (const int32_t status = first_failure(check_handle(boundary), check_struct(limits, struct_size)); status != HSP_OK)
    return status;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::Boundary &structure = boundary->structure();
  const hsp::SurfaceLimits enough =
      hsp::default_limits(structure.vertex_count(), structure.face_count(), structure.circle_count());
  return hsp_surface::Limits::write(enough, limits, struct_size);
}

HSP_HANDLE_MEMORY(hsp_surface);

int32_t hsp_surface_compute(hsp_surface *surface, const hsp_boundary *boundary, hsp_surface_limits *limits) {
  return compute(surface, boundary, nullptr, limits);
}

int32_t hsp_surface_compute_shells(hsp_surface *surface, const hsp_boundary *boundary, const uint32_t *shells,
                                   uint32_t count, hsp_surface_limits *limits) {
  const uint32_t none = 0;
  const hsp_surface_request request{sizeof request, count, nullptr, count == 0 ? &none : shells};
  const int32_t handles = first_failure(check_handle(surface), check_handle(boundary), check_struct(limits));
  if (handles == HSP_OK && request.shells == nullptr) {
    surface->complete = false;
    return HSP_E_ARGUMENT;
  }
  return compute(surface, boundary, &request, limits);
}

int32_t hsp_surface_compute_with(hsp_surface *surface, const hsp_boundary *boundary, const hsp_surface_request *request,
                                 hsp_surface_limits *limits) {
  return compute(surface, boundary, request, limits);
}

int32_t hsp_surface_get_counts(const hsp_surface *surface, hsp_surface_counts *counts) {
  if (const int32_t status = check_results(surface, counts == nullptr); status != HSP_OK) return status;
  const hsp::Boundary &boundary = surface->boundary->structure();
  const hsp::SurfaceCounts found = surface->builder.surface().counts();
  *counts = {boundary.face_count(),   boundary.arc_count() + boundary.circle_count(),
             boundary.vertex_count(), found.cusped_arcs,
             found.cut_patches,       0,
             found.rounded_patches,   0};
  return HSP_OK;
}

namespace {

int32_t measure(const hsp_surface *surface, const hsp_surface_measure_request *request, hsp_surface_totals *totals,
                hsp_surface_totals *balls, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  hsp_surface_measure_request asked;
  Executor executor(arithmetic);
  if (const int32_t status = read_for_results(surface, request, asked, executor); status != HSP_OK) return status;
  const hsp_boundary &boundary = *surface->boundary;
  const hsp::CubeGrid &grid = boundary.model->grid;
  if (!fits(balls != nullptr, capacity, grid.balls().n, needed)) return HSP_E_CAPACITY;
  const auto put = [balls](uint32_t i, const hsp::SurfaceMeasure &measure) {
    if (balls != nullptr) balls[i] = to_c(measure);
  };
  const hsp::SurfaceMeasure total =
      hsp::measure_surface(grid, boundary.structure(), surface->builder.surface(), put, executor);
  if (executor.is_stopped()) return HSP_E_STOPPED;
  if (totals != nullptr) *totals = to_c(total);
  return HSP_OK;
}

}  // namespace

int32_t hsp_surface_measure(const hsp_surface *surface, hsp_surface_totals *totals, hsp_surface_totals *balls,
                            uint32_t capacity, uint32_t *needed) {
  return measure(surface, nullptr, totals, balls, capacity, needed);
}

int32_t hsp_surface_measure_with(const hsp_surface *surface, const hsp_surface_measure_request *request,
                                 hsp_surface_totals *totals, hsp_surface_totals *balls, uint32_t capacity,
                                 uint32_t *needed) {
  return measure(surface, request, totals, balls, capacity, needed);
}

int32_t hsp_surface_get_gradient(const hsp_surface *surface, const hsp_gradient_request *request,
                                 hsp_gradient_outputs *outputs) {
  LibraryArithmetic arithmetic;
  GradientRequest asked(arithmetic);
  hsp_gradient_outputs out;
  if (const int32_t status = read_parts(surface, request, asked, outputs, out); status != HSP_OK) return status;
  if (asked.given.tangency != HSP_TANGENT_OVERLAP) return HSP_E_ARGUMENT;
  if (!surface->has_results()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = surface->boundary->model->grid;
  const uint32_t n = grid.balls().n;
  const GradientArrays arrays{out.d_centre, out.d_radius, out.flags, out.area};
  if (const int32_t status = asked.check(n, arrays.any(), *outputs); status != HSP_OK) return status;

  const hsp::Boundary &boundary = surface->boundary->structure();
  const hsp::Surface &smooth = surface->builder.surface();
  const hsp::EnergyTerms terms = asked.terms();
  const auto put = [&](uint32_t i, const hsp::EnergyGradient &gradient) {
    arrays.put(i, gradient, grid.balls().lattice);
  };
  hsp::Energy found;
  if (!hsp::differentiate_surface(asked.executor, grid, boundary, smooth, terms, found, put))
    return asked.executor.status();
  if (out.flags != nullptr) {
    bool any_degenerate = false;
    for (uint32_t i = 0; i < n; ++i) any_degenerate = any_degenerate || out.flags[i] != 0;
    flag_degenerate_balls(grid, boundary, smooth, terms.weights, any_degenerate, out.flags);
  }
  if (out.energy != nullptr) *out.energy = to_c(found);
  return HSP_OK;
}
