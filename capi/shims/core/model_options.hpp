// The options for reading balls, of a model and of a periodic box.
#pragma once

#include "conversion.hpp"
#include "model/ball_set.hpp"
#include "versioned_struct.hpp"

namespace hsp::capi {

constexpr hsp_model_options default_model_options() {
  return {sizeof(hsp_model_options), 0, 0.0, 0.0, 0.0};
}

// In version 0.1 the struct ended with `step`.
template <>
inline constexpr uint32_t earlier_bytes<hsp_model_options> = 24;

// The balls and how to read them. The options may be null.
inline int32_t get_input(uint32_t n, const double *xyz, const double *radius, const hsp_model_options *options,
                         BallInput &input) {
  if (options != nullptr) {
    hsp_model_options wanted;
    if (const int32_t status = read_struct(options, default_model_options(), wanted); status != HSP_OK) return status;
    if (wanted.reserved != 0) return HSP_E_VERSION;
    input.probe = wanted.probe;
    input.step = wanted.step;
    input.largest_radius = wanted.largest_radius;
  }
  if (n > 0 && (xyz == nullptr || radius == nullptr)) return HSP_E_ARGUMENT;
  input.n = n;
  input.xyz = xyz;
  input.radius = radius;
  return HSP_OK;
}

}  // namespace hsp::capi
