#include "hsp_view.hpp"
#include "hsp_boundary.hpp"
#include "view/view_rotation.hpp"
#include "view_options.hpp"

using namespace hsp::capi;

HSP_HANDLE_BY_BALLS(hsp_view);

int32_t hsp_view_options_init(hsp_view_options *options, uint32_t struct_size) {
  return write_struct(default_view_options(), options, struct_size);
}

int32_t hsp_view_options_turn(hsp_view_options *options, double x, double y, double z) {
  LibraryArithmetic arithmetic(x, y, z);
  if (options == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_struct(options); status != HSP_OK) return status;
  hsp::ViewDirection direction;
  const hsp::Status status = hsp::direction_of_rotation(x, y, z, direction);
  if (status != hsp::Status::ok) return to_c(status);
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
  Executor executor(arithmetic);
  if (const int32_t status =
          first_failure(check_handle(model), boundary == nullptr ? HSP_OK : check_handle(boundary),
                        versions_first(check_struct(limits), read_request(options, wanted, executor)));
      status != HSP_OK)
    return status;
  hsp::ViewRequest request;
  request.direction = direction_of(wanted);
  request.kind =
      wanted.pieces == HSP_PIECES_OUTSIDE_ALL ? hsp::PieceKind::outside_all : hsp::PieceKind::outside_farther;
  request.all_balls = (wanted.flags & HSP_VIEW_ALL_BALLS) != 0;
  if (boundary == nullptr && request.kind == hsp::PieceKind::outside_all) return HSP_E_ARGUMENT;
  if (!model->has_results() || (boundary != nullptr && !boundary->has_results())) return HSP_E_STATE;
  if (boundary != nullptr && !boundary->model.is(model)) return HSP_E_ARGUMENT;
  const hsp::Status status = view->builder.build(model->grid, boundary == nullptr ? nullptr : &boundary->structure(),
                                                 request, hsp::Patience(&executor));
  view->model.set(model);
  return finish(*view, status, limits);
}
