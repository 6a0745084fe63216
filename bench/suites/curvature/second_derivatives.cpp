#include "second_derivatives.hpp"

namespace bench {

SecondDerivatives::SecondDerivatives(const Boundary &boundary)
    : boundary_(&boundary),
      weight_(unequal_weights(boundary.model().size())),
      direction_(3 * size_t{boundary.model().size()}),
      product_(direction_.size()),
      first_(boundary.model().size() + 1) {
  for (size_t k = 0; k < direction_.size(); ++k) direction_[k] = static_cast<double>(k % 7) - 3;
  uint32_t entries = 0;
  hsp_boundary_get_hessian_rows(boundary.get(), nullptr, first_.data(), nullptr, nullptr, nullptr, 0, &entries);
  ball_.resize(entries);
  block_.resize(9 * size_t{entries});
}

hsp_gradient_request SecondDerivatives::asked(double tension, double pressure) const {
  hsp_gradient_request request{};
  expect_ok(hsp_gradient_request_init(&request, sizeof request), "hsp_gradient_request_init");
  request.sigma = weight_.data();
  request.tension = tension;
  request.pressure = pressure;
  return request;
}

void SecondDerivatives::find_rows(double tension, double pressure) {
  const hsp_gradient_request request = asked(tension, pressure);
  expect_ok(hsp_boundary_get_hessian_rows(boundary_->get(), &request, first_.data(), ball_.data(), block_.data(),
                                          nullptr, blocks(), nullptr),
            "hsp_boundary_get_hessian_rows");
}

void SecondDerivatives::find_rows_of_area() {
  find_rows(1, 0);
}

void SecondDerivatives::find_rows_of_volume() {
  find_rows(0, 1);
}

void SecondDerivatives::multiply() {
  const hsp_gradient_request request = asked(1, 0);
  expect_ok(hsp_boundary_get_hessian_product(boundary_->get(), &request, direction_.data(), product_.data(), nullptr,
                                             boundary_->model().size(), nullptr),
            "hsp_boundary_get_hessian_product");
}

}  // namespace bench
