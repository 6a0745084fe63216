// Calls of the functions for parts and derivatives of areas with anything for arguments.
#pragma once

#include <loops.h>

#include <cmath>

#include "call_checks.hpp"

namespace fuzz {

// reader_status: the status of functions that read this boundary, HSP_OK if it has results.
inline void call_measure_parts(Bytes &bytes, const hsp_boundary *boundary, int32_t reader_status, uint32_t balls) {
  std::vector<uint8_t> selected(balls + 1);
  for (uint8_t &byte : selected) byte = bytes.byte();
  Output<double> area(bytes.below(30), null(bytes)), volume(area.capacity(), null(bytes));
  Output<hsp_totals> totals(1, null(bytes));
  const bool arrays = area.data() != nullptr || volume.data() != nullptr;
  int32_t status = hsp_boundary_measure(boundary, null(bytes) ? nullptr : selected.data(), totals.data(), area.data(),
                                        volume.data(), area.capacity(), nullptr);
  int32_t expected = reader_status;
  if (expected == HSP_OK && arrays && area.capacity() < balls) expected = HSP_E_CAPACITY;
  FUZZ_REQUIRE(status == expected, "hsp_boundary_measure, a selection");
  const uint32_t written = status == HSP_OK ? balls : 0;
  FUZZ_REQUIRE(area.untouched_from(area.data() == nullptr ? 0 : written), "area written where nothing belongs");
  FUZZ_REQUIRE(volume.untouched_from(volume.data() == nullptr ? 0 : written), "volume written where nothing belongs");
  FUZZ_REQUIRE(totals.untouched_from(status == HSP_OK && totals.data() != nullptr ? 1 : 0), "totals on failure");

  Output<double> own_area(bytes.below(30), null(bytes)), own_volume(own_area.capacity(), null(bytes));
  Output<hsp_totals> own_totals(1, null(bytes));
  loop own = loop_of(LOOP_SHUFFLED);
  const hsp_executor executor = executor_of(&own, bytes.below(4));
  hsp_measure_request request{};
  request.struct_size = sizeof request;
  request.selected = selected.data();
  request.executor = null(bytes) ? nullptr : &executor;
  hsp_measure_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = own_area.capacity();
  outputs.needed = 12345;
  outputs.totals = own_totals.data();
  outputs.area = own_area.data();
  outputs.volume_term = own_volume.data();
  const bool own_arrays = own_area.data() != nullptr || own_volume.data() != nullptr;
  status = hsp_boundary_get_measures(boundary, null(bytes) ? nullptr : &request, &outputs);
  expected = reader_status;
  if (expected == HSP_OK && own_arrays && own_area.capacity() < balls) expected = HSP_E_CAPACITY;
  FUZZ_REQUIRE(status == expected, "hsp_boundary_get_measures");
  FUZZ_REQUIRE(outputs.needed == (reader_status == HSP_OK ? balls : 12345), "what hsp_boundary_get_measures needs");
  const uint32_t own_written = status == HSP_OK ? balls : 0;
  FUZZ_REQUIRE(own_area.untouched_from(own_area.data() == nullptr ? 0 : own_written), "areas where nothing belongs");
  FUZZ_REQUIRE(own_volume.untouched_from(own_volume.data() == nullptr ? 0 : own_written),
               "volumes where nothing belongs");

  hsp_boundary_counts counts{};
  if (reader_status == HSP_OK) FUZZ_REQUIRE(hsp_boundary_get_counts(boundary, &counts) == HSP_OK, "counts");
  Output<double> face_area(bytes.below(50), null(bytes)), face_volume(face_area.capacity(), null(bytes));
  status = hsp_boundary_measure_faces(boundary, face_area.data(), face_volume.data(), face_area.capacity(), nullptr);
  expected = reader_status;
  const bool face_arrays = face_area.data() != nullptr || face_volume.data() != nullptr;
  if (expected == HSP_OK && face_arrays && face_area.capacity() < counts.faces) expected = HSP_E_CAPACITY;
  // without arrays there is nothing that the capacity could be too small for
  FUZZ_REQUIRE(status == expected || (!face_arrays && status == HSP_E_CAPACITY), "hsp_boundary_measure_faces");
  const uint32_t faces = status == HSP_OK ? counts.faces : 0;
  FUZZ_REQUIRE(face_area.untouched_from(face_area.data() == nullptr ? 0 : faces), "areas of faces");
  FUZZ_REQUIRE(face_volume.untouched_from(face_volume.data() == nullptr ? 0 : faces), "volumes of faces");
}

inline void call_gradient(Bytes &bytes, const hsp_boundary *boundary, int32_t reader_status, uint32_t balls) {
  const bool odd = bytes.one_in(3);
  std::vector<double> sigma(balls + 1);
  for (double &x : sigma) x = number(bytes, odd);
  const double tension = number(bytes, odd), pressure = number(bytes, odd);
  const uint32_t tangency = bytes.one_in(20) ? 2 + bytes.byte() : bytes.below(2);
  const bool no_sigma = null(bytes);
  bool finite_weights = true;
  for (uint32_t i = 0; i < balls && !no_sigma; ++i) finite_weights = finite_weights && std::isfinite(sigma[i]);
  const bool finite = finite_weights && std::isfinite(tension) && std::isfinite(pressure);
  const uint32_t capacity = bytes.below(30);
  Output<hsp_energy> energy(1, null(bytes));
  Output<double> centre(3 * capacity, null(bytes)), radius(capacity, null(bytes));
  Output<uint32_t> flags(capacity, null(bytes));
  const double *const weights = no_sigma ? nullptr : sigma.data();
  loop own = loop_of(LOOP_SHUFFLED);
  const hsp_executor executor = executor_of(&own, bytes.below(4));
  const hsp_executor *const workers = null(bytes) ? nullptr : &executor;
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tangency = tangency;
  request.tension = tension;
  request.pressure = pressure;
  request.sigma = weights;
  request.executor = workers;
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = capacity;
  outputs.needed = 12345;
  outputs.first_bad = 12345;
  outputs.energy = energy.data();
  outputs.d_centre = centre.data();
  outputs.d_radius = radius.data();
  outputs.flags = flags.data();
  const int32_t status = hsp_boundary_get_gradient(boundary, &request, &outputs);
  // The two parts of the gradient have the same arguments but for the factors, which are finite numbers there.
  Output<double> area_centre(3 * capacity, null(bytes)), area_radius(capacity, null(bytes));
  Output<double> volume_centre(3 * capacity, null(bytes)), volume_radius(capacity, null(bytes));
  hsp_derivatives_request parts_request{};
  parts_request.struct_size = sizeof parts_request;
  parts_request.tangency = tangency;
  parts_request.sigma = weights;
  parts_request.executor = workers;
  hsp_derivatives_outputs parts_outputs{};
  parts_outputs.struct_size = sizeof parts_outputs;
  parts_outputs.capacity = capacity;
  parts_outputs.needed = 12345;
  parts_outputs.first_bad = 12345;
  parts_outputs.area_centre = area_centre.data();
  parts_outputs.area_radius = area_radius.data();
  parts_outputs.volume_centre = volume_centre.data();
  parts_outputs.volume_radius = volume_radius.data();
  const int32_t parts_status = hsp_boundary_get_derivatives(boundary, &parts_request, &parts_outputs);
  const uint32_t first_bad = parts_outputs.first_bad;
  const bool parts = area_centre.data() != nullptr || area_radius.data() != nullptr ||
                     volume_centre.data() != nullptr || volume_radius.data() != nullptr;
  const int32_t parts_expected = boundary == nullptr || tangency > HSP_TANGENT_DISJOINT ? HSP_E_ARGUMENT
                                 : reader_status != HSP_OK                              ? reader_status
                                 : !finite_weights                                      ? HSP_E_NOT_FINITE
                                 : parts && capacity < balls                            ? HSP_E_CAPACITY
                                                                                        : HSP_OK;
  FUZZ_REQUIRE(parts_status == parts_expected, "hsp_boundary_get_derivatives");
  FUZZ_REQUIRE(parts_status != HSP_E_NOT_FINITE || (first_bad < balls && !std::isfinite(sigma[first_bad])),
               "first_bad");
  const uint32_t of_parts = parts_status == HSP_OK ? balls : 0;
  FUZZ_REQUIRE(area_centre.untouched_from(area_centre.data() == nullptr ? 0 : 3 * of_parts) &&
                   area_radius.untouched_from(area_radius.data() == nullptr ? 0 : of_parts) &&
                   volume_centre.untouched_from(volume_centre.data() == nullptr ? 0 : 3 * of_parts) &&
                   volume_radius.untouched_from(volume_radius.data() == nullptr ? 0 : of_parts),
               "derivatives written where nothing belongs");
  if (boundary == nullptr || tangency > HSP_TANGENT_DISJOINT) {
    FUZZ_REQUIRE(status == HSP_E_ARGUMENT, "hsp_boundary_get_gradient, arguments");
  } else if (reader_status != HSP_OK) {
    FUZZ_REQUIRE(status < 0, "hsp_boundary_get_gradient without results");
  } else {
    const bool arrays = centre.data() != nullptr || radius.data() != nullptr || flags.data() != nullptr;
    const bool too_small = arrays && capacity < balls;
    const bool good = status == HSP_OK           ? finite && !too_small
                      : status == HSP_E_CAPACITY ? too_small
                                                 : status == HSP_E_NOT_FINITE && !finite;
    FUZZ_REQUIRE(good, "hsp_boundary_get_gradient");
  }
  const uint32_t written = status == HSP_OK ? balls : 0;
  FUZZ_REQUIRE(energy.untouched_from(status == HSP_OK && energy.data() != nullptr ? 1 : 0), "energy on failure");
  FUZZ_REQUIRE(centre.untouched_from(centre.data() == nullptr ? 0 : 3 * written), "centre where nothing belongs");
  FUZZ_REQUIRE(radius.untouched_from(radius.data() == nullptr ? 0 : written), "radius where nothing belongs");
  FUZZ_REQUIRE(flags.untouched_from(flags.data() == nullptr ? 0 : written), "flags where nothing belongs");

  const uint32_t ball = bytes.below(30);
  const int32_t row_status = boundary == nullptr || tangency > HSP_TANGENT_DISJOINT ? HSP_E_ARGUMENT
                             : reader_status != HSP_OK                              ? reader_status
                             : ball >= balls                                        ? HSP_E_ID
                                                                                    : HSP_OK;
  check_array<hsp_area_derivative>(bytes, 24, row_status,
                                   [&](hsp_area_derivative *out, uint32_t room, uint32_t *needed) {
                                     return hsp_boundary_get_area_row(boundary, ball, tangency, out, room, needed);
                                   });
}

}  // namespace fuzz
