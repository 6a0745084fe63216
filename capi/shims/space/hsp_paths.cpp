#include "hsp_paths.hpp"

#include "compute_from.hpp"
#include "handle_memory.hpp"
#include "rounded_point.hpp"

using namespace hsp::capi;

namespace {

static_assert(static_cast<uint32_t>(hsp::PathEnds::connected) == HSP_PATH_CONNECTED &&
              static_cast<uint32_t>(hsp::PathEnds::apart) == HSP_PATH_APART &&
              static_cast<uint32_t>(hsp::PathEnds::covered) == HSP_PATH_COVERED);

int32_t find_path(hsp_paths *paths, const double *from, const double *to, const hsp_paths_request *request,
                  hsp_path *path, hsp_paths_limits *limits) {
  LibraryArithmetic arithmetic;
  hsp_paths_request asked;
  Executor executor(arithmetic);
  if (const int32_t status = check_handle(paths); status != HSP_OK) return status;
  paths->builder.forget_path();
  if (const int32_t refused = first_failure(check_struct(limits), read_request(request, asked, executor));
      refused != HSP_OK)
    return refused;
  if (from == nullptr || to == nullptr || path == nullptr) return HSP_E_ARGUMENT;
  if (!paths->has_results()) return HSP_E_STATE;
  const hsp::BallSet &balls = paths->model->balls();
  hsp::exact::Vector start, end;
  int32_t status = round_point(balls.lattice, from, start);
  if (status == HSP_OK) status = round_point(balls.lattice, to, end);
  if (status != HSP_OK) return status;
  hsp::PathSummary found;
  const hsp::Status searched = paths->builder.find(balls, start, end, found, hsp::Patience(&executor));
  hand_back_limits(*paths, searched, limits);
  if (searched != hsp::Status::ok) return to_c(searched);
  *path = {balls.lattice.length(found.length), balls.lattice.length(found.clearance), static_cast<uint32_t>(found.ends),
           found.certified ? 1U : 0U,          paths->builder.points().size(),        0};
  return HSP_OK;
}

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_paths);

int32_t hsp_paths_compute(hsp_paths *paths, const hsp_model *model, hsp_paths_limits *limits) {
  return hsp_paths_compute_with(paths, model, nullptr, limits);
}

int32_t hsp_paths_compute_with(hsp_paths *paths, const hsp_model *model, const hsp_paths_request *request,
                               hsp_paths_limits *limits) {
  return compute_from_model(paths, model, request, limits);
}

int32_t hsp_paths_find(hsp_paths *paths, const double *from, const double *to, hsp_path *path,
                       hsp_paths_limits *limits) {
  return find_path(paths, from, to, nullptr, path, limits);
}

int32_t hsp_paths_find_with(hsp_paths *paths, const double *from, const double *to, const hsp_paths_request *request,
                            hsp_path *path, hsp_paths_limits *limits) {
  return find_path(paths, from, to, request, path, limits);
}

int32_t hsp_paths_get_points(const hsp_paths *paths, double *points, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(paths, points, capacity, needed,
                                       [](const hsp_paths &handle) { return handle.builder.points().size(); });
  if (status != HSP_OK) return status;
  const hsp::Span<const hsp::exact::Vector> list = paths->builder.points();
  const hsp::exact::Lattice &lattice = paths->model->balls().lattice;
  for (uint32_t k = 0; k < list.size(); ++k) {
    const double point[3] = {lattice.length(static_cast<double>(list[k].x)),
                             lattice.length(static_cast<double>(list[k].y)),
                             lattice.length(static_cast<double>(list[k].z))};
    put_vector(point, points, k);
  }
  return HSP_OK;
}
