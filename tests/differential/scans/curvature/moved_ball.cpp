#include "moved_ball.hpp"

#include <cmath>

#include "library_derivatives.hpp"

oracle::LatticeBall ball_of(double x, double y, double z, double radius) {
  const auto steps = [](double length) { return std::llround(steps_of_length * length); };
  return {steps(x), steps(y), steps(z), steps(radius)};
}

oracle::Balls MovedBall::at(double t, double grown) const {
  oracle::Balls result = balls;
  const auto steps = [](double length) { return std::llround(steps_of_length * length); };
  for (size_t i = 0; i < result.size(); ++i) result[i].radius += steps(grown * weights[i]);
  result[moving].x += steps(t * direction[0]);
  result[moving].y += steps(t * direction[1]);
  result[moving].z += steps(t * direction[2]);
  return result;
}

namespace {

// Those of tension S + pressure V, in steps; added to what is there.
void add(const MovedBall &moved, double t, double grown, double tension, double pressure, SlopeAndBend &sum) {
  const LibraryBoundary boundary(moved.at(t, grown));
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tension = tension * steps_of_length;
  request.pressure = pressure;
  request.sigma = moved.weights.data();
  const size_t n = moved.balls.size(), m = moved.moving;
  std::vector<double> by_centre(3 * n);
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = static_cast<uint32_t>(n);
  outputs.d_centre = by_centre.data();
  expect_ok(hsp_boundary_get_gradient(boundary.handle(), &request, &outputs), "hsp_boundary_get_gradient");
  std::vector<uint32_t> first(n + 1), ball(n * n);
  std::vector<double> block(9 * n * n);
  expect_ok(hsp_boundary_get_hessian_rows(boundary.handle(), &request, first.data(), ball.data(), block.data(), nullptr,
                                          static_cast<uint32_t>(n * n), nullptr),
            "hsp_boundary_get_hessian_rows");
  for (size_t p = 0; p < 3; ++p) {
    sum.slope += moved.direction[p] * by_centre[3 * m + p];
    for (size_t k = first[m]; k < first[m + 1]; ++k) {
      for (size_t q = 0; q < 3 && ball[k] == m; ++q)
        sum.bend += moved.direction[p] * block[9 * k + 3 * p + q] * moved.direction[q];
    }
  }
}

}  // namespace

SlopeAndBend derivatives(const MovedBall &moved, Quantity quantity, double t) {
  SlopeAndBend sum{0, 0};
  switch (quantity) {
    case Quantity::volume:
      add(moved, t, 0, 0, 1, sum);
      break;
    case Quantity::area:
      add(moved, t, 0, 1, 0, sum);
      break;
    case Quantity::mean:
      for (const double grown : {moved.window, -moved.window}) add(moved, t, grown, 0, 0.5 / grown, sum);
  }
  return {sum.slope / (steps_of_length * steps_of_length), sum.bend / steps_of_length};
}
