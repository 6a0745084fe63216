#include "hsp_paths.hpp"

#include "cells_limits.hpp"
#include "conversion.hpp"
#include "handle_memory.hpp"
#include "model/queries.hpp"

using hsp::capi::check_handle;
using hsp::capi::check_results;
using hsp::capi::check_struct;
using hsp::capi::first_failure;

namespace {

static_assert(static_cast<uint32_t>(hsp::PathEnds::connected) == HSP_PATH_CONNECTED &&
              static_cast<uint32_t>(hsp::PathEnds::apart) == HSP_PATH_APART &&
              static_cast<uint32_t>(hsp::PathEnds::covered) == HSP_PATH_COVERED);

int32_t from_c(const hsp_paths_limits *given, hsp::PathLimits &result) {
  hsp_paths_limits limits;
  if (const int32_t status = hsp::capi::read_struct(given, {}, limits); status != HSP_OK) return status;
  if (limits.points > HSP_MAX_BALLS) return HSP_E_RANGE;
  result.points = limits.points;
  return hsp::capi::get_cells_limits(limits, result.cells);
}

int32_t from_c(const hsp_gate_limits *given, hsp::ProbeLimits &result) {
  hsp_gate_limits limits;
  if (const int32_t status = hsp::capi::read_struct(given, {}, limits); status != HSP_OK) return status;
  if (limits.balls > HSP_MAX_BALLS) return HSP_E_RANGE;
  result.balls = limits.balls;
  return hsp::capi::get_cells_limits(limits, result.cells);
}

hsp_paths_limits paths_to_c(const hsp::PathLimits &limits) {
  hsp_paths_limits result{};
  hsp::capi::put_cells_limits(limits.cells, result);
  result.points = limits.points;
  return result;
}

hsp_gate_limits gate_to_c(const hsp::ProbeLimits &limits) {
  hsp_gate_limits result{};
  hsp::capi::put_cells_limits(limits.cells, result);
  result.balls = limits.balls;
  return result;
}

// A point on the lattice of the balls.
int32_t round_point(const hsp::BallSet &balls, const double *xyz, hsp::exact::Vector &point) {
  hsp::LatticeQuery query;
  const hsp::Status status = hsp::round_query(balls, xyz, 0.0, query);
  if (status == hsp::Status::ok) point = query.centre;
  return hsp::capi::to_c(status);
}

}  // namespace

int32_t hsp_paths_limits_init(hsp_paths_limits *limits, uint32_t struct_size, uint32_t balls) {
  return hsp::capi::init_limits<hsp::PathLimits, paths_to_c>(limits, struct_size, balls);
}

int32_t hsp_paths_bytes(const hsp_paths_limits *limits, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  hsp::PathLimits wanted;
  if (const int32_t status = from_c(limits, wanted); status != HSP_OK) return status;
  return hsp::capi::get_bytes<hsp_paths>(wanted, bytes);
}

int32_t hsp_paths_init(void *memory, size_t bytes, const hsp_paths_limits *limits, hsp_paths **paths) {
  if (memory == nullptr || paths == nullptr) return HSP_E_ARGUMENT;
  hsp::PathLimits wanted;
  if (const int32_t status = from_c(limits, wanted); status != HSP_OK) return status;
  return hsp::capi::init(memory, bytes, wanted, paths);
}

int32_t hsp_paths_compute(hsp_paths *paths, const hsp_model *model, hsp_paths_limits *limits) {
  if (const int32_t status = check_handle(paths); status != HSP_OK) return status;
  paths->complete = false;
  if (const int32_t status = first_failure(check_handle(model), check_struct(limits)); status != HSP_OK) return status;
  const hsp::Status status = paths->builder.build(model->grid);
  paths->model.set(model);
  return hsp::capi::finish<paths_to_c>(*paths, status, limits);
}

