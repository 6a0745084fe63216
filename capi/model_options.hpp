// The options by which balls are read, for a model and for a periodic box.
#pragma once

#include "conversion.hpp"
#include "model/ball_set.hpp"
#include "versioned_struct.hpp"

namespace hsp::capi {

constexpr hsp_model_options default_model_options() {
  return {sizeof(hsp_model_options), 0, 0.0, 0.0, 0.0};
}

// It ended with `step` in version 0.1.
template <>
constexpr bool is_earlier_size<hsp_model_options>(uint32_t size) {
  return size == 24;
}

// The balls and how to read them. False if an array is missing or the options are not understood; they may be null.
inline bool get_input(uint32_t n, const double *xyz, const double *radius, const hsp_model_options *options,
                      BallInput &input) {
  if (n > 0 && (xyz == nullptr || radius == nullptr)) return false;
  if (options != nullptr) {
    hsp_model_options wanted;
    if (!read_struct(options, default_model_options(), wanted) || wanted.reserved != 0) return false;
    input.probe = wanted.probe;
    input.step = wanted.step;
    input.largest_radius = wanted.largest_radius;
  }
  input.n = n;
  input.xyz = xyz;
  input.radius = radius;
  return true;
}

}  // namespace hsp::capi
