// The conversion of derivatives of areas and volume at the C interface.
#pragma once

#include "caller_executor.hpp"
#include "conversion.hpp"
#include "measure/energy.hpp"

namespace hsp::capi {

constexpr bool is_tangency(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP || tangency == HSP_TANGENT_DISJOINT;
}
constexpr TouchingBalls to_touching_balls(uint32_t tangency) {
  return tangency == HSP_TANGENT_OVERLAP ? TouchingBalls::meet : TouchingBalls::apart;
}

static_assert(one_sided_flag == HSP_GRADIENT_ONE_SIDED);

// Checks that arrays for balls have room for n entries, and that the weights are finite. wanted: whether there are
// arrays.
template <class Outputs>
int32_t check_outputs(uint32_t n, const double *sigma, bool are_finite, bool wanted, Outputs &outputs) {
  if (const int32_t status = check_weights(sigma, {0, n}, &outputs.first_bad); status != HSP_OK) return status;
  if (!are_finite) return HSP_E_NOT_FINITE;
  return fits(wanted, outputs.capacity, n, &outputs.needed) ? HSP_OK : HSP_E_CAPACITY;
}

// Reads the question to a handle and the struct of outputs. asked: holds the request, and reads it.
template <class Handle, class Asked, class Request, class Outputs>
int32_t read_parts(const Handle *handle, const Request *request, Asked &asked, const Outputs *outputs, Outputs &out) {
  if (const int32_t status = check_handle(handle); status != HSP_OK) return status;
  return versions_first(asked.read(request), read_struct(outputs, {}, out));
}

// The same for the results of a handle.
template <class Handle, class Asked, class Request, class Outputs>
int32_t read_question(const Handle *handle, const Request *request, Asked &asked, const Outputs *outputs,
                      Outputs &out) {
  const int32_t status = read_parts(handle, request, asked, outputs, out);
  return status == HSP_OK && !handle->has_results() ? HSP_E_STATE : status;
}

// A request that says how balls that touch count.
template <class Request>
struct TangentRequest {
  explicit TangentRequest(LibraryArithmetic &arithmetic) : executor(arithmetic) {}

  Request given{};
  Executor executor;

  int32_t read(const Request *request) {
    if (const int32_t status = read_request(request, given); status != HSP_OK) return status;
    if (const int32_t status = executor.read(given.executor); status != HSP_OK) return status;
    return is_tangency(given.tangency) ? HSP_OK : HSP_E_ARGUMENT;
  }
};
using DerivativesRequest = TangentRequest<hsp_derivatives_request>;

// The request for derivatives of an energy of areas and volume.
struct GradientRequest : TangentRequest<hsp_gradient_request> {
  using TangentRequest::TangentRequest;

  template <class Outputs>
  int32_t check(uint32_t n, bool wanted, Outputs &outputs) const {
    return check_outputs(n, given.sigma, factors_are_finite(), wanted, outputs);
  }
  bool are_finite(uint32_t n) const {
    return check_weights(given.sigma, {0, n}, nullptr) == HSP_OK && factors_are_finite();
  }
  bool factors_are_finite() const { return is_finite(given.tension) && is_finite(given.pressure); }
  EnergyTerms terms() const {
    return {{given.sigma, to_touching_balls(given.tangency)}, given.tension, given.pressure};
  }
};

// The caller's arrays for gradients; each may be null.
struct GradientArrays {
  double *d_centre, *d_radius;
  uint32_t *flags;
  double *area = nullptr;

  bool any() const { return d_centre != nullptr || d_radius != nullptr || flags != nullptr || area != nullptr; }
  void put(uint32_t i, const EnergyGradient &gradient, const exact::Lattice &lattice) const {
    if (area != nullptr) area[i] = lattice.area(gradient.area);
    put(i, gradient);
  }
  // Writes the same gradient for several balls; the caller clears their flags.
  void put(IdRange run, const EnergyGradient &gradient, const exact::Lattice &lattice) const {
    const double own_area = lattice.area(gradient.area);
    for (uint32_t i = run.first; area != nullptr && i < run.last; ++i) area[i] = own_area;
    for (uint32_t i = run.first; d_centre != nullptr && i < run.last; ++i) put_vector(gradient.centre, d_centre, i);
    for (uint32_t i = run.first; d_radius != nullptr && i < run.last; ++i) d_radius[i] = gradient.radius;
  }
  void put(uint32_t i, const EnergyGradient &gradient) const {
    put_vector(gradient.centre, d_centre, i);
    if (d_radius != nullptr) d_radius[i] = gradient.radius;
    if (flags != nullptr) flags[i] = gradient.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
  }
};

inline hsp_energy to_c(const Energy &energy) {
  return {energy.value, energy.area, energy.volume, energy.by_probe, {0, 0}};
}

}  // namespace hsp::capi
