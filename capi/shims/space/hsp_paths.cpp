#include "hsp_paths.hpp"

#include "conversion.hpp"
#include "handle_memory.hpp"
#include "rounded_point.hpp"

using hsp::capi::check_handle;
using hsp::capi::check_results;
using hsp::capi::check_struct;
using hsp::capi::first_failure;
using hsp::capi::LibraryArithmetic;
using hsp::capi::round_point;

namespace {

static_assert(static_cast<uint32_t>(hsp::PathEnds::connected) == HSP_PATH_CONNECTED &&
              static_cast<uint32_t>(hsp::PathEnds::apart) == HSP_PATH_APART &&
              static_cast<uint32_t>(hsp::PathEnds::covered) == HSP_PATH_COVERED);

}  // namespace

int32_t hsp_paths_limits_init(hsp_paths_limits *limits, uint32_t struct_size, uint32_t balls) {
  return hsp::capi::init_limits<hsp_paths>(limits, struct_size, balls);
}

int32_t hsp_paths_bytes(const hsp_paths_limits *limits, size_t *bytes) {
  return hsp::capi::get_bytes_by_limits<hsp_paths>(limits, bytes);
}

int32_t hsp_paths_init(void *memory, size_t bytes, const hsp_paths_limits *limits, hsp_paths **paths) {
  return hsp::capi::init_by_limits(memory, bytes, limits, paths);
}

int32_t hsp_paths_compute(hsp_paths *paths, const hsp_model *model, hsp_paths_limits *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(paths); status != HSP_OK) return status;
  paths->complete = false;
  if (const int32_t status = first_failure(check_handle(model), check_struct(limits)); status != HSP_OK) return status;
  if (!model->has_results()) return HSP_E_STATE;
  const hsp::Status status = paths->builder.build(model->grid);
  paths->model.set(model);
  return hsp::capi::finish(*paths, status, limits);
}

int32_t hsp_paths_find(hsp_paths *paths, const double *from, const double *to, hsp_path *path,
                       hsp_paths_limits *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(paths); status != HSP_OK) return status;
  paths->builder.forget_path();
  if (const int32_t refused = check_struct(limits); refused != HSP_OK) return refused;
  if (from == nullptr || to == nullptr || path == nullptr) return HSP_E_ARGUMENT;
  if (!paths->has_results()) return HSP_E_STATE;
  const hsp::BallSet &balls = paths->model->balls();
  hsp::exact::Vector start, end;
  int32_t status = round_point(balls, from, start);
  if (status == HSP_OK) status = round_point(balls, to, end);
  if (status != HSP_OK) return status;
  hsp::PathSummary found;
  const hsp::Status searched = paths->builder.find(balls, start, end, found);
  hsp::capi::hand_back_limits(*paths, searched, limits);
  if (searched != hsp::Status::ok) return hsp::capi::to_c(searched);
  *path = {balls.lattice.length(found.length), balls.lattice.length(found.clearance), static_cast<uint32_t>(found.ends),
           found.certified ? 1U : 0U,          paths->builder.points().size(),        0};
  return HSP_OK;
}

int32_t hsp_paths_get_points(const hsp_paths *paths, double *points, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
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
  return hsp::capi::init_limits<hsp_gate>(limits, struct_size, balls);
}

int32_t hsp_gate_bytes(const hsp_gate_limits *limits, size_t *bytes) {
  return hsp::capi::get_bytes_by_limits<hsp_gate>(limits, bytes);
}

int32_t hsp_gate_init(void *memory, size_t bytes, const hsp_gate_limits *limits, hsp_gate **gate) {
  return hsp::capi::init_by_limits(memory, bytes, limits, gate);
}

int32_t hsp_gate_compute(hsp_gate *gate, const hsp_model *model, const double *from, const double *to,
                         hsp_gate_limits *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(gate); status != HSP_OK) return status;
  gate->complete = false;
  if (const int32_t status = first_failure(check_handle(model), check_struct(limits)); status != HSP_OK) return status;
  if (from == nullptr) return HSP_E_ARGUMENT;
  if (!model->has_results()) return HSP_E_STATE;
  hsp::exact::Vector start, end;
  int32_t rounded = round_point(model->balls(), from, start);
  if (rounded == HSP_OK && to != nullptr) rounded = round_point(model->balls(), to, end);
  if (rounded != HSP_OK) return rounded;
  const hsp::Status status = gate->builder.find(model->grid, start, to == nullptr ? nullptr : &end, gate->widest);
  gate->model.set(model);
  return hsp::capi::finish(*gate, status, limits);
}

int32_t hsp_gate_get_widest(const hsp_gate *gate, hsp_widest_probe *widest) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(gate, widest == nullptr); status != HSP_OK) return status;
  const hsp::WidestProbe &found = gate->widest;
  *widest = {gate->model->balls().lattice.length(found.radius),
             found.passes ? 1U : 0U,
             {found.gate[0], found.gate[1], found.gate[2]},
             gate->builder.builds(),
             0};
  return HSP_OK;
}