int32_t hsp_paths_find(hsp_paths *paths, const double *from, const double *to, hsp_path *path,
                       hsp_paths_limits *limits) {
  if (const int32_t status = check_handle(paths); status != HSP_OK) return status;
  paths->builder.forget_path();
  if (from == nullptr || to == nullptr || path == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t refused = check_struct(limits); refused != HSP_OK) return refused;
  if (!paths->has_results()) return HSP_E_STATE;
  const hsp::BallSet &balls = paths->model->balls();
  hsp::exact::Vector start, end;
  int32_t status = round_point(balls, from, start);
  if (status == HSP_OK) status = round_point(balls, to, end);
  if (status != HSP_OK) return status;
  hsp::PathSummary found;
  status = hsp::capi::to_c(paths->builder.find(balls, start, end, found));
  if (limits != nullptr && (status == HSP_OK || status == HSP_E_CAPACITY)) {
    const hsp::PathLimits enough = status == HSP_OK ? paths->builder.needed() : paths->builder.retry_limits();
    hsp::capi::write_struct(paths_to_c(enough), limits, limits->struct_size);
  }
  if (status != HSP_OK) return status;
  *path = {balls.lattice.length(found.length), balls.lattice.length(found.clearance), static_cast<uint32_t>(found.ends),
           found.certified ? 1U : 0U,          paths->builder.points().size(),        0};
  return HSP_OK;
}

int32_t hsp_paths_get_points(const hsp_paths *paths, double *points, uint32_t capacity, uint32_t *needed) {
  const int32_t status = hsp::capi::check_request(
      paths, points, capacity, needed, [](const hsp_paths &handle) { return handle.builder.points().size(); });
  if (status != HSP_OK) return status;
  const hsp::Span<const hsp::exact::Vector> list = paths->builder.points();
  const hsp::exact::Lattice &lattice = paths->model->balls().lattice;
  for (uint32_t k = 0; k < list.size(); ++k) {
    const double point[3] = {lattice.length(static_cast<double>(list[k].x)),
                             lattice.length(static_cast<double>(list[k].y)),
                             lattice.length(static_cast<double>(list[k].z))};
    hsp::capi::put_vector(point, points, k);
  }
  return HSP_OK;
}

int32_t hsp_gate_limits_init(hsp_gate_limits *limits, uint32_t struct_size, uint32_t balls) {
  return hsp::capi::init_limits<hsp::ProbeLimits, gate_to_c>(limits, struct_size, balls);
}

int32_t hsp_gate_bytes(const hsp_gate_limits *limits, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  hsp::ProbeLimits wanted;
  if (const int32_t status = from_c(limits, wanted); status != HSP_OK) return status;
  return hsp::capi::get_bytes<hsp_gate>(wanted, bytes);
}

int32_t hsp_gate_init(void *memory, size_t bytes, const hsp_gate_limits *limits, hsp_gate **gate) {
  if (memory == nullptr || gate == nullptr) return HSP_E_ARGUMENT;
  hsp::ProbeLimits wanted;
  if (const int32_t status = from_c(limits, wanted); status != HSP_OK) return status;
  return hsp::capi::init(memory, bytes, wanted, gate);
}

int32_t hsp_gate_compute(hsp_gate *gate, const hsp_model *model, const double *from, const double *to,
                         hsp_gate_limits *limits) {
  if (const int32_t status = check_handle(gate); status != HSP_OK) return status;
  gate->complete = false;
  if (const int32_t status = first_failure(check_handle(model, from == nullptr), check_struct(limits));
      status != HSP_OK)
    return status;
  hsp::exact::Vector start, end;
  int32_t rounded = round_point(model->balls(), from, start);
  if (rounded == HSP_OK && to != nullptr) rounded = round_point(model->balls(), to, end);
  if (rounded != HSP_OK) return rounded;
  const hsp::Status status = gate->builder.find(model->balls(), start, to == nullptr ? nullptr : &end, gate->widest);
  gate->model.set(model);
  return hsp::capi::finish<gate_to_c>(*gate, status, limits);
}

int32_t hsp_gate_get(const hsp_gate *gate, hsp_widest_probe *widest) {
  if (const int32_t status = check_results(gate, widest == nullptr); status != HSP_OK) return status;
  const hsp::WidestProbe &found = gate->widest;
  *widest = {gate->model->balls().lattice.length(found.radius),
             found.passes ? 1U : 0U,
             {found.gate[0], found.gate[1], found.gate[2]},
             gate->builder.builds(),
             0};
  return HSP_OK;
}
