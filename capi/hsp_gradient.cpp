#include "conversion.hpp"
#include "core/sorting.hpp"
#include "core/summation.hpp"
#include "measure/gradients.hpp"
#include "measure/input_order.hpp"
#include "measure/tangency.hpp"

namespace {

bool is_tangency(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP || tangency == HSP_TANGENT_DISJOINT;
}
hsp::TouchingBalls to_touching_balls(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP ? hsp::TouchingBalls::meet : hsp::TouchingBalls::apart;
}

// The flags of balls inside others, of which the boundary holds nothing, and of what they touch.
void flag_inner_touching(const hsp_boundary &boundary, uint32_t *flags) {
  const hsp::CubeGrid &grid = boundary.model->grid;
  const hsp::BallSet &balls = grid.balls();
  const hsp::Boundary &structure = boundary.builder.boundary();
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (!structure.is_contained(i)) continue;
    hsp::visit_balls_touched_from_inside(grid, i, [&](uint32_t j) {
      // Of equal balls at most one has faces; if it has none, moving another of them bares nothing.
      if (balls.r[i] == balls.r[j] && !structure.is_exposed(j)) return;
      flags[balls.caller[i]] |= HSP_GRADIENT_ONE_SIDED;
      flags[balls.caller[j]] |= HSP_GRADIENT_ONE_SIDED;
    });
  }
}

}  // namespace

int32_t hsp_boundary_gradient(const hsp_boundary *boundary, const double *sigma, double tension, double pressure,
                              uint32_t tangency, hsp_energy *energy, double *centre, double *radius, uint32_t *flags,
                              uint32_t capacity) {
  if (boundary == nullptr || !is_tangency(tangency)) return HSP_E_ARGUMENT;
  if (!hsp::capi::has_results(*boundary)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const hsp::BallSet &balls = grid.balls();
  const uint32_t n = balls.n;
  if ((centre != nullptr || radius != nullptr || flags != nullptr) && capacity < n) return HSP_E_CAPACITY;
  if (!hsp::is_finite(tension) || !hsp::is_finite(pressure)) return HSP_E_NOT_FINITE;
  for (uint32_t i = 0; sigma != nullptr && i < n; ++i) {
    if (!hsp::is_finite(sigma[i])) return HSP_E_NOT_FINITE;
  }

  const hsp::Boundary &structure = boundary->builder.boundary();
  const hsp::AreaWeights weights{sigma, to_touching_balls(tangency)};
  hsp::TreeSum area_sum;
  hsp::TreeSum volume_sum;
  hsp::TreeSum radius_sum;
  hsp::visit_in_input_order(grid, structure, [&](uint32_t i, uint32_t place) {
    const hsp::BallGradient ball = hsp::gradient_of_ball(balls, structure, weights, place);
    // Tension and pressure times derivatives of an area and of a volume: a step may be any power of ten, so each is
    // converted on its own.
    const double by_radius =
        tension * balls.lattice.length(ball.radius) + pressure * balls.lattice.area(ball.measure.area);
    area_sum.add((sigma == nullptr ? 1.0 : sigma[i]) * ball.measure.area);
    volume_sum.add(ball.measure.volume);
    radius_sum.add(by_radius);
    if (centre != nullptr) {
      const double of_areas[3] = {ball.centre.x, ball.centre.y, ball.centre.z};
      const double of_volume[3] = {ball.vector_area.x, ball.vector_area.y, ball.vector_area.z};
      for (size_t axis = 0; axis < 3; ++axis) {
        centre[3 * static_cast<size_t>(i) + axis] =
            tension * balls.lattice.length(of_areas[axis]) + pressure * balls.lattice.area(of_volume[axis]);
      }
    }
    if (radius != nullptr) radius[i] = by_radius;
    if (flags != nullptr) flags[i] = ball.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
  });
  if (flags != nullptr) flag_inner_touching(*boundary, flags);
  if (energy != nullptr) {
    energy->area = balls.lattice.area(area_sum.total());
    energy->volume = balls.lattice.volume(volume_sum.total());
    energy->value = tension * energy->area + pressure * energy->volume;
    energy->probe = radius_sum.total();
  }
  return HSP_OK;
}

int32_t hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
                                  hsp_area_derivative *out, uint32_t capacity, uint32_t *needed) {
  if (boundary == nullptr || needed == nullptr || (out == nullptr && capacity > 0) || !is_tangency(tangency)) {
    return HSP_E_ARGUMENT;
  }
  if (!hsp::capi::has_results(*boundary)) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const hsp::BallSet &balls = grid.balls();
  if (ball >= balls.n) return HSP_E_ID;
  const hsp::Boundary &structure = boundary->builder.boundary();
  const uint32_t place = grid.grid_index(ball);
  const uint32_t length = hsp::area_row_length(structure, place);
  const int32_t status = hsp::capi::check_output(out, capacity, length, needed);
  if (status != HSP_OK || length == 0) return status;

  uint32_t written = 0;
  const auto add = [&](uint32_t other, const hsp::AreaDerivative &part) {
    uint32_t k = 0;
    while (k < written && out[k].ball != balls.caller[other]) ++k;
    if (k == written) out[written++] = {{0.0, 0.0, 0.0}, 0.0, 0.0, balls.caller[other], 0};
    out[k].centre[0] += balls.lattice.length(part.centre.x);
    out[k].centre[1] += balls.lattice.length(part.centre.y);
    out[k].centre[2] += balls.lattice.length(part.centre.z);
    out[k].radius += balls.lattice.length(part.radius);
    out[k].angle += part.angle;
    out[k].flags |= part.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
  };
  add(place, hsp::visit_area_row(balls, structure, place, to_touching_balls(tangency), add));
  hsp::sort_in_place(hsp::Span<hsp_area_derivative>(out, length),
                     [](const hsp_area_derivative &a, const hsp_area_derivative &b) { return a.ball < b.ball; });
  return HSP_OK;
}
