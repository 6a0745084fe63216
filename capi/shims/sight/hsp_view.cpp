#include "hsp_view.hpp"
#include "hsp_boundary.hpp"
#include "view/view_rotation.hpp"
#include "view_options.hpp"

using hsp::capi::check_handle;
using hsp::capi::check_results;
using hsp::capi::check_struct;
using hsp::capi::first_failure;
using hsp::capi::LibraryArithmetic;
using hsp::capi::versions_first;

int32_t hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls) {
  return hsp::capi::init_limits<hsp_view>(limits, struct_size, balls);
}

int32_t hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes) {
  return hsp::capi::get_bytes_by_limits<hsp_view>(limits, bytes);
}

int32_t hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view) {
  return hsp::capi::init_by_limits(memory, bytes, limits, view);
}

int32_t hsp_view_options_init(hsp_view_options *options, uint32_t struct_size) {
  return hsp::capi::write_struct(hsp::capi::default_view_options(), options, struct_size);
}

int32_t hsp_view_options_turn(hsp_view_options *options, double x, double y, double z) {
  LibraryArithmetic arithmetic(x, y, z);
  if (options == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_struct(options); status != HSP_OK) return status;
  hsp::ViewDirection direction;
  const hsp::Status status = hsp::direction_of_rotation(x, y, z, direction);
  if (status != hsp::Status::ok) return hsp::capi::to_c(status);
  for (int k = 0; k < 3; ++k) {
    options->towards[k] = direction.towards[k];
    options->up[k] = direction.up[k];
  }
  return HSP_OK;
}

int32_t hsp_view_compute(hsp_view *view, const hsp_model *model, const hsp_boundary *boundary,
                         const hsp_view_options *options, hsp_view_limits *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(view); status != HSP_OK) return status;
  view->complete = false;
  hsp_view_options wanted;
  hsp::capi::Executor executor(arithmetic);
  if (const int32_t status =
          first_failure(check_handle(model), boundary == nullptr ? HSP_OK : check_handle(boundary),
                        versions_first(check_struct(limits), hsp::capi::read_view_options(options, wanted, executor)));
      status != HSP_OK)
    return status;
  hsp::ViewRequest request;
  request.direction = hsp::capi::direction_of(wanted);
  request.kind =
      wanted.pieces == HSP_PIECES_OUTSIDE_ALL ? hsp::PieceKind::outside_all : hsp::PieceKind::outside_farther;
  request.all_balls = (wanted.flags & HSP_VIEW_ALL_BALLS) != 0;
  if (boundary == nullptr && request.kind == hsp::PieceKind::outside_all) return HSP_E_ARGUMENT;
  if (!model->has_results() || (boundary != nullptr && !boundary->has_results())) return HSP_E_STATE;
  if (boundary != nullptr && !boundary->model.is(model)) return HSP_E_ARGUMENT;
  const hsp::Status status = view->builder.build(model->grid, boundary == nullptr ? nullptr : &boundary->structure(),
                                                 request, hsp::Patience(&executor));
  view->model.set(model);
  return hsp::capi::finish(*view, status, limits);
}
